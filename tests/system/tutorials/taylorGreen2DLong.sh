#!/bin/bash
# The vortex at 128^2: order of convergence at Re 100, energy at Re 1000
. "$(dirname "$0")/functions.sh"
export OMP_NUM_THREADS=1

for n in 32 128
do
    copyCase taylorGreen2D n$n
    setEntry n$n/system/resolution n $n
    error[$n]=$(solve n$n velocityError 0.5) || exit 1
done
expect "order from 32^2 to 128^2" \
    "$(order "${error[32]}" "${error[128]}" 4)" ">=" 1.5

copyCase taylorGreen2D Re1000
"$work/Re1000/Allrun-Re1000" || exit 1
energy=$(tableValue Re1000/postProcessing/budgets/0/budgets.dat 5 10)
exact=$(awk 'BEGIN { print exp(-16*atan2(0, -1)^2*0.001*5)/4 }')
energy=$(ratio "$energy" "$exact")
expect "kinetic energy over the exact one, Re 1000, t = 5" "$energy" ">=" 0.97
expect "kinetic energy over the exact one, Re 1000, t = 5" "$energy" "<=" 1.03
exit "$failures"
