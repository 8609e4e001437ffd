#!/bin/bash
# Start-up between plates under a body force, as users run it, and its order
. "$(dirname "$0")/functions.sh"

export OMP_NUM_THREADS=1
copyCase poiseuille rows32
"$work/rows32/Allrun" || exit 1
fine=$(relativeL2 rows32 profileError 2)
expect "relative L2 at 32 rows" "$fine" "<=" 1e-3

copyCase poiseuille rows16
setEntry rows16/system/seedParticlesDict rows 16
setEntry rows16/system/controlDict deltaT 0.001875
coarse=$(solve rows16 profileError 2) || exit 1
expect "order from 16 to 32 rows" "$(order "$coarse" "$fine")" ">=" 1
exit "$failures"
