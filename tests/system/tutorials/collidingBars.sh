#!/bin/bash
# Three bars that collide one after the other: times, speeds, energy
. "$(dirname "$0")/functions.sh"
export OMP_NUM_THREADS=1

# result CASE LINE COLUMN, of postProcessing/collisions
result()
{
    awk -v line="$2" -v column="$3" 'NR == line { print $column }' \
        "$work/$1/postProcessing/collisions"
}

for cells in 16 32 64
do
    copyCase collidingBars cells$cells
    cp "$tutorials/collidingBars/collisions.awk" "$work/cells$cells"
    setEntry cells$cells/system/seedParticlesDict cells $cells
    setEntry cells$cells/system/controlDict deltaT \
        "$(awk -v n=$cells 'BEGIN { print 0.008/n }')"
    "$work/cells$cells/Allrun" || exit 1
    expect "$cells cells: collisions and bars" \
        "$(wc -l < "$work/cells$cells/postProcessing/collisions")" "<=" 6
    for c in 1 2
    do
        expect "$cells cells: collision $c, error of its time over 2 L/c" \
            "$(relativeError "$(result cells$cells $c 5)" 1)" "<=" 0.035
    done
    fast[cells]=$(relativeError "$(result cells$cells 5 3)" 1)
    expect "$cells cells: speed left to the first bar" \
        "$(result cells$cells 3 3)" "<=" 0.015
    expect "$cells cells: speed left to the second bar" \
        "$(result cells$cells 4 3)" "<=" 0.015
done
command -v gnuplot > /dev/null && isFile cells32/postProcessing/ends.png

expect "64 cells: error of a collision's time" \
    "$(relativeError "$(result cells64 2 5)" 1)" "<=" 0.01
expect "16 cells: error of the last bar's speed" "${fast[16]}" "<=" 0.022
expect "64 cells: error of the last bar's speed" "${fast[64]}" "<=" 0.01
expect "16 cells: residual of the ledger" "$(result cells16 6 5)" "<=" 0.002
expect "64 cells: residual of the ledger" "$(result cells64 6 5)" "<=" 0.0005
exit "$failures"
