#!/bin/bash
# The branching tube as it stands: speed in its straight part
. "$(dirname "$0")/functions.sh"
export OMP_NUM_THREADS=1

copyCase elasticTube branch
"$work/branch/Allrun" || exit 1
for what in flank crest
do
    expect "error of the $what's speed" "$("$work/branch/Allspeed" | awk \
        -v what=$what '$1 == what { print $4 < 0 ? -$4 : $4 }')" "<=" 0.05
done
isFile branch/postProcessing/gauge/0/deltaRho
exit "$failures"
