# Middle and half the range of a column of a function object's table:
#     awk -v column=N [-v from=T] -f swing.awk TABLE
!/^#/ && NF && $1 >= from + 0 {
    low = rows && low < $column ? low : $column
    high = rows++ && high > $column ? high : $column
}
END {
    if (!rows)
    {
        print "no rows from the time " from
        exit 1
    }
    printf "%.8g %.8g\n", (low + high)/2, (high - low)/2
}
