#!/bin/bash
# Displacement of a ring under internal pressure against Lame at 64 cells
# across: also that of its surfaces
. "$(dirname "$0")/functions.sh"
export OMP_NUM_THREADS=1

copyCase thickRing across64
setEntry across64/system/seedParticlesDict across 64
"$work/across64/Allrun" || exit 1
read -r l2 inner outer < <(awk '{ print $3, $5, $7 }' \
    "$work/across64/postProcessing/error")
expect "relative L2" "$l2" "<=" 0.01
expect "mean error of the inner surface" "${inner#-}" "<=" 0.01
expect "mean error of the outer surface" "${outer#-}" "<=" 0.01
exit "$failures"
