#!/bin/bash
# A bar between two columns of fluid, from a tenth of the fluid's density to a
# thousand times: the first coupled frequency, and no growth
. "$(dirname "$0")/functions.sh"
. "$(dirname "$0")/coupled.sh"
. "$(dirname "$0")/immersedBarCase.sh"
export OMP_NUM_THREADS=1

bar 0.1 20 20
bar 1 20 20
bar 10 20 10
bar 1000 10 3
exit "$failures"
