#!/bin/bash
# Weak and strong scaling on the GPUs of this machine, a table and a picture:
# scaling.sh BUILD DIRECTORY ['1 2 4 8'] [STEPS]
# Weak: 256^3 particles a GPU; strong: 4 x 256^3 in all. Slabs (1-D), columns
# (2-D), boxes (3-D) and Hilbert's curve; radial and full schemes; neighbours
# found anew when particles have moved, and every 10 steps.
# SIDE=64 BACKEND=cpu tries it without a GPU.
build=$1
out=$2
counts=${3:-1 2 4 8}
steps=${4:-250}        # in each of four rounds, the last three of which count
here=$(dirname "$0")
side=${SIDE:-256}
mkdir -p "$out"
table=$out/scaling.csv
export OMP_NUM_THREADS=${OMP_NUM_THREADS:-4}
echo "case,scheme,refresh,decomposition,transport,ranks,particles,msPerStep,least,greatest,fingerprint,hidden" \
    > "$table"

# factors N: the boxes of N along x, y, z
factors()
{
    case $1 in
        1) echo 1 1 1 ;;
        2) echo 2 1 1 ;;
        4) echo 2 2 1 ;;
        8) echo 2 2 2 ;;
        *) echo "$1" 1 1 ;;
    esac
}

# cuts N DIMENSIONS
cuts()
{
    case $2-$1 in
        2-4) echo 2 2 1 ;;
        2-8) echo 4 2 1 ;;
        3-8) echo 2 2 2 ;;
        *) echo "$1" 1 1 ;;
    esac
}

# measure CASE SCHEME REFRESH NAME RANKS OPTIONS...: a row of the table
measure()
{
    local case=$1 scheme=$2 refresh=$3 name=$4 ranks=$5
    shift 5
    local often=()
    [ "$refresh" = moved ] || often=(-refresh "$refresh")
    mpirun --oversubscribe -np "$ranks" "$build/bin/scaling" -parallel \
        -backend "${BACKEND:-cuda}" -n "$side" -displace 0.2 -steps "$steps" \
        -scheme "$scheme" "${often[@]}" "$@" > "$out/log" 2>&1 \
        || { cat "$out/log"; exit 1; }
    awk -v start="$case,$scheme,$refresh,$name" '
        BEGIN { transport = "none"; hidden = "" }
        / fingerprint / {
            split($0, part, "|")
            split(part[4], ranks, " ")
            split(part[5], particles, " ")
            split(part[6], ms, /[ ()]+/)
            print_it = ranks[2] "," particles[1] "," ms[2] "," ms[4] "," ms[6]
            print_end = $NF
        }
        / transport;/ {
            match($0, /[a-z0-9 ()]* transport/)
            transport = substr($0, RSTART + 1, RLENGTH - 11)
            match($0, /[0-9]*% of the mess/)
            hidden = substr($0, RSTART, RLENGTH - 12)
        }
        END { print start "," transport "," print_it "," print_end "," hidden }
        ' "$out/log" | tee -a "$table"
}

# each CASE: for every scheme, refresh and number of ranks
each()
{
    local scheme refresh n
    for scheme in radial full
    do
        for refresh in moved 10
        do
            for n in $counts
            do
                "$1" "$scheme" "$refresh" "$n"
            done
        done
    done
}

weak()
{
    local boxes
    boxes=$(factors "$3")
    measure weak "$1" "$2" 1-D "$3" -boxes "$boxes" -cuts "$(cuts "$3" 1)"
    [ "$3" -ge 2 ] || return 0
    measure weak "$1" "$2" 1-D "$3" -boxes "$boxes" -cuts "$(cuts "$3" 1)" \
        -staged
    measure weak "$1" "$2" hilbert "$3" -boxes "$boxes" -method hilbert
    [ "$3" -ge 4 ] || return 0
    measure weak "$1" "$2" 2-D "$3" -boxes "$boxes" -cuts "$(cuts "$3" 2)"
    [ "$3" -ge 8 ] || return 0
    measure weak "$1" "$2" 3-D "$3" -boxes "$boxes" -cuts "$(cuts "$3" 3)"
}

strong()
{
    measure strong "$1" "$2" 1-D "$3" -boxes '4 1 1' -cuts "$(cuts "$3" 1)"
}

each weak
each strong
command -v gnuplot > /dev/null || exit 0
gnuplot -e "table='$table'; picture='$out/scaling.png'" "$here/scaling.gp"
