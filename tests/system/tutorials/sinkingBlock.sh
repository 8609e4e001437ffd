#!/bin/bash
# A block sinks to the bottom of a tank and rests there
. "$(dirname "$0")/functions.sh"
export OMP_NUM_THREADS=1

copyCase sinkingBlock case
"$work/case/Allrun" || exit 1

# carried FIELD: over the exact
carried()
{
    awk -v field="$1:" '$1 == field { print $4 }' \
        "$work/case/postProcessing/forces"
}

expect "error of the floor's force" \
    "$(relativeError "$(carried contactForce)" 1)" "<=" 0.01
expect "error of the fluid's lift" \
    "$(relativeError "$(carried force)" 1)" "<=" 0.01

# Place over the floor and speed in the end
table=$work/case/postProcessing/corners/0/displacement.dat
read -r height speed <<< "$(awk '!/^#/ { y = $3; u = $6 }
    END { print 0.25 + y, u < 0 ? -u : u }' "$table")"
expect "error of its height, over half a spacing" \
    "$(relativeError "$height" "$(awk 'BEGIN { print 0.5/24 }')")" "<=" 0.001
expect "speed at the end, m/s" "$speed" "<=" 1e-4

# Largest residual over the fluid's work on the block, both in the end
residual=$(awk '!/^#/ { r = $9 < 0 ? -$9 : $9; most = r > most ? r : most
    work = $8 < 0 ? -$8 : $8 } END { printf "%.3g", most/work }' \
    "$work/case/postProcessing/block/0/solidEnergy.dat")
expect "residual of the block's ledger, over the fluid's work" \
    "$residual" "<=" 1e-3
share=$(awk '!/^#/ { s = $19 } END { print s }' \
    "$work/case/postProcessing/ledger/0/energyLedger.dat")
expect "residual of all in the end, share of the energy exchanged" \
    "$share" "<=" 0.15
exit "$failures"
