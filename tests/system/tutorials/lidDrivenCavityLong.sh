#!/bin/bash
# The driven cavity at Re 100 and 100^2 particles, as users run it
. "$(dirname "$0")/functions.sh"

copyCase lidDrivenCavity asItIs
"$work/asItIs/Allrun" || exit 1
expectGhia asItIs 20
exit "$failures"
