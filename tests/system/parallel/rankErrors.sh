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
fails lostParticle 3 "not of one decomposition"

case3 localUpdate
sed -i 's/method .*cellSearch;/method localUpdate;/' \
    "$work/localUpdate/system/particleSchemes"
fails localUpdate 3 "localUpdate"

# No place to write one rank's folder: the last time stays, on all ranks
case3 noWrite
onRanks noWrite 3 || exit 1
rm -rf "$work/noWrite"/processor?/[0-9]*.*
name=$(awk '/^Time = / { print $3 }' "$work/noWrite/log.ranks3" | head -1)
touch "$work/noWrite/processor1/$name"
fails noWrite 3 "a file has that name"
expect "directories that have time $name" \
    "$(ls -d "$work/noWrite"/processor?/"$name"/uniform 2> /dev/null | wc -l)" \
    "==" 0

# A time written again, whose former folder one rank cannot put away: it stays
case3 overwrite
onRanks overwrite 3 || exit 1
name=$(awk '/^Time = / { print $3 }' "$work/overwrite/log.ranks3" | head -1)
touch "$work/overwrite/former"
for rank in 0 1 2
do
    cp "$work/overwrite/former" "$work/overwrite/processor$rank/$name"
done
setEntry overwrite/system/controlDict startFrom startTime
if [ "$(id -u)" = 0 ] && mount --bind "$work/overwrite/processor1/$name" \
    "$work/overwrite/processor1/$name" 2> /dev/null
then
    # A folder on which something is mounted cannot be renamed
    onRanks overwrite 3
    expect "a former time that stays: exit code" $? "==" 1
    umount "$work/overwrite/processor1/$name"
    expect "directories that still have time $name" \
        "$(ls "$work/overwrite"/processor?/"$name"/former | wc -l)" "==" 3
fi

# Clocks are the master's: all stop at the next write
case3 clock
setEntry clock/system/controlDict endTime 100
setEntry clock/system/controlDict writeControl clockTime
setEntry clock/system/controlDict writeInterval 1
setEntry clock/system/controlDict stopAt nextWrite
onRanks clock 3
expect "stopAt nextWrite by the clock: exit code" $? "==" 0

# A run that breaks down on one rank
case3 breaks
setEntry breaks/system/controlDict deltaT 0.05
echo "allowUnstable yes;" >> "$work/breaks/system/controlDict"
setEntry breaks/system/controlDict endTime 5
fails breaks 3 "broke down"

# One whose energy comes from nowhere: all ranks stop, finite
case3 driven
setEntry driven/system/controlDict deltaT 0.0002
setEntry driven/system/controlDict endTime 5
setEntry driven/system/controlDict writeInterval 100000
setEntry driven/system/particleSchemes timeScheme Euler
fails driven 3 "the fluid's kinetic energy is"

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
