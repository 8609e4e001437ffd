#!/bin/bash
# The surface mesh leads to the same error as the shape
. "$(dirname "$0")/functions.sh"

copyCase acousticPulseSTL asItIs
"$work/asItIs/Allrun" || exit 1
expect "relative L2 at h = 15/64, dt = 0.02" \
    "$(relativeL2 asItIs pulseError 1.2)" "<=" 0.0035
exit "$failures"
