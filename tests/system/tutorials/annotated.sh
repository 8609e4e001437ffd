#!/bin/bash
# The annotated dictionaries make a case together, and every key is read
. "$(dirname "$0")/functions.sh"

annotated=$FSI_DIR/etc/caseDicts/annotated
rm -rf "${work:?}/case"
mkdir -p "$work"/case/{system,constant}
cp "$annotated"/{controlDict,particleSchemes,seedParticlesDict} \
    "$work/case/system"
cp "$annotated"/{g,{fluid,wall,solid,coupling}Properties} \
    "$work/case/constant"
cd "$work/case" || exit 1
. "$FSI_DIR/etc/tools/RunFunctions"
runApplication seedParticles
runApplication gpuFsiFoam

warnings=$(grep -ci warning log.*)
grep -i -A 5 warning log.*
count=$(echo "$warnings" | awk -F: '{ n += $2 } END { print n }')
expect "number of warnings" "$count" "<=" 0
isFile case/0.02/lagrangian/fluid/rho
isFile case/0.02/lagrangian/solid/displacement
exit "$failures"
