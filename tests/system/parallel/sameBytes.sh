#!/bin/bash
# One rank and many write the same bytes: a pulse, a vortex whose particles go
# from rank to rank, walls that move and slip, elastic solids
here=$(dirname "$0")
. "$here/../tutorials/functions.sh"
. "$here/ranks.sh"

# seedAndRun NAME: on one rank, without MPI; kept in NAME.one
seedAndRun()
{
    runCase "$1" || exit 1
    keep "$1" "$1.one"
}

# sameOn NAME RANKS METHOD [TEXT]
sameOn()
{
    clean "$1"
    decompose "$@"
    onRanks "$1" "$2" || { tail -20 "$work/$1/log.ranks$2"; exit 1; }
    reconstruct "$1"
    expect "$1, $2 ranks by $3 ${4-}: files that differ" \
        "$(differences "$1" "$1.one")" "<=" 0
}

every='balance { every yes; }'

copyCase acousticPulse pulse
setEntry pulse/system/seedParticlesDict spacing 1
shorten pulse 20 10
for precision in single double
do
    setEntry pulse/system/controlDict precision $precision
    seedAndRun pulse
    sameOn pulse 1 hilbert
    sameOn pulse 2 simple
    sameOn pulse 3 hilbert
    sameOn pulse 4 simple
    sameOn pulse 7 $scotch
done

# Two stages, each with messages of its own
copyCase acousticPulse midpoint
setEntry midpoint/system/seedParticlesDict spacing 1
setEntry midpoint/system/particleSchemes timeScheme RK2
shorten midpoint 20 10
seedAndRun midpoint
sameOn midpoint 3 hilbert
sameOn midpoint 4 simple

# A refresh, and with it a new decomposition, every 10 steps
copyCase taylorGreen2D vortex
setEntry vortex/system/resolution n 32
shorten vortex 120 60
setEntry vortex/system/controlDict precision single
seedAndRun vortex
sameOn vortex 1 hilbert
sameOn vortex 2 simple
sameOn vortex 3 hilbert "$every"
sameOn vortex 4 simple "$every"
sameOn vortex 7 $scotch "$every"
expect "vortex on 7 ranks: refreshes" \
    "$(awk '/^Neighbour refreshes/ { print $4 }' "$work/vortex/log.ranks7")" \
    ">=" 5

# A step that follows the flow
copyCase taylorGreen2D following
setEntry following/system/resolution n 32
shorten following 60 30
setEntry following/system/controlDict writeControl adjustableRunTime
setEntry following/system/controlDict writeInterval '#eval{ 30*$deltaT }'
echo "adjustTimeStep yes; maxCo 0.3;" >> "$work/following/system/controlDict"
seedAndRun following
sameOn following 3 hilbert "$every"

copyCase taylorCouette turning
shorten turning 60 30
seedAndRun turning
sameOn turning 3 hilbert "$every"
sameOn turning 4 simple

# Viscosity in super-steps beside walls that turn, walls that slip, a solid
copyCase taylorCouette stiff
shorten stiff 30 15
setEntry stiff/constant/fluidProperties mu 5
echo 'superTimeStepping on;' >> "$work/stiff/system/particleSchemes"
seedAndRun stiff
sameOn stiff 3 hilbert "$every"
sameOn stiff 4 simple
for case in cylinderModes springPiston
do
    copyCase $case stiff$case
    sed -i '/^    energy$/,/^    }/d' "$work/stiff$case/system/controlDict"
    shorten stiff$case 40 20
    setEntry stiff$case/constant/fluidProperties nu 0.5
    echo 'superTimeStepping on;' >> "$work/stiff$case/system/particleSchemes"
    seedAndRun stiff$case
    sameOn stiff$case 2 simple
    sameOn stiff$case 3 hilbert "$every"
done

copyCase springPiston piston
shorten piston 100 50
seedAndRun piston
sameOn piston 2 simple 'transport staged;'
sameOn piston 7 hilbert "$every"

copyCase elasticSquare square
setEntry square/system/resolution rows 16
shorten square 60 30
seedAndRun square
sameOn square 3 hilbert
sameOn square 4 simple "$every"

# A block that comes to rest on the floor of its tank
copyCase sinkingBlock block
setEntry block/system/seedParticlesDict rows 16
sed -i 's/min     (0.375 0.25 -1)/min     (0.375 0.0625 -1)/' \
    "$work/block/system/seedParticlesDict"
sed -i '/^    ledger/,/^    }/d' "$work/block/system/controlDict"
sed -i 's/friction    0.2;/& gap 0.055;/' \
    "$work/block/constant/solidProperties"
shorten block 600 300
seedAndRun block
expect "block: rows of its ledger with contact" \
    "$(awk '$13 > 0' "$work/block.one/postProcessing/block/0/solidEnergy.dat" |
        wc -l)" ">=" 2
sameOn block 2 simple
sameOn block 3 hilbert "$every"

# What function objects wrote, too
expect "tables of square that differ" \
    "$(diff -rq "$work/square/postProcessing" \
        "$work/square.one/postProcessing" | wc -l)" "<=" 0

# Four ranks as far as the middle, three from there on
clean square
decompose square 4 hilbert
middle=$(ls "$work/square.one" | grep '^[0-9]' | sort -g | head -1)
setEntry square/system/controlDict endTime '#eval{ 29.9*$deltaT }'
onRanks square 4 || exit 1
reconstruct square
setEntry square/system/controlDict startFrom latestTime
setEntry square/system/controlDict endTime '#eval{ 59.9*$deltaT }'
decompose square 3 simple
onRanks square 3 || exit 1
reconstruct square
expect "four ranks, then three from $middle: files that differ" \
    "$(differences square square.one)" "<=" 0
exit "$failures"
