#!/bin/bash
# A pipe from a surface mesh, 20 particles across: profile and flow rate
. "$(dirname "$0")/functions.sh"

copyCase pipeFlow across20
"$work/across20/Allrun" || exit 1
expect "relative L2" "$(relativeL2 across20 profileError 2.5)" "<=" 0.01
rate=$(awk '$1 == 2.5 { print $4 < 0 ? -$4 : $4 }' \
    "$work/across20/postProcessing/pipeRate/0/flowRate.dat")
expect "relative error of the flow rate" "$rate" "<=" 0.01
exit "$failures"
