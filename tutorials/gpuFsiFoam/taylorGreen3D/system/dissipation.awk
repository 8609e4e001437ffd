# awk -f system/dissipation.awk constant/dissipation.dat BUDGETS
# For each interval of the table of budgets: its middle, the mean rate at which
# 1 kg loses kinetic energy, the same of the reference, the relative difference.
/^#/ { next }
NR == FNR { reference[$1 + 0] = $2; next }
t != "" && ($1 + 0) in reference {
    rate = (energy - $10/$2)/($1 - t)
    of = (reference[t] - reference[$1 + 0])/($1 - t)
    printf "%g %.8f %.8f %.5f\n", ($1 + t)/2, rate, of, rate/of - 1
}
{ t = $1 + 0; energy = $10/$2 }
