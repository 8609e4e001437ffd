# From displacement.dat and solidEnergy.dat: how long each collision took over
# 2 L/c, speeds in the end over the first bar's, largest residual of the ledger
# over the energy. c^2 = 1.2 E/rho; a bar rings with the period 2 L/c, over
# which its middle moves as its centre does.
BEGIN {
    v = 0.05
    ring = 2/sqrt(1200)
    late = 0.2
}
/^#/ { next }
FNR == NR {
    t[n] = $1
    for (b = 0; b < 3; ++b)
    {
        x[b, n] = $(6*3*b + 6 + 2)
    }
    ++n
    next
}
{
    energy = energy ? energy : $2
    r = $9 < 0 ? -$9 : $9
    residual = r > residual ? r : residual
}

# As long as bars ring they may part and touch again: a collision is over when
# nothing has touched for 5 ms
$13 > 0 {
    if (!collisions || $1 - end[collisions] > 0.005)
    {
        begin[++collisions] = $1
    }
    end[collisions] = $1
}

# Of bar b in the middle of its ring, straight between the rows
function at(b, time,    k) {
    for (k = 1; t[k] < time; ++k)
    {
    }
    return x[b, k - 1] \
        + (x[b, k] - x[b, k - 1])*(time - t[k - 1])/(t[k] - t[k - 1])
}
END {
    for (c = 1; c <= collisions; ++c)
    {
        printf "collision %d: %.4f s, %.4f of 2 L/c\n",
            c, end[c] - begin[c], (end[c] - begin[c])/ring
    }
    for (b = 0; b < 3; ++b)
    {
        printf "bar %d: %.4f of the first speed\n",
            b + 1, (at(b, late + ring) - at(b, late))/(ring*v)
    }
    printf "residual of the ledger: %.2e\n", residual/energy
}
