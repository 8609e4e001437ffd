#!/bin/bash
# Momentum of an elastic square and the vortices around it, without walls
. "$(dirname "$0")/functions.sh"
. "$(dirname "$0")/coupled.sh"
export OMP_NUM_THREADS=1

# solidMomentum CASE TIME: x and y, from the nodes' masses and velocities
solidMomentum()
{
    local solid=$work/$1/$2/lagrangian/solid
    paste -d ' ' <(grep '^(.*)$' "$solid/referencePosition") \
        <(grep '^(.*)$' "$solid/U") | tr -d '()' | awk '
        function share(x, low, high)
        {
            return x < low + 1e-6 || x > high - 1e-6 ? 0.5 : 1
        }
        {
            m = 2/32^2*share($1, 0.25, 0.5)*share($2, 0.375, 0.625)
            x += m*$4
            y += m*$5
        }
        END { printf "%.12e %.12e\n", x, y }'
}

# impulse CASE: sum of the forces on the square times deltaT, x and y, and that
# of their size
impulse()
{
    awk '/^#/ { next }
        { n++ }
        n == 2 { dt = $1 }
        n > 1 {
            fx = $2 + $5
            fy = $3 + $6
            x += fx*dt
            y += fy*dt
            size += sqrt(fx*fx + fy*fy)*dt }
        END { printf "%.12e %.12e %.12e\n", x, y, size }' \
        "$work/$1/postProcessing/push/0/square.dat"
}

# fluidChange CASE: of the fluid's momentum, x and y
fluidChange()
{
    awk '!/^#/ { if (!n++) { x = $7; y = $8 } dx = $7 - x; dy = $8 - y }
        END { printf "%.12e %.12e\n", dx, dy }' \
        "$work/$1/postProcessing/budgets/0/budgets.dat"
}

# size X Y
size()
{
    awk -v x="$1" -v y="$2" 'BEGIN { printf "%.6g\n", sqrt(x*x + y*y) }'
}

for law in surface reaction
do
    copyCase elasticSquare $law
    setEntry $law/constant/couplingProperties force $law
    setEntry $law/system/controlDict writeFormat ascii
    echo "writePrecision 12;" >> "$work/$law/system/controlDict"
    run $law || exit 1
    read -r x0 y0 <<< "$(solidMomentum $law 0)"
    read -r x y <<< "$(solidMomentum $law 4)"
    read -r ix iy most <<< "$(impulse $law)"
    read -r fx fy <<< "$(fluidChange $law)"

    # The forces in the table are those that moved the square
    rest=$(awk -v a="$x" -v b="$x0" -v c="$ix" 'BEGIN { print a - b - c }')
    other=$(awk -v a="$y" -v b="$y0" -v c="$iy" 'BEGIN { print a - b - c }')
    expect "$law: square's momentum less the forces' impulse, over it" \
        "$(ratio "$(size "$rest" "$other")" "$most")" "<=" 1e-8

    # What fluid and square have got together
    x=$(awk -v a="$fx" -v b="$ix" 'BEGIN { print a + b }')
    y=$(awk -v a="$fy" -v b="$iy" 'BEGIN { print a + b }')
    drift[${#drift[*]}]=$(ratio "$(size "$x" "$y")" "$most")
done
echo "drift over the impulse exchanged: surface, reaction: ${drift[*]}"
expect "surface: drift of all momentum over the impulse" "${drift[0]}" "<=" 0.1
expect "reaction: drift of all momentum over the impulse" "${drift[1]}" "<=" 0.2
exit "$failures"
