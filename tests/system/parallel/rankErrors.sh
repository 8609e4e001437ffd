#!/bin/bash
# What goes wrong on many ranks: one voice, exit code 1, never a hang
here=$(dirname "$0")
. "$here/../tutorials/functions.sh"
. "$here/ranks.sh"

# fails NAME RANKS TEXT: the run says so once and exits with 1
fails()
{
    local code
    onRanks "$1" "$2"
    code=$?
    expect "$1: exit code" $code "==" 1
    expect "$1: lines with '$3'" "$(grep -c "$3" "$work/$1/log.ranks$2")" \
        ">=" 1
    expect "$1: errors printed" \
        "$(grep -c 'FOAM FATAL' "$work/$1/log.ranks$2")" "==" 1
}

copyCase taylorGreen2D vortex
setEntry vortex/system/resolution n 32
shorten vortex 40 20
(cd "$work/vortex" && "$FSI_BUILD/bin/seedParticles") > /dev/null || exit 1

# case NAME: decomposed for three
case3()
{
    rm -rf "${work:?}/$1"
    cp -r "$work/vortex" "$work/$1"
    decompose "$1" 3 hilbert
}

case3 otherCount
fails otherCount 2 "decomposed for 3"

case3 missingDirectory
rm -rf "$work/missingDirectory/processor1"
fails missingDirectory 3 "processor1"

case3 missingField
rm "$work/missingField/processor2/0/lagrangian/fluid/U"
fails missingField 3 "U"

case3 badDictionary
setEntry badDictionary/system/particleSchemes areaWeights momentum
fails badDictionary 3 "momentum"

case3 lostParticle
cp "$work/lostParticle/processor0/0/lagrangian/fluid"/* \
    "$work/lostParticle/processor1/0/lagrangian/fluid"
onRanks lostParticle 3
expect "a rank's particles held twice: exit code" $? "==" 1

case3 localUpdate
sed -i 's/method .*cellSearch;/method localUpdate;/' \
    "$work/localUpdate/system/particleSchemes"
fails localUpdate 3 "localUpdate"

# No place to write one rank's folder: the last time stays, on all ranks
case3 noWrite
mkdir "$work/noWrite/processor1/elsewhere"
setEntry noWrite/system/controlDict writeInterval 20
touch "$work/noWrite/processor1/.0.0089286.partial"
onRanks noWrite 3
rm -rf "$work/noWrite"/processor?/[0-9]*.*
time=$(ls "$work/noWrite/processor0" | grep -v '^0$' | grep '^[0-9]' | head -1)
expect "times but the first, after all were taken away" "${#time}" "==" 0
name=$(awk '/^Time = / { print $3 }' "$work/noWrite/log.ranks3" | head -1)
touch "$work/noWrite/processor1/$name"
fails noWrite 3 "a file has that name"
expect "directories that have time $name" \
    "$(ls -d "$work/noWrite"/processor?/"$name"/uniform 2> /dev/null | wc -l)" \
    "==" 0

# A run that breaks down on one rank
case3 breaks
setEntry breaks/system/controlDict deltaT 0.05
setEntry breaks/system/controlDict endTime 5
fails breaks 3 "broke down"

# Times that not all have are not restarted from
case3 incomplete
onRanks incomplete 3 || exit 1
last=$(ls "$work/incomplete/processor0" | grep '^[0-9]' | sort -g | tail -1)
rm -rf "$work/incomplete/processor2/$last"
setEntry incomplete/system/controlDict startFrom latestTime
onRanks incomplete 3
expect "restart from the last complete time: exit code" $? "==" 0
expect "directories that have time $last again" \
    "$(ls -d "$work/incomplete"/processor?/"$last" | wc -l)" "==" 3
exit "$failures"
