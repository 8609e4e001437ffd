#!/bin/bash
# What terms cost that a scene does not use: stepRate, a fluid without viscosity,
# beside the same built from sources with viscosity, body forces, shifting and
# walls cut out of the passes.
#     leftOut.sh DIRECTORY [stepRate's options]
# Builds in DIRECTORY (some minutes), runs in turn, tells the fastest of five rounds:
# what else a machine does makes a round slower, never faster. On a GPU rounds agree
# within 0.3%; on two cores of a shared machine they differ by more than is sought.
set -e
source=$(cd "${0%/*}/../.." && pwd)
directory=$1
[ -n "$directory" ] || { echo "Usage: $0 DIRECTORY [options]" >&2; exit 1; }
shift
mkdir -p "$directory"
directory=$(cd "$directory" && pwd)

# build NAME SOURCE
build()
{
    cmake -S "$2" -B "$directory/$1" -G Ninja -DWITH_CGAL=OFF -DWITH_VTK=OFF \
        > "$directory/log.$1" \
        && ninja -C "$directory/$1" stepRate >> "$directory/log.$1"
}

# cut FILE TEXT: conditions that hold no more
cut()
{
    grep -qF "$2" "$directory/source/$1" \
        || { echo "$1: no '$2' to cut out" >&2; exit 1; }
    sed -i "s/$2/false \&\& $2/" "$directory/source/$1"
}

rm -rf "$directory/source"
mkdir "$directory/source"
git -C "$source" ls-files -z | (cd "$source" && xargs -0 cp --parents -t "$directory/source")
passes=libsrc/stepping
cut $passes/ratePass.H 's.mu > 0'
cut $passes/ratePass.H 's.weighed'
cut $passes/ratePass.H 's.nWalls > 0'
cut $passes/gradientPass.H 's.shiftLength > 0'
cut $passes/move.H 's.shiftLength > 0'
build whole "$source"
build without "$directory/source"

for scheme in radial moment
do
    for round in 1 2 3 4 5
    do
        for kind in whole without
        do
            "$directory/$kind/bin/stepRate" -inviscid -scheme $scheme "$@" \
                | awk -F'|' -v k="$kind" '/D, fluid/ {split($5, t, " "); print k, t[1], $10}'
        done
    done | sort -k1,1 -k2,2g | awk -v s=$scheme '
        {ms[$1, ++n[$1]] = $2; bytes[$1] = $3}
        END {
            a = ms["whole", 1]; b = ms["without", 1]
            printf "%-8s %.4g ms a step, %.4g without: %+.1f%%; bytes a particle %s, %s\n",
                s, a, b, 100*(a/b - 1), bytes["whole"], bytes["without"]
        }'
done
