# Frequency of a swing, Hz, from a table of a function object: one over the
# slope of the line through the times at which a column passes a mean upwards.
#     awk -v column=N [-v mean=M] -f frequency.awk TABLE
!/^#/ && NF {
    b = $column - mean
    if (rows++ && a < 0 && b >= 0)
    {
        when = before + ($1 - before)*a/(a - b)
        ++m
        sx += m
        sy += when
        sxx += m*m
        sxy += m*when
    }
    a = b
    before = $1
}
END {
    if (m < 2)
    {
        print "fewer than two swings"
        exit 1
    }
    printf "%.8g\n", (m*sxx - sx*sx)/(m*sxy - sx*sy)
}
