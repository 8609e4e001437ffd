#!/bin/bash
# The piston at 64 rows as users run it, and its order of convergence
. "$(dirname "$0")/functions.sh"

copyCase piston rows64
"$work/rows64/Allrun" || exit 1
error[64]=$(relativeL2 rows64 pistonError 1.2)
expect "relative L2 at 64 rows" "${error[64]}" "<=" 0.02

export OMP_NUM_THREADS=1
for rows in 16 32
do
    copyCase piston rows$rows
    setEntry rows$rows/system/seedParticlesDict rows $rows
    setEntry rows$rows/system/controlDict deltaT \
        "$(awk -v n=$rows 'BEGIN { print 0.00125*(64/n)^2 }')"
    error[$rows]=$(solve rows$rows pistonError 1.2) || exit 1
done
echo "relative L2 at 16, 32, 64 rows: ${error[*]}"
expect "order from 16 to 32 rows" \
    "$(order "${error[16]}" "${error[32]}")" ">=" 1
expect "order from 32 to 64 rows" \
    "$(order "${error[32]}" "${error[64]}")" ">=" 1
exit "$failures"
