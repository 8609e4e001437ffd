#!/bin/bash
# Pressure that an interface of fluid and bar lets through and sends back
. "$(dirname "$0")/functions.sh"
. "$(dirname "$0")/coupled.sh"
export OMP_NUM_THREADS=1

# peak FILE N FROM TO: the value of column N of the greatest size
peak()
{
    awk -v n="$2" -v from="$3" -v to="$4" '
        !/^#/ && $1 >= from && $1 <= to {
            size = $n < 0 ? -$n : $n
            if (size > most) { most = size; value = $n } }
        END { print value }' "$work/$1"
}

copyCase interfacePulse asItIs
"$work/asItIs/Allrun" || exit 1
command -v gnuplot > /dev/null && isFile asItIs/postProcessing/pulse.png

for Z in 4 1 0.25
do
    name=Z$Z
    copyCase interfacePulse $name
    setEntry $name/system/impedance Z $Z
    [ $Z = 0.25 ] && setEntry $name/system/resolution rows 96
    run $name || exit 1
    gauge=$name/postProcessing/gauge/0/deltaRho
    sent=$(peak $gauge 2 0 1)
    back=$(peak $gauge 2 1.2 1.8)
    speed=$(peak $name/postProcessing/middle/0/displacement.dat 5 0 1.8)
    through=$(ratio "$(awk -v z=$Z -v u="$speed" 'BEGIN { print z*u }')" \
        "$sent")
    expect "transmission $through to 2 Z/(1 + Z), Z = $Z" \
        "$(off "$through" "$(awk -v z=$Z 'BEGIN { print 2*z/(1 + z) }')")" \
        "<=" 0.02
    back=$(ratio "$back" "$sent")
    expect "reflection $back to (Z - 1)/(Z + 1), Z = $Z" \
        "$(off "$back" "$(awk -v z=$Z 'BEGIN { print (z - 1)/(z + 1) }')")" \
        "<=" 0.02
done
exit "$failures"
