#!/bin/bash
# The vortex as users run it, and its order of convergence. With LONG as
# fourth argument 128^2 particles instead, at Re 100 and Re 1000.
. "$(dirname "$0")/functions.sh"
export OMP_NUM_THREADS=1

# resolve CASE N
resolve()
{
    copyCase taylorGreen2D "$1"
    setEntry "$1/system/resolution" n "$2"
}

if [ "${4-}" = LONG ]
then
    for n in 32 128
    do
        resolve n$n $n
        error[$n]=$(solve n$n velocityError 0.5) || exit 1
    done
    echo "relative L2 at 32^2, 128^2: ${error[*]}"
    expect "order from 32^2 to 128^2" \
        "$(order "${error[32]}" "${error[128]}" 4)" ">=" 1.5

    resolve Re1000 128
    setEntry Re1000/constant/fluidProperties nu 0.001
    setEntry Re1000/system/particleSchemes dissipation 0.3
    setEntry Re1000/system/controlDict endTime 5
    solve Re1000 velocityError 5 || exit 1
    energy=$(tableValue Re1000/postProcessing/budgets/0/budgets.dat 5 10)
    expect "kinetic energy over the exact one at Re 1000, t = 5" \
        "$(ratio "$energy" 0.11351)" ">=" 0.97
    expect "the same" "$(ratio "$energy" 0.11351)" "<=" 1.03
    exit "$failures"
fi

copyCase taylorGreen2D asItIs
"$work/asItIs/Allrun" || exit 1
expect "relative L2 at 64^2" \
    "$(relativeL2 asItIs velocityError 0.5)" "<=" 0.0022
expect "least distance of two particles, h" \
    "$(tableValue asItIs/postProcessing/spacing/0/spacing.dat 0.5 2)" ">=" 0.5
resolve n32 32
coarse=$(solve n32 velocityError 0.5) || exit 1
expect "order from 32^2 to 64^2" \
    "$(order "$coarse" "$(relativeL2 asItIs velocityError 0.5)")" ">=" 1.5
exit "$failures"
