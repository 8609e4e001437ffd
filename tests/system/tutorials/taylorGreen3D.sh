#!/bin/bash
# The vortex at 24^3 until its dissipation starts to rise, beside the reference
. "$(dirname "$0")/functions.sh"

copyCase taylorGreen3D n24
setEntry n24/system/resolution n 24
setEntry n24/system/controlDict endTime 2.5
(
    cd "$work/n24" || exit 1
    . "$FSI_DIR/etc/tools/RunFunctions"
    runApplication seedParticles
    runApplication gpuFsiFoam
) || exit 1

budgets=$work/n24/postProcessing/budgets/0/budgets.dat
