#!/bin/bash
# Frequencies of three modes of a bar, their order, and its energy
. "$(dirname "$0")/functions.sh"
export OMP_NUM_THREADS=1

copyCase elasticBar cells32
"$work/cells32/Allrun" || exit 1
command -v gnuplot > /dev/null && isFile cells32/postProcessing/tips.png

for cells in 16 64
do
    copyCase elasticBar cells$cells
    setEntry cells$cells/system/seedParticlesDict cells $cells
    setEntry cells$cells/constant/solidProperties subSteps $((cells/16))
    runCase cells$cells || exit 1
done

for n in 1 2 3
do
    exact=$(awk -v n=$n 'BEGIN { printf "%.8f", (2*n - 1)*sqrt(1200)/4 }')
    for cells in 16 32 64
    do
        table=cells$cells/postProcessing/tips/0/displacement.dat
        f=$(frequency $table $((6*n - 4)))
        error[cells]=$(relativeError "$f" "$exact")
    done
    echo "mode $n: errors of frequency ${error[*]}"
    expect "error of mode $n at 32 cells" "${error[32]}" "<=" 0.005
    expect "order from 16 to 32 cells" \
        "$(order "${error[16]}" "${error[32]}")" ">=" 1.5
    expect "order from 32 to 64 cells" \
        "$(order "${error[32]}" "${error[64]}")" ">=" 1.5
done

# Largest residual of the ledger over the first energy
residual=$(awk '!/^#/ { e = $9 < 0 ? -$9 : $9; first = NR == 2 ? $2 : first
    most = e > most ? e : most } END { printf "%.3g", most/first }' \
    "$work/cells32/postProcessing/ledger/0/solidEnergy.dat")
expect "residual of the ledger at 32 cells" "$residual" "<=" 0.01
exit "$failures"
