#!/bin/bash
# A flap in a channel that a body force swings: two periods, and a lower
# resolution
. "$(dirname "$0")/functions.sh"
. "$(dirname "$0")/flexibleFlapCase.sh"
export OMP_NUM_THREADS=1

for rows in 16 12
do
    copyCase flexibleFlap rows$rows
    setRows rows$rows "$rows"
    setEntry rows$rows/system/controlDict endTime 8
    runCase rows$rows || exit 1
done
expectSwing rows16 0.08
expect "amplitude at 12 rows over that at 16" \
    "$(relativeError "$(swung rows12 amplitude)" \
    "$(swung rows16 amplitude)")" "<=" 0.12
expect "lag at 12 rows less that at 16, degrees" \
    "$(awk -v a="$(swung rows12 lag)" -v b="$(swung rows16 lag)" \
    'BEGIN { d = a - b; print d < 0 ? -d : d }')" "<=" 10
exit "$failures"
