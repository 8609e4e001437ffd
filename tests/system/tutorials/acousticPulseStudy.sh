#!/bin/bash
# The studies of the pulse, once each: errors and orders of their README. Run
# times are for people: here they depend on what else the machine does.
. "$(dirname "$0")/functions.sh"

copyCase acousticPulse pulse
cp "$tutorials/acousticPulse/peers.csv" "$work/pulse"
sed -i 's/^resolution .*/&\nrepeats 1;/' "$work"/pulse/system/studyDict{,.grid}
# On grids finer than this the semi-Lagrangian scheme takes half a minute
sed -i '/^ *slow /a fine { h "15/96"; } finest { h "15/128"; }' \
    "$work/pulse/system/studyDict.grid"
"$work/pulse/Allstudy" || exit 1

# column DIRECTORY CURVE H NAME: of a study's table, curves in quotes
column()
{
    sed 's/"\([^",]*\),* *\([^",]*\),* *\([^",]*\)"/\1 \2 \3/' \
        "$work/pulse/$1/errorVsRunTime.csv" | awk -F, -v curve="$2" -v h="$3" \
        -v name="$4" '
        NR == 1 { for (i = 1; i <= NF; ++i) at[$i] = i }
        { sub(/ *$/, "", $1) }
        $1 == curve && $2 == h { print $at[name] }'
}

h=15/64
expect "error, radial" "$(column study 'radial Euler double' $h error)" \
    "<=" 0.0037
expect "order, radial" "$(column study 'radial Euler double' $h order)" \
    ">=" 1.8
expect "error, radial, second order in time" \
    "$(column study 'radial RK2 double' $h error)" "<=" 0.0033
expect "order, radial, second order in time" \
    "$(column study 'radial RK2 double' $h order)" ">=" 1.9
expect "error, moment, second order in time" \
    "$(column study 'moment RK2 double' $h error)" "<=" 0.0032
expect "error, Hermite" "$(column study 'Hermite RK2 double' $h error)" \
    "<=" 0.0001
expect "order, Hermite" "$(column study 'Hermite RK2 double' $h order)" \
    ">=" 3.6
expect "error, Hermite, single" \
    "$(column study 'Hermite RK2 single' $h error)" "<=" 0.0001
expect "error, radial off the lattice: it fails" \
    "$(column study 'radial displaced double' $h error)" ">=" 0.05
expect "error, moment off the lattice" \
    "$(column study 'moment displaced double' $h error)" "<=" 0.0045
expect "error, Hermite off the lattice" \
    "$(column study 'Hermite displaced double' $h error)" "<=" 0.002
for scheme in semiLagrangian finiteDifferences
do
    expect "order, $scheme" "$(column studyGrid $scheme $h order)" ">=" 1.9
done
exit "$failures"
