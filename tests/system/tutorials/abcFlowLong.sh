#!/bin/bash
# No clumping until t = 10
. "$(dirname "$0")/functions.sh"

copyCase abcFlow n24
setEntry n24/system/resolution n 24
setEntry n24/system/controlDict endTime 10
setEntry n24/system/controlDict writeInterval 5
solve n24 velocityError 10 || exit 1
least=$(awk '!/^#/ && (!n++ || $2 < m) { m = $2 } END { print m }' \
    "$work/n24/postProcessing/spacing/0/spacing.dat")
expect "least distance of two particles until t = 10, h" "$least" ">=" 0.5
isFile n24/10/lagrangian/fluid/U
exit "$failures"
