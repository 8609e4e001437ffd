# For the tests of tutorials: runs copies of a tutorial's case and checks what
# its function object `error` measured. Called as TEST SOURCE WORK BUILD.

export FSI_DIR=$1
export FSI_BUILD=$3
work=$2
tutorials=$FSI_DIR/tutorials/gpuFsiFoam
failures=0

# A tutorial's own files, without what a run of it left behind
copyCase()
{
    rm -rf "${work:?}/$2"
    mkdir -p "$work/$2"
    cp -r "$tutorials/$1"/{system,constant,All*,*.gp} "$work/$2"
    rm -rf "$work/$2"/constant/{polyMesh,domain,solid,triSurface}
}

# setEntry FILE KEY VALUE: of a top-level entry that is there
setEntry()
{
    if ! grep -q "^$2 " "$work/$1"
    then
        echo "No entry $2 at the top level of $work/$1" >&2
        exit 1
    fi
    sed -i "s|^$2 .*|$2 $3;|" "$work/$1"
}

# relativeL2 CASE NAME TIME: from the table of the function object NAME
relativeL2()
{
    awk -v t="$3" '$1 == t { found = 1; print $6 }
        END { if (!found) print "no row of Time " t }' \
        "$work/$1/postProcessing/$2/0/error.dat"
}

# Solves without pictures and prints the relative L2 error
solve()
{
    (
        cd "$work/$1" || exit 1
        . "$FSI_DIR/etc/tools/RunFunctions"
        runApplication -o seedParticles >&2
        runApplication -o gpuFsiFoam >&2
    ) || exit 1
    relativeL2 "$1" "$2" "$3"
}

# Seeds and solves, without pictures
runCase()
{
    (
        cd "$work/$1" || exit 1
        . "$FSI_DIR/etc/tools/RunFunctions"
        runApplication -o seedParticles >&2
        runApplication -o gpuFsiFoam >&2
    ) || exit 1
}

# relativeError VALUE EXACT: its size
relativeError()
{
    awk -v v="$1" -v e="$2" 'BEGIN { d = v/e - 1
        printf "%.6g\n", d < 0 ? -d : d }'
}

# frequency TABLE COLUMN [MEAN]: of the swings of a column, Hz
frequency()
{
    awk -v column="$2" -v mean="${3:-0}" \
        -f "$FSI_DIR/etc/tools/frequency.awk" "$work/$1"
}

# swing TABLE COLUMN [FROM]: middle and half the range of a column
swing()
{
    awk -v column="$2" -v from="${3:-0}" \
        -f "$FSI_DIR/etc/tools/swing.awk" "$work/$1"
}

# expect WHAT VALUE RELATION LIMIT, where RELATION is <= or >=
expect()
{
    if awk -v v="$2" -v l="$4" "BEGIN { \
        exit !(v ~ /^[0-9.e+-]+\$/ && v + 0 $3 l) }"
    then
        echo "ok      $1 = $2, wanted $3 $4"
    else
        echo "FAILED  $1 = $2, wanted $3 $4"
        failures=$((failures + 1))
    fi
}

# order ERROR ERROR [FACTOR]: of an error that falls from the first to the
# second while h is divided by FACTOR, 2 by default
order()
{
    awk -v a="$1" -v b="$2" -v f="${3:-2}" \
        'BEGIN { printf "%.3f\n", log(a/b)/log(f) }'
}

# tableValue FILE TIME N: the N-th column of a function object's table
tableValue()
{
    awk -v t="$2" -v n="$3" '$1 == t { found = 1; print $n }
        END { if (!found) print "no row of Time " t }' "$work/$1"
}

# ratio A B
ratio()
{
    awk -v a="$1" -v b="$2" 'BEGIN { printf "%.6g\n", a/b }'
}

isFile()
{
    if [ -f "$work/$1" ]
    then
        echo "ok      $1 is there"
    else
        echo "FAILED  $work/$1 is missing"
        failures=$((failures + 1))
    fi
}

# expectGhia CASE TIME: velocities of a driven cavity within 1.5% of Ghia's
expectGhia()
{
    local line time worst where noise lines=0
    while read -r line time worst where noise
    do
        expect "end of $line" "$time" ">=" "$2"
        expect "largest difference $line, there at $where" \
            "$worst" "<=" 0.015
        echo "        departures from the mean of five lid times: $noise"
        lines=$((lines + 1))
    done < <("$work/$1/Allcompare")
    expect "number of lines compared" "$lines" ">=" 2
}
