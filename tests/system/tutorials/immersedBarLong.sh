#!/bin/bash
# Finer and longer than immersedBar.sh: many periods of bars from a tenth of the
# fluid's density to a thousand times it
. "$(dirname "$0")/functions.sh"
. "$(dirname "$0")/coupled.sh"
export OMP_NUM_THREADS=1

# Root of 2 rho tan(w/8) = cot(w) in (0, pi/2), rho = $1
root()
{
    awk -v rho="$1" '
        function f(w) { return 2*rho*sin(w/8)/cos(w/8) - cos(w)/sin(w) }
        BEGIN {
            a = 1e-6
            b = 1.5707
            for (n = 0; n < 60; ++n)
            {
                m = (a + b)/2
                if (f(a)*f(m) <= 0) b = m; else a = m
            }
            printf "%.9f", a }'
}

# bar RHO ROWS PERIODS
bar()
{
    local name=rho$1
    copyCase immersedBar "$name"
    setEntry "$name/system/density" rho "$1"
    setEntry "$name/system/resolution" rows "$2"
    setEntry "$name/system/controlDict" periods "$3"
    run "$name" || exit 1
    expect "error of the frequency, rho = $1, $2 rows" \
        "$(fitError "$name" "$(root "$1")")" "<=" 0.015
    expect "greatest energy over the first, $3 periods" \
        "$(energyPeak "$name")" "<=" 1.02
}

for rho in 0.1 1 10 1000
do
    bar $rho 40 20
done
exit "$failures"
