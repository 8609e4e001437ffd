#!/bin/bash
# The driven cavity at Re 100 and 64^2 particles against Ghia's table
. "$(dirname "$0")/functions.sh"
export OMP_NUM_THREADS=1

copyCase lidDrivenCavity rows64
setEntry rows64/system/seedParticlesDict rows 64
setEntry rows64/system/controlDict deltaT 6.25e-4
setEntry rows64/system/controlDict endTime 15
(
    cd "$work/rows64" || exit 1
    . "$FSI_DIR/etc/tools/RunFunctions"
    runApplication seedParticles
    runApplication gpuFsiFoam
) || exit 1
expectGhia rows64 15
exit "$failures"
