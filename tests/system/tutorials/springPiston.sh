#!/bin/bash
# A piston on a spring that closes a column of fluid: frequency, order, and
# masses from a hundredth of the fluid's to a thousand times
. "$(dirname "$0")/functions.sh"
. "$(dirname "$0")/coupled.sh"
export OMP_NUM_THREADS=1

# Root of m w^2 = 1 + w cot(w) in (0, pi), m = $1
root()
{
    bisect "$1*w*w - 1 - w*cos(w)/sin(w)" 1e-6 3.1415
}

# piston MASS ROWS PERIODS: prints the error of the frequency
piston()
{
    local name=m$1rows$2
    copyCase springPiston "$name"
    setEntry "$name/system/mass" m "$1"
    setEntry "$name/system/resolution" rows "$2"
    setEntry "$name/system/controlDict" periods "$3"
    run "$name" || exit 1
    fitError "$name" "$(root "$1")"
}

copyCase springPiston asItIs
"$work/asItIs/Allrun" || exit 1
command -v gnuplot > /dev/null && isFile asItIs/postProcessing/piston.png
expect "error of the frequency, m = 1, 40 rows" \
    "$(fitError asItIs "$(root 1)")" "<=" 0.005

while read -r m rows periods
do
    error=$(piston "$m" "$rows" "$periods") || exit 1
    expect "error of the frequency, m = $m, $rows rows" "$error" "<=" 0.005
    expect "greatest energy over the first, $periods periods" \
        "$(energyPeak "m${m}rows$rows")" "<=" 1.02
done << END
0.01 20 10
0.1 20 10
10 20 5
1000 10 2
END
exit "$failures"
