#!/bin/bash
# Coupled frequencies of a bar beside a column of fluid, and their order
. "$(dirname "$0")/functions.sh"
. "$(dirname "$0")/coupled.sh"
export OMP_NUM_THREADS=1

# Root of Z cot(w Ls/cs) + cot(w) = 0 in ($1, $2): Z = 4, Ls/cs = 1/4
root()
{
    bisect "4*cos(w/4)/sin(w/4) + cos(w)/sin(w)" "$1" "$2"
}

copyCase barAndColumn asItIs
"$work/asItIs/Allrun" || exit 1
command -v gnuplot > /dev/null && isFile asItIs/postProcessing/modes.png

intervals=("" "2 3.1" "4 6.2" "6.4 9.3")
for mode in 1 2 3
do
    omega=$(root ${intervals[$mode]})
    for rows in 20 40
    do
        name=mode${mode}rows$rows
        copyCase barAndColumn $name
        setEntry $name/system/resolution mode $mode
        setEntry $name/system/resolution rows $rows
        run $name || exit 1
        error[rows]=$(fitError $name "$omega")
    done
    echo "mode $mode: errors ${error[*]}"
    expect "error of mode $mode at 40 rows" "${error[40]}" "<=" 0.01
    expect "order of mode $mode from 20 to 40 rows" \
        "$(order "${error[20]}" "${error[40]}")" ">=" 1.5
done

# The ledger of bar and fluid: what goes lost in ten periods of mode 1
expect "energy left" "$(energyLeft mode1rows40)" ">=" 0.95
expect "energy left" "$(energyLeft mode1rows40)" "<=" 1.01
exit "$failures"
