#!/bin/bash
# A fluid at rest under gravity stays so
. "$(dirname "$0")/functions.sh"

export OMP_NUM_THREADS=1
copyCase hydrostatic rows32
"$work/rows32/Allrun" || exit 1

# Of rho against its range 0.01 kg/m^3, then of the speed
column()
{
    awk -v c="$2" '$1 == 1 { print $c/'"$3"' }' \
        "$work/rows32/postProcessing/$1/0/error.dat"
}
expect "rms error of rho over its range" "$(column restError 3 0.01)" "<=" 1e-6
expect "rms spurious speed" "$(column spuriousSpeed 3 1)" "<=" 5.6e-7
exit "$failures"
