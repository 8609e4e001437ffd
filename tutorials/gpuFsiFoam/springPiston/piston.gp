# Displacement of the piston beside theory: postProcessing/piston.png
set terminal pngcairo size 800,400 font "sans,12"
set output "postProcessing/piston.png"
set grid lt 1 lc rgb "#dddddd"
set key top right samplen 3 spacing 1.2
omega = 1.2077926552
set xrange [0:10*2*pi/omega]
set samples 2000
set xlabel "t  [s]"
set ylabel "displacement of the piston  [10^{-4} m]"
set yrange [-1.1:1.6]
plot sin(omega*x) with lines lw 2 lc rgb "#21918c" title "theory, m = 1", \
    "postProcessing/piston/0/displacement.dat" using 1:(1e4*$2) every 3 \
        with points pt 6 ps 0.7 lc rgb "#440154" title "particles, 40 rows"
