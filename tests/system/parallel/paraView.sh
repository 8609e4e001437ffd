#!/bin/bash
# A decomposed case, some of its ranks empty, as ParaView reads it: the case
# itself, and the pieces that particlesToVTK writes
. "$(dirname "$0")/../tutorials/functions.sh"
export OMP_NUM_THREADS=1
copyCase taylorGreen2D vortex
setEntry vortex/system/resolution n 16
cat > "$work/vortex/system/decomposeParDict" <<END
numberOfSubdomains 30;
method hilbert;
END
for program in seedParticles decomposeParticles "particlesToVTK -decomposed"
do
    log=log.${program%% *}
    (cd "$work/vortex" && "$FSI_BUILD/bin/"$program > "$log" 2>&1) \
        || { cat "$work/vortex/$log"; exit 1; }
done
expect "rank 29's particles" "$(awk '$1 == 29 { print $2 }' \
    "$work/vortex/log.decomposeParticles")" "<=" 0

for python in python3 /usr/bin/python3
do
    seen=$($python "$(dirname "$0")/readDecomposed.py" \
        "$work/vortex/vortex.foam" \
        "$work/vortex/VTK/lagrangian/fluid/fluid_0.pvtp")
    status=$?
    [ $status = 77 ] || [ $status = 127 ] || break
done
if [ $status = 77 ] || [ $status = 127 ]
then
    echo "No VTK for python3: the rest is left out"
    exit "$failures"
fi
echo "$seen"
# 256 particles, whose ids sum to 255*128
expect "readings with all particles, each once" \
    "$(grep -c '^256 32640$' <<< "$seen")" ">=" 2
exit "$failures"
