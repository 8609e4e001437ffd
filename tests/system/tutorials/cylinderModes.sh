#!/bin/bash
# Frequencies of three modes of a disc of fluid, and their order
. "$(dirname "$0")/functions.sh"
export OMP_NUM_THREADS=1

copyCase cylinderModes rows32
"$work/rows32/Allrun" || exit 1
command -v gnuplot > /dev/null && isFile rows32/postProcessing/modes.png

for rows in 16 64
do
    copyCase cylinderModes rows$rows
    setEntry rows$rows/system/seedParticlesDict rows $rows
    setEntry rows$rows/system/controlDict deltaT \
        "$(awk -v n=$rows 'BEGIN { print 0.01*32/n }')"
    (
        cd "$work/rows$rows" || exit 1
        . "$FSI_DIR/etc/tools/RunFunctions"
        runApplication seedParticles
        runApplication gpuFsiFoam
    ) || exit 1
done

# m and omega = c j'/R
while read -r m omega
do
    for rows in 16 32 64
    do
        error[rows]=$(tail -n 1 \
            "$work/rows$rows/postProcessing/mode$m/0/waveFit.dat" \
            | awk -v e="$omega" '{ d = $3/e - 1; print d < 0 ? -d : d }')
    done
    echo "m = $m: errors of frequency ${error[*]}"
    expect "error of the frequency at 32 rows" "${error[32]}" "<=" 0.01
    expect "order from 16 to 32 rows" \
        "$(order "${error[16]}" "${error[32]}")" ">=" 1.7
    expect "order from 32 to 64 rows" \
        "$(order "${error[32]}" "${error[64]}")" ">=" 1.7
done << END
1 3.682368
2 6.108474
0 7.663412
END
exit "$failures"
