# Displacement of the bar's middle beside theory: postProcessing/motion.png
set terminal pngcairo size 800,400 font "sans,12"
set output "postProcessing/motion.png"
set grid lt 1 lc rgb "#dddddd"
set key top right samplen 3 spacing 1.2
omega = 1.26263145975
set xrange [0:20*2*pi/omega]
set samples 3000
set xlabel "t  [s]"
set ylabel "displacement of the bar's middle  [10^{-4} m]"
set yrange [-1.1:1.6]
plot sin(omega*x) with lines lw 2 lc rgb "#21918c" \
        title "theory, bar as dense as the fluid", \
    "postProcessing/middle/0/displacement.dat" using 1:(1e4*$2) every 4 \
        with points pt 6 ps 0.7 lc rgb "#440154" title "particles, 40 rows"
