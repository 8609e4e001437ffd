#!/bin/bash
# Speed of a wave in a straight elastic tube full of fluid
. "$(dirname "$0")/functions.sh"
export OMP_NUM_THREADS=1

copyCase elasticTube straight
setEntry straight/system/controlDict endTime 0.0186
setEntry straight/system/controlDict deltaT 3e-5
sed -i 's/^        enabled .*/        enabled no;/' \
    "$work/straight/system/controlDict"
(
    cd "$work/straight" || exit 1
    . "$FSI_DIR/etc/tools/RunFunctions"
    runApplication seedParticles -dict system/seedParticlesDict.straight
    runApplication gpuFsiFoam
) || exit 1

"$work/straight/Allspeed"
expect "error of the wave's speed" "$("$work/straight/Allspeed" | awk \
    '$1 == "flank" { print $4 < 0 ? -$4 : $4 }')" "<=" 0.05

# The works on the solid against what it has: kinetic, elastic, residual
expect "residual of the solid's ledger, of its energy" \
    "$(tail -n 1 "$work/straight/postProcessing/ledger/0/solidEnergy.dat" \
    | awk '{ r = $9/($2 + $3); print r < 0 ? -r : r }')" "<=" 0.01
exit "$failures"
