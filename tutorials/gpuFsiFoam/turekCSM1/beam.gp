# The beam at rest: postProcessing/beam.png
set terminal pngcairo size 800,300 font "sans,12"
set output "postProcessing/beam.png"
set size ratio -1
set grid lt 1 lc rgb "#dddddd"
set xrange [-0.06:0.42]
set yrange [-0.09:0.06]
set ytics 0.05
set xlabel "x  [m]"
set ylabel "y  [m]"
set cblabel "von Mises  [kPa]"
set palette defined (0 '#440154', 1 '#3b528b', 2 '#21918c', 3 '#5ec962', \
    4 '#fde725')
set object circle at 0, 0 size 0.05 fs solid noborder fc rgb "#bbbbbb"
plot "postProcessing/beam.dat" using 1:2:(1e-3*$3) \
        with points pt 7 ps 0.35 lc palette notitle, \
    "<echo 0.392813 -0.0661" with points pt 2 ps 2 lw 2 lc rgb "#d00000" \
        title "tip, Turek and Hron"
