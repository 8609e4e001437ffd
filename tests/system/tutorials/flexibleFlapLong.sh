#!/bin/bash
# The flap as users run it, and a higher resolution
. "$(dirname "$0")/functions.sh"
. "$(dirname "$0")/flexibleFlapCase.sh"

copyCase flexibleFlap asItIs
"$work/asItIs/Allrun" || exit 1
expectSwing asItIs 0.05
command -v particlesToVTK > /dev/null \
    && isFile asItIs/postProcessing/flow.png

copyCase flexibleFlap rows24
setRows rows24 24
runCase rows24 || exit 1
expectSwing rows24 0.05
expect "amplitude at 16 rows over that at 24" \
    "$(relativeError "$(swung asItIs amplitude)" \
    "$(swung rows24 amplitude)")" "<=" 0.08
exit "$failures"
