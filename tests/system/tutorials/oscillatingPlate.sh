#!/bin/bash
# Period of a clamped plate, its convergence, and its energy over 20 periods
. "$(dirname "$0")/functions.sh"
export OMP_NUM_THREADS=1

# periodError CASE: against Timoshenko's
periodError()
{
    frequency "$1/postProcessing/tip/0/displacement.dat" 3 \
        | awk '{ d = 1/$1/0.2565 - 1; print d < 0 ? -d : d }'
}

# Five periods for T
copyCase oscillatingPlate across8
setEntry across8/system/controlDict endTime 1.3
setEntry across8/system/controlDict writeInterval 1.3
runCase across8 || exit 1
error=$(periodError across8)
expect "error of the period, 8 cells across" "$error" "<=" 0.02

# Twenty for the energy
copyCase oscillatingPlate across4
setEntry across4/system/seedParticlesDict across 4
"$work/across4/Allrun" || exit 1
command -v gnuplot > /dev/null && isFile across4/postProcessing/tip.png
expect "error of the period, 4 over 8 cells across" \
    "$(ratio "$(periodError across4)" "$error")" ">=" 2

energy=$work/across4/postProcessing/ledger/0/solidEnergy.dat
most=$(awk '!/^#/ { e = $2 + $3; first = NR == 2 ? e : first
    most = e > most ? e : most } END { printf "%.7f", most/first - 1 }' \
    "$energy")
expect "largest gain of energy in 20 periods" "$most" "<=" 1e-3

# Of the second ten periods over the first ten
gain=$(awk '!/^#/ { half = $1 < 2.6 ? 1 : 2; sum[half] += $2 + $3; ++n[half] }
    END { printf "%.7f", sum[2]/n[2]/(sum[1]/n[1]) }' "$energy")
expect "mean energy, second ten periods over first" "$gain" "<=" 1.00001

speed=$(awk '!/^#/ { v = $6 < 0 ? -$6 : $6; most = v > most ? v : most }
    END { print most/57 }' \
    "$work/across8/postProcessing/tip/0/displacement.dat")
expect "speed of the tip over c0" "$speed" "<=" 0.002
exit "$failures"
