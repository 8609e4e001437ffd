# For the tests of runs on many ranks; after tutorials/functions.sh.

export OMP_NUM_THREADS=1
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
export OMPI_MCA_rmaps_base_oversubscribe=1
export OMPI_MCA_hwloc_base_binding_policy=none
export OMPI_MCA_btl_base_warn_component_unused=0

scotch=hilbert
grep -q 'SCOTCH_LIBRARY:.*\.\(so\|a\)' "$FSI_BUILD/CMakeCache.txt" \
    && scotch=scotch

# shorten NAME STEPS EVERY: so many steps, written every so many
shorten()
{
    local control=$1/system/controlDict
    setEntry "$control" writeControl timeStep
    setEntry "$control" writeInterval "$3"
    setEntry "$control" stopAt endTime
    setEntry "$control" endTime "#eval{ ($2 - 0.1)*\$deltaT }"
    # endTime is found from deltaT
    sed -i '/^endTime /{h;d};/^deltaT /{G}' "$work/$control"
}

# decompose NAME RANKS METHOD [TEXT]: of the newest time
decompose()
{
    cat > "$work/$1/system/decomposeParDict" <<END
numberOfSubdomains $2;
method $3;
simpleCoeffs { n ($2 1 1); }
${4-}
END
    "$FSI_BUILD/bin/decomposeParticles" -case "$work/$1" -force -latestTime \
        > "$work/$1/log.decomposeParticles" 2>&1 \
        || { cat "$work/$1/log.decomposeParticles"; exit 1; }
}

# onRanks NAME RANKS: the exit code is the solver's
onRanks()
{
    timeout -k 5 300 mpirun -np "$2" "$FSI_BUILD/bin/gpuFsiFoam" -parallel \
        -case "$work/$1" > "$work/$1/log.ranks$2" 2>&1
}

reconstruct()
{
    "$FSI_BUILD/bin/reconstructParticles" -case "$work/$1" \
        > "$work/$1/log.reconstructParticles" 2>&1 \
        || { cat "$work/$1/log.reconstructParticles"; exit 1; }
}

# clean NAME: leaves time 0
clean()
{
    (
        cd "$work/$1" || exit 1
        rm -rf processor* postProcessing
        for time in [0-9]*
        do
            [ "$time" = 0 ] || rm -rf "$time"
        done
    )
}

# keep NAME AS: the times of a run, to compare with
keep()
{
    rm -rf "${work:?}/$2"
    mkdir -p "$work/$2"
    for time in "$work/$1"/[0-9]*
    do
        [ "$(basename "$time")" = 0 ] || mv "$time" "$work/$2"
    done
    [ ! -d "$work/$1/postProcessing" ] \
        || mv "$work/$1/postProcessing" "$work/$2"
}

# differences NAME AS: files that differ from those kept
differences()
{
    local time
    for time in "$work/$2"/[0-9]*
    do
        diff -rq "$time" "$work/$1/$(basename "$time")" 2>&1
    done | tee "$work/$1/differences" | wc -l
}
