#!/bin/bash
# Do steps on the CPU cost more than they should, beside a plain loop in the
# same run? ratios.sh STEPRATE BOUNDS. A busy machine makes both slower: so a
# ratio holds where seconds do not. Three tries, as it may become busy between
# the two.
export OMP_NUM_THREADS=1
for try in 1 2 3
do
    "$1" -backend cpu -n 24 -steps 8 -rounds 15 -displace 0.2 -table -ratio \
        > ratios.md || { cat ratios.md; exit 1; }
    if awk -F' *\\| *' '
        FNR == NR { if ($0 !~ /^#/ && NF) most[$1 "|" $2] = $3; next }
        /-D, fluid/ {
            key = $2 "|" $3
            split($13, ratio, " ")
            ++found
            if (!(key in most) || ratio[1] > most[key])
            {
                print key ": " $13 ", at most " most[key]
                bad = 1
            }
        }
        END { exit bad || found != length(most) }
    ' "$2" ratios.md
    then
        cat ratios.md
        exit 0
    fi
done
cat ratios.md
exit 1
