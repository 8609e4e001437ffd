#!/bin/bash
# Displacement of a ring under internal pressure against Lame, and its order
. "$(dirname "$0")/functions.sh"
export OMP_NUM_THREADS=1

for across in 8 16 32
do
    copyCase thickRing across$across
    setEntry across$across/system/seedParticlesDict across $across
    "$work/across$across/Allrun" || exit 1
    error[across]=$(awk '{ print $3 }' \
        "$work/across$across/postProcessing/error")
done
command -v gnuplot > /dev/null && isFile across32/postProcessing/radial.png
expect "relative L2 at 32 cells across" "${error[32]}" "<=" 0.01
expect "order from 8 to 32 cells" \
    "$(order "${error[8]}" "${error[32]}" 4)" ">=" 0.8
exit "$failures"
