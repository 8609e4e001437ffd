#!/bin/bash
# The quick maps of the page of extreme cases: no run ends as none may, and the
# boundaries are those of its README. `long` as fourth argument: all of them.
. "$(dirname "$0")/functions.sh"

rm -rf "$work"
mkdir -p "$work"
cp -r "$tutorials"/stability/* "$work"
(cd "$work" && FSI_DIR=$FSI_DIR ./Allclean > log.clean)

# map CASE [SUFFIX]
map()
{
    "$FSI_BUILD/bin/stabilityMap" -case "$work/$1" \
        -dict "system/stabilityDict${2:+.$2}" > "$work/log.$1.$2" 2>&1
    expect "$1 ${2-}: exit code" $? "==" 0
    table=$work/$1/studyStability${2:+.$2}/stabilityMap.md
}

# row TEXT: how many rows of the last map hold it
row()
{
    grep -c "$1" "$table"
}

map stretch
expect "turned over without a word" "$(row inaccurate)" "==" 0
expect "springs alone" \
    "$(row '^| 0.25 .*stopped to 0.3; accurate from 0.5 |')" "==" 1
map column courant
expect "symplectic Euler" \
    "$(row '^| symplectic |.*accurate to 2; stopped from 2.1 |')" "==" 1
expect "RK2" "$(row '^| RK2 |.*accurate to 0.5; stopped from 0.8 |')" "==" 1
map vortex arrangement
expect "pairs" "$(row '^| \(shifting\|hermite\).*accurate to pair')" "==" 4
map bar spacing
expect "coarse and fine cells, damped" "$(row '| accurate |$')" ">=" 4
map box
expect "at rest" "$(row '| accurate |$')" "==" 4

if [ "${4-}" = long ]
then
    map column length
    expect "single as double, 10,000 spacings" "$(row '| accurate |$')" "==" 4
    map pulse
    expect "amplitudes, single and double" \
        "$(row '^| hermite, .*| accurate |$')" "==" 2
    map shapes
    map shock
    expect "spread over 8 spacings" "$(row '^| 8 |.*| accurate |$')" ">=" 2
    map bar thin
    map bar ratio
    map vortex displaced
    expect "displaced by up to half a spacing" \
        "$(row '^| hermite, 0.1 |.*| accurate |$')" "==" 1
    map vortex mach
    map box million
    map vortex million
fi
exit "$failures"
