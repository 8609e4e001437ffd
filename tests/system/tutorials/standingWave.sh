#!/bin/bash
# Frequency and decay of a wave between walls, and the frequency's order
. "$(dirname "$0")/functions.sh"
export OMP_NUM_THREADS=1

# Of column $2 of the last fit of case $1 against $3, relative
off()
{
    tail -n 1 "$work/$1/postProcessing/wave/0/waveFit.dat" \
        | awk -v n="$2" -v e="$3" '{ d = $n/e - 1; print d < 0 ? -d : d }'
}

copyCase standingWave asItIs
"$work/asItIs/Allrun" || exit 1
command -v gnuplot > /dev/null && isFile asItIs/postProcessing/gauge.png

for nu in 0.01 0.001
do
    decay=$(awk -v nu=$nu 'BEGIN { pi = atan2(0, -1); print nu*pi^2/2 }')
    omega=$(awk -v d="$decay" 'BEGIN { pi = atan2(0, -1)
        printf "%.8f", sqrt(pi^2 - d^2) }')
    for rows in 16 32 64
    do
        name=nu${nu}rows$rows
        copyCase standingWave $name
        setEntry $name/constant/fluidProperties nu $nu
        setEntry $name/system/seedParticlesDict rows $rows
        setEntry $name/system/controlDict deltaT \
            "$(awk -v n=$rows 'BEGIN { print 0.01*32/n }')"
        solve $name waveError 10 > /dev/null || exit 1
        error[rows]=$(off $name 3 "$omega")
        decayError[rows]=$(off $name 4 "$decay")
    done
    echo "nu = $nu: errors of frequency ${error[*]}, decay ${decayError[*]}"
    expect "error of the frequency at 32 rows" "${error[32]}" "<=" 0.01
    expect "order from 16 to 32 rows" \
        "$(order "${error[16]}" "${error[32]}")" ">=" 1.7
    expect "order from 32 to 64 rows" \
        "$(order "${error[32]}" "${error[64]}")" ">=" 1.7
    [ $nu = 0.01 ] && expect "error of the decay at 32 rows" \
        "${decayError[32]}" "<=" 0.05
done
exit "$failures"
