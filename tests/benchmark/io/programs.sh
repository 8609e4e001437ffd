#!/bin/bash
# What seedParticles and particlesToVTK take, time and memory:
# programs.sh BUILD DIRECTORY [POINTS [PARTICLES]]
# seedParticles: POINTS^3 (464: 100 million) lattice points around a sphere of
# 101,760 triangles; particlesToVTK: PARTICLES^3 (216: 10 million) in a periodic
# box. Needs GNU time; 6 GB of disk.
build=$(cd "$1" && pwd) || exit 1
out=$2
points=${3:-464}
particles=${4:-216}
command -v /usr/bin/time > /dev/null || { echo "no GNU time here"; exit 1; }
export PATH=$build/bin:$PATH
mkdir -p "$out" && cd "$out" || exit 1

# makeCase NAME SIDE PERIODIC REGIONS
makeCase()
{
    rm -rf "$1"
    mkdir -p "$1/system" "$1/constant/triSurface"
    local head='FoamFile { version 2.0; format ascii; class dictionary;'
    echo "$head object controlDict; }
        deltaT 1e-3; endTime 1; writeInterval 1; writeFormat binary;" \
        > "$1/system/controlDict"
    echo "$head object seedParticlesDict; }
        spacing $(awk "BEGIN { printf \"%.17g\", 2/$2 }");
        bounds ((-1 -1 -1) (1 1 1));
        periodic ($3 $3 $3);
        regions { $4 }
        fields { rho \"1 + 0.01*exp(-r^2/5)\"; }" \
        > "$1/system/seedParticlesDict"
}

# timed WHAT COMMAND...: a row of the table
timed()
{
    local what=$1
    shift
    /usr/bin/time -f '%e %U %S %M' -o time "$@" > log 2>&1 \
        || { cat log; exit 1; }
    awk -v what="$what" '{ printf "| %s | %.1f | %.1f | %.2f |\n",
        what, $1, $2 + $3, $4*1024/1e9 }' time
}

makeCase seeding "$points" no \
    'ball { type surface; file "constant/triSurface/sphere.stl"; }'
generateSurface -shape sphere -radius 1 -n 320 \
    -out seeding/constant/triSurface/sphere.stl > log 2>&1 \
    || { cat log; exit 1; }
makeCase pictures "$particles" yes ''

echo "| | wall, s | processor, s | peak memory, GB |"
echo "|---|---|---|---|"
timed "seedParticles, $points^3 points" seedParticles -case seeding
rm -rf seeding
seedParticles -case pictures > log 2>&1 \
    || { cat log; exit 1; }
for option in '' -float -compress '-image cut.png -field rho -cut z=0' \
    '-image space.png -field rho -view 3d'
do
    timed "particlesToVTK${option:+ $option}, $particles^3 particles" \
        particlesToVTK -case pictures $option
    rm -rf pictures/VTK
done
rm -rf pictures
