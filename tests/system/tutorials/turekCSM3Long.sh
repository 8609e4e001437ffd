#!/bin/bash
# The beam of Turek and Hron swinging under its weight: range and frequency
. "$(dirname "$0")/functions.sh"

copyCase turekCSM3 asItIs
"$work/asItIs/Allrun" || exit 1
command -v gnuplot > /dev/null && isFile asItIs/postProcessing/tip.png
table=asItIs/postProcessing/tip/0/displacement.dat
read -r xMean xRange < <(swing $table 2)
read -r yMean yRange < <(swing $table 3)
expect "error of x, middle" "$(relativeError "$xMean" -14.305e-3)" "<=" 0.02
expect "error of x, range" "$(relativeError "$xRange" 14.305e-3)" "<=" 0.02
expect "error of y, middle" "$(relativeError "$yMean" -63.607e-3)" "<=" 0.02
expect "error of y, range" "$(relativeError "$yRange" 65.160e-3)" "<=" 0.02
expect "error of the frequency" \
    "$(relativeError "$(frequency $table 3 -0.0636)" 1.0995)" "<=" 0.02
exit "$failures"
