#!/bin/bash
# A channel that a body force swings, as users run it, and its order
. "$(dirname "$0")/functions.sh"

# meanL2 CASE: over the rows from t = 1 s to 2 s, m/s
meanL2()
{
    awk '!/^#/ && $1 >= 1 && $1 < 2 { sum += $3; ++n }
        END { if (n != 8) print "rows: " n; else print sum/n }' \
        "$work/$1/postProcessing/profileError/0/error.dat"
}

export OMP_NUM_THREADS=1
copyCase womersley rows32
"$work/rows32/Allrun" || exit 1
expect "relative L2 at 32 rows, 1.75 s" \
    "$(relativeL2 rows32 profileError 1.75)" "<=" 1e-3
fine=$(meanL2 rows32)
expect "mean L2 at 32 rows, m/s" "$fine" "<=" 1e-3

# A force that varies has no potential, but its work
table=$work/rows32/postProcessing/budgets/0/budgets.dat
expect "potential energy" "$(tail -n 1 "$table" | cut -f 12)" "<=" 0
expect "error of the work, exactly 0.66872 J at 1.9963 s" \
    "$(relativeError "$(tail -n 1 "$table" | cut -f 22)" 0.66872)" "<=" 0.04

copyCase womersley rows16
setEntry rows16/system/seedParticlesDict rows 16
setEntry rows16/system/controlDict deltaT 0.001875
solve rows16 profileError 2 > /dev/null || exit 1
expect "order from 16 to 32 rows" "$(order "$(meanL2 rows16)" "$fine")" ">=" 1.5
exit "$failures"
