#!/bin/bash
# The beam of Turek and Hron swinging under its weight, two periods of eleven,
# 8 cells across: all but the range of y, which takes longer to show
. "$(dirname "$0")/functions.sh"
export OMP_NUM_THREADS=1

copyCase turekCSM3 across8
setEntry across8/system/controlDict endTime 2
runCase across8 || exit 1
table=across8/postProcessing/tip/0/displacement.dat
read -r xMean xRange < <(swing $table 2)
read -r yMean yRange < <(swing $table 3)
echo "x $xMean +- $xRange, y $yMean +- $yRange"
expect "error of x, middle" "$(relativeError "$xMean" -14.305e-3)" "<=" 0.02
expect "error of x, range" "$(relativeError "$xRange" 14.305e-3)" "<=" 0.02
expect "error of y, middle" "$(relativeError "$yMean" -63.607e-3)" "<=" 0.02
expect "error of the frequency" \
    "$(relativeError "$(frequency $table 3 -0.0636)" 1.0995)" "<=" 0.02

# Largest residual of the ledger over the largest elastic energy
residual=$(awk '!/^#/ { e = $9 < 0 ? -$9 : $9; most = e > most ? e : most
    elastic = $3 > elastic ? $3 : elastic } END { print most/elastic }' \
    "$work/across8/postProcessing/ledger/0/solidEnergy.dat")
expect "residual of the ledger" "$residual" "<=" 0.01
exit "$failures"
