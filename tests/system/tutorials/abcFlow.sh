#!/bin/bash
# The flow as users run it, and its order of convergence
. "$(dirname "$0")/functions.sh"

copyCase abcFlow asItIs
"$work/asItIs/Allrun" || exit 1
fine=$(relativeL2 asItIs velocityError 0.4)
expect "relative L2 at 32^3" "$fine" "<=" 0.003
expect "least distance of two particles, h" \
    "$(tableValue asItIs/postProcessing/spacing/0/spacing.dat 0.4 2)" ">=" 0.5

copyCase abcFlow n16
setEntry n16/system/resolution n 16
coarse=$(solve n16 velocityError 0.4) || exit 1
expect "order from 16^3 to 32^3" "$(order "$coarse" "$fine")" ">=" 1.5
exit "$failures"
