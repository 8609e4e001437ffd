#!/bin/bash
# A rank that is killed at any moment, a write among them: all others stop, and
# every restart goes on from the last complete time, to the bytes of the run that
# nothing broke. faults.sh SOURCE WORK BUILD [KILLS]
here=$(dirname "$0")
. "$here/../tutorials/functions.sh"
. "$here/ranks.sh"
kills=${4:-6}
ranks=3

copyCase taylorGreen2D vortex
setEntry vortex/system/resolution n 32
shorten vortex 240 6
runCase vortex || exit 1
keep vortex vortex.one
clean vortex
setEntry vortex/system/controlDict startFrom latestTime

# Kills one rank after so many seconds; leaves the exit code in `code` and how
# long it took in `seconds`, which onRanks ends at 300
runAndKill()
{
    local begin=$SECONDS
    onRanks vortex $ranks &
    local run=$! victim
    sleep "$1"
    # A rank, not what started it
    local command="$FSI_BUILD/bin/gpuFsiFoam -parallel -case $work/vortex"
    victim=$(pgrep -f "^$command\$" | sed -n "$(($2 + 1))p")
    [ -z "$victim" ] || kill -9 "$victim" 2> /dev/null
    wait $run
    code=$?
    seconds=$((SECONDS - begin))
}

decompose vortex $ranks hilbert
RANDOM=4
hung=0
broken=0
n=0
while [ $n -lt "$kills" ]
do
    # Long enough to start, short enough not to end
    runAndKill "0.$((RANDOM % 900 + 100))" $((RANDOM % ranks))
    [ $seconds -ge 300 ] && hung=$((hung + 1))
    n=$((n + 1))
    if [ $code = 0 ]
    then
        # Ended before the kill: once more from the start
        reconstruct vortex
        [ "$(differences vortex vortex.one)" = 0 ] || broken=$((broken + 1))
        clean vortex
        decompose vortex $ranks hilbert
    fi
done
onRanks vortex $ranks || { tail -20 "$work/vortex/log.ranks$ranks"; exit 1; }
reconstruct vortex
expect "runs that hung" $hung "<=" 0
expect "runs between kills that ended otherwise" $broken "<=" 0
expect "after $kills kills: files that differ" \
    "$(differences vortex vortex.one)" "<=" 0
exit "$failures"
