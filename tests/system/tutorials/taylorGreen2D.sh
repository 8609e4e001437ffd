#!/bin/bash
# The vortex as users run it, and its order of convergence
. "$(dirname "$0")/functions.sh"
export OMP_NUM_THREADS=1

copyCase taylorGreen2D asItIs
"$work/asItIs/Allrun" || exit 1
fine=$(relativeL2 asItIs velocityError 0.5)
expect "relative L2 at 64^2" "$fine" "<=" 0.0022
expect "least distance of two particles, h" \
    "$(tableValue asItIs/postProcessing/spacing/0/spacing.dat 0.5 2)" ">=" 0.5

copyCase taylorGreen2D n32
setEntry n32/system/resolution n 32
coarse=$(solve n32 velocityError 0.5) || exit 1
expect "order from 32^2 to 64^2" "$(order "$coarse" "$fine")" ">=" 1.5

"$work/asItIs/Allclean" || exit 1
expect "number of files that Allclean left beside the tutorial's own" \
    "$(diff -rq "$tutorials/taylorGreen2D" "$work/asItIs" \
        | grep -c "^Only in $work")" "<=" 0
exit "$failures"
