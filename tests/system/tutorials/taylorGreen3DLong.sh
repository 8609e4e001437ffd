#!/bin/bash
# The peak of dissipation at 64^3 beside the same case at 128^3
. "$(dirname "$0")/functions.sh"

copyCase taylorGreen3D n64
setEntry n64/system/resolution n 64
setEntry n64/system/controlDict endTime 6
"$work/n64/Allrun" || exit 1
awk -f "$work/n64/system/dissipation.awk" \
    "$work/n64/constant/dissipation128.dat" \
    "$work/n64/postProcessing/budgets/0/budgets.dat" > "$work/n64/finest.dat"
worst=$(awk '$1 > 4.5 && $1 < 5.5 { d = $4 < 0 ? -$4 : $4; if (d > m) m = d; n++ }
    END { print n ? m : "none" }' "$work/n64/finest.dat")
expect "error of the dissipation rate at its peak" "$worst" "<=" 0.02
exit "$failures"
