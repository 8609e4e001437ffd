# For the tests of tutorials of solids beside a fluid; after functions.sh

# Seeds and solves without pictures
run()
{
    (
        cd "$work/$1" || exit 1
        . "$FSI_DIR/etc/tools/RunFunctions"
        runApplication -o seedParticles >&2
        runApplication -o gpuFsiFoam >&2
    )
}

# off VALUE EXACT: relative, or as it stands where EXACT is 0
off()
{
    awk -v v="$1" -v e="$2" 'BEGIN {
        d = e == 0 ? v : v/e - 1
        printf "%.6g\n", d < 0 ? -d : d }'
}

# fitError CASE OMEGA: of the last fit of the function object wave
fitError()
{
    off "$(tail -n 1 "$work/$1/postProcessing/wave/0/waveFit.dat" \
        | awk '{ print $3 }')" "$2"
}

# Of the function object ledger's coupledTotal: last over first
energyLeft()
{
    awk '!/^#/ { if (!n++) first = $12; last = $12 }
        END { printf "%.6g\n", last/first }' \
        "$work/$1/postProcessing/ledger/0/solidEnergy.dat"
}

# Greatest over first
energyPeak()
{
    awk '!/^#/ { if (!n++) first = most = $12; if ($12 > most) most = $12 }
        END { printf "%.6g\n", most/first }' \
        "$work/$1/postProcessing/ledger/0/solidEnergy.dat"
}

# bisect F LOWER UPPER: root of the awk expression F of w between them
bisect()
{
    awk '
        function f(w) { return '"$1"' }
        BEGIN {
            a = '"$2"'
            b = '"$3"'
            for (n = 0; n < 60; ++n)
            {
                c = (a + b)/2
                if (f(a)*f(c) <= 0) b = c; else a = c
            }
            printf "%.9f", a }'
}
