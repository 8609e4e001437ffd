#!/bin/bash
# The inner of two cylinders turns, 20 particles across the gap
. "$(dirname "$0")/functions.sh"

copyCase taylorCouette across20
"$work/across20/Allrun" || exit 1
expect "relative L2" "$(relativeL2 across20 profileError 6)" "<=" 0.01
exit "$failures"
