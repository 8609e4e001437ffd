#!/bin/bash
# Finer and longer than immersedBar.sh: many periods of bars from a tenth of the
# fluid's density to a thousand times it
. "$(dirname "$0")/functions.sh"
. "$(dirname "$0")/coupled.sh"
. "$(dirname "$0")/immersedBarCase.sh"
export OMP_NUM_THREADS=1

for rho in 0.1 1 10 1000
do
    bar $rho 40 20
done
exit "$failures"
