#!/bin/bash
# The beam of Turek and Hron at rest under its weight: both components of its
# tip, 16 cells across
. "$(dirname "$0")/functions.sh"
export OMP_NUM_THREADS=1

copyCase turekCSM1 across16
"$work/across16/Allrun" || exit 1
command -v gnuplot > /dev/null && isFile across16/postProcessing/tip.png
table=across16/postProcessing/tip/0/displacement.dat
expect "error of the tip's x" \
    "$(relativeError "$(tableValue $table 1.6 2)" -7.187e-3)" "<=" 0.02
expect "error of the tip's y" \
    "$(relativeError "$(tableValue $table 1.6 3)" -66.10e-3)" "<=" 0.02
exit "$failures"
