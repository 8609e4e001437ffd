#!/bin/bash
# Times of a run on one rank, decomposed and reconstructed: the same bytes
. "$(dirname "$0")/../tutorials/functions.sh"
export OMP_NUM_THREADS=1

# vortex NAME, piston NAME, square NAME: short cases with three times
vortex()
{
    copyCase taylorGreen2D "$1"
    setEntry "$1/system/resolution" n 16
}

piston()
{
    rm -rf "${work:?}/$1"
    mkdir -p "$work/$1"
    cp -r "$FSI_DIR/tests/system/robustness/piston"/* "$work/$1"
}

square()
{
    copyCase elasticSquare "$1"
    setEntry "$1/system/resolution" rows 16
}

# shorten NAME FORMAT
shorten()
{
    setEntry "$1/system/controlDict" writeControl timeStep
    setEntry "$1/system/controlDict" writeInterval 10
    setEntry "$1/system/controlDict" stopAt endTime
    setEntry "$1/system/controlDict" endTime '#eval{ 19.9*$deltaT }'
    setEntry "$1/system/controlDict" writeFormat "$2"
    # endTime is found from deltaT
    sed -i '/^endTime /{h;d};/^deltaT /{G}' "$work/$1/system/controlDict"
}

# decompose NAME RANKS METHOD [TEXT]
decompose()
{
    cat > "$work/$1/system/decomposeParDict" <<END
numberOfSubdomains $2;
method $3;
${4-}
END
    "$FSI_BUILD/bin/decomposeParticles" -case "$work/$1" -force \
        -time 0: -blockDist > "$work/$1/log.decomposeParticles" 2>&1 \
        || { cat "$work/$1/log.decomposeParticles"; exit 1; }
}

# times NAME: names of the time folders
times()
{
    (cd "$work/$1" && ls -d [0-9]*)
}

# reconstruct NAME: into a case without times; tells how many files differ.
# seedParticles writes no uniform/ at time 0; as with all clouds, it comes along
reconstruct()
{
    local time differences
    mkdir -p "$work/$1/asItWas"
    for time in $(times "$1")
    do
        mv "$work/$1/$time" "$work/$1/asItWas"
    done
    "$FSI_BUILD/bin/reconstructParticles" -case "$work/$1" \
        > "$work/$1/log.reconstructParticles" 2>&1 \
        || cat "$work/$1/log.reconstructParticles" >&2
    differences=$(
        for time in $(cd "$work/$1/asItWas" && ls)
        do
            diff -rq "$work/$1/$time" "$work/$1/asItWas/$time" 2>&1
        done | grep -v "^Only in $work/$1/0: uniform$")
    for time in $(cd "$work/$1/asItWas" && ls)
    do
        rm -rf "${work:?}/$1/$time"
        mv "$work/$1/asItWas/$time" "$work/$1/$time"
    done
    [ -z "$differences" ] || echo "$differences" >&2
    printf '%s' "${differences:+$differences
}" | wc -l
}

# roundTrip NAME RANKS METHOD [TEXT]
roundTrip()
{
    decompose "$@"
    expect "$1, $2 ranks by $3: files that differ" "$(reconstruct "$1")" "<=" 0
}

scotch=hilbert
grep -q 'HAVE_SCOTCH\|SCOTCH_LIBRARY:.*\.so' "$FSI_BUILD/CMakeCache.txt" \
    && scotch=scotch
for format in binary ascii
do
    for case in vortex piston square
    do
        name=$case-$format
        $case "$name"
        shorten "$name" $format
        runCase "$name" || exit 1
        expect "$name: number of times" "$(times "$name" | wc -l)" ">=" 3
        roundTrip "$name" 1 hilbert
        roundTrip "$name" 2 simple 'simpleCoeffs { n (2 1 1); }'
        roundTrip "$name" 3 hilbert
        roundTrip "$name" 4 simple 'simpleCoeffs { n (2 2 1); }'
        roundTrip "$name" 4 manual 'manualCoeffs { dataFile
            "blockDecomposition"; }'
        roundTrip "$name" 7 $scotch
        roundTrip "$name" 40 hilbert
        isFile "$name/processor39/constant/polyMesh/faces"
    done
done

# Times that not every rank has are never put together
rm -rf "$work/vortex-binary/processor7/0"
expect "lines of diff where rank 7 lacks time 0" \
    "$(reconstruct vortex-binary 2> /dev/null)" ">=" 1
expect "warnings" "$(grep -c "Time 0 is left out: only 39 of 40" \
    "$work/vortex-binary/log.reconstructParticles")" ">=" 1
"$FSI_BUILD/bin/reconstructParticles" -newTimes -case "$work/vortex-binary" \
    > "$work/vortex-binary/log.newTimes" 2>&1
expect "lines that say that nothing is new" \
    "$(grep -c "There is no time to put together" \
        "$work/vortex-binary/log.newTimes")" ">=" 1
exit "$failures"
