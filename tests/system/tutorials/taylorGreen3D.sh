#!/bin/bash
# Kinetic energy at t = 3 at 16^3 and 24^3 beside the spectral solution
. "$(dirname "$0")/functions.sh"

# energyError N: of the kinetic energy of 1 kg at t = 3, J
energyError()
{
    copyCase taylorGreen3D "n$1"
    setEntry "n$1/system/resolution" n "$1"
    setEntry "n$1/system/controlDict" endTime 3
    (
        cd "$work/n$1" || exit 1
        . "$FSI_DIR/etc/tools/RunFunctions"
        runApplication seedParticles >&2
        runApplication gpuFsiFoam >&2
    ) || exit 1
    local budgets=n$1/postProcessing/budgets/0/budgets.dat
    local mass kinetic exact
    mass=$(tableValue "$budgets" 3 2)
    kinetic=$(tableValue "$budgets" 3 10)
    exact=$(tableValue "n$1/constant/dissipation.dat" 3 2)
    awk -v m="$mass" -v k="$kinetic" -v e="$exact" \
        'BEGIN { printf "%.6g\n", e - k/m }'
}

coarse=$(energyError 16) || exit 1
fine=$(energyError 24) || exit 1
expect "error of the kinetic energy at t = 3, 24^3, J" "$fine" "<=" 0.0115
expect "order from 16^3 to 24^3" "$(order "$coarse" "$fine" 1.5)" ">=" 1.5
expect "least distance of two particles at 24^3, h" \
    "$(tableValue n24/postProcessing/spacing/0/spacing.dat 3 2)" ">=" 0.5
exit "$failures"
