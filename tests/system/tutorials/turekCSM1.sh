#!/bin/bash
# The beam of Turek and Hron at rest under its weight, 8 cells across, and how
# the error falls
. "$(dirname "$0")/functions.sh"
export OMP_NUM_THREADS=1

for across in 4 8
do
    copyCase turekCSM1 across$across
    setEntry across$across/system/seedParticlesDict across $across
    runCase across$across || exit 1
    table=across$across/postProcessing/tip/0/displacement.dat
    error[across]=$(relativeError "$(tableValue $table 1.6 3)" -66.10e-3)
done
expect "error of the tip's y at 8 cells" "${error[8]}" "<=" 0.02
expect "order from 4 to 8 cells" \
    "$(order "${error[4]}" "${error[8]}")" ">=" 1.3
exit "$failures"
