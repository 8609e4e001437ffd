# Efficiency of weak scaling and speed-up of strong scaling, from scaling.csv
set terminal pngcairo size 900,380 font "sans,10"
set output picture
set datafile separator ","
set multiplot layout 1,2
set xlabel "GPUs"
set logscale x 2
set xrange [0.9:9]
set xtics (1, 2, 4, 8)
set key bottom left
rows(kind, scheme, refresh) = sprintf("< grep '^%s,%s,%s,1-D,' %s | grep -v ',staged,'", kind, scheme, refresh, table)
one(kind, scheme, refresh) = real(system(sprintf("grep '^%s,%s,%s,1-D,none,1,' %s | cut -d, -f8", kind, scheme, refresh, table)))

set title "256^3 particles a GPU"
set ylabel "time of one GPU over time, %"
set yrange [70:102]
plot for [s in "radial full"] rows("weak", s, "moved") \
        using 6:(100*one("weak", s, "moved")/$8) with linespoints lw 2 title s, \
    for [s in "radial full"] rows("weak", s, "10") \
        using 6:(100*one("weak", s, "10")/$8) with linespoints dt 2 \
        title s.", refresh every 10 steps"

set title "4 x 256^3 particles in all"
set ylabel "times as fast as one GPU"
set logscale y 2
set yrange [0.9:9]
set ytics (1, 2, 4, 8)
set key top left
plot for [s in "radial full"] rows("strong", s, "moved") \
        using 6:(one("strong", s, "moved")/$8) with linespoints lw 2 title s, \
    for [s in "radial full"] rows("strong", s, "10") \
        using 6:(one("strong", s, "10")/$8) with linespoints dt 2 \
        title s.", refresh every 10 steps", \
    x with lines lc "gray" title "all of it"
unset multiplot
