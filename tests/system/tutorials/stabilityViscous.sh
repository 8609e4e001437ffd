#!/bin/bash
# Viscosity far beyond the explicit limit: stable, as accurate, and cheaper
. "$(dirname "$0")/functions.sh"

copyCase stability/viscous short
"$work/short/Allrun" -short || exit 1
table=$work/short/postProcessing/viscous.dat

# entry SCHEME SUPER NUMBER COLUMN
entry()
{
    awk -v a="$1" -v b="$2" -v n="$3" -v c="$4" \
        '$1 == a && $2 == b && $3 == n { print $c; exit }' "$table"
}

limit=$(awk '{ print $2 }' "$work/short/postProcessing/eulerLimit.dat")
expect "Euler's limit over 0.5, less 1" "$(relativeError "$limit" 0.5)" \
    "<=" 0.05
plain=$(entry RK2 off 0.4 4)
expect "error of RK2 at 0.4" "$plain" "<=" 2.2e-5
for number in 1 10 100
do
    expect "error of RKL2 at $number over it" \
        "$(ratio "$(entry RK2 on $number 4)" "$plain")" "<=" 1.5
done
expect "seconds of RKL2 at 100 over those of RK2 at 0.4" \
    "$(ratio "$(entry RK2 on 100 5)" "$(entry RK2 off 0.4 5)")" "<=" 0.3
expect "auto is on at 100: error over it" \
    "$(ratio "$(entry RK2 auto 100 4)" "$(entry RK2 on 100 4)")" "<=" 1
"$work/short/Allclean" || exit 1
expect "number of files that Allclean left beside the tutorial's own" \
    "$(diff -rq "$tutorials/stability/viscous" "$work/short" \
        | grep -c "^Only in $work")" "<=" 0
expect "files that it did not put back" \
    "$(diff -rq "$tutorials/stability/viscous" "$work/short" \
        | grep -c "differ$")" "<=" 0
exit "$failures"
