# The tip on its way to rest: postProcessing/tip.png
set terminal pngcairo size 800,420 font "sans,12"
set output "postProcessing/tip.png"
set grid lt 1 lc rgb "#dddddd"
set key right center samplen 3
set xrange [0:1.6]
set xlabel "t  [s]"
set ylabel "displacement of the tip  [mm]"
plot -66.10 with lines lw 2 lc rgb "#21918c" title "Turek and Hron, y", \
    -7.187 with lines lw 2 lc rgb "#d08770" title "x", \
    "postProcessing/tip/0/displacement.dat" using 1:(1e3*$3) every 4 \
        with points pt 6 ps 0.5 lc rgb "#440154" title "particles, y", \
    "" using 1:(1e3*$2) every 4 \
        with points pt 4 ps 0.5 lc rgb "#440154" title "x"
