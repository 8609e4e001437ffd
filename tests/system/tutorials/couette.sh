#!/bin/bash
# Start-up under a moving plate, as users run it, and its order
. "$(dirname "$0")/functions.sh"

export OMP_NUM_THREADS=1
copyCase couette rows32
"$work/rows32/Allrun" || exit 1
fine=$(relativeL2 rows32 profileError 1)
expect "relative L2 at 32 rows" "$fine" "<=" 4e-4

copyCase couette rows16
setEntry rows16/system/seedParticlesDict rows 16
setEntry rows16/system/controlDict deltaT 0.001875
coarse=$(solve rows16 profileError 1) || exit 1
expect "order from 16 to 32 rows" "$(order "$coarse" "$fine")" ">=" 1.5
exit "$failures"
