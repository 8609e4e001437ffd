# Displacement of the wet face beside theory: postProcessing/modes.png
set terminal pngcairo size 800,400 font "sans,12"
set output "postProcessing/modes.png"
set grid lt 1 lc rgb "#dddddd"
set key top right samplen 3 spacing 1.2
omega = 2.92134384708
amplitude = 1e-3*sin(omega/4)/omega
set xrange [0:10*2*pi/omega]
set samples 2000
set xlabel "t  [s]"
set ylabel "displacement of the wet face  [10^{-4} m]"
set yrange [-3:4]
plot 1e4*amplitude*sin(omega*x) with lines lw 2 lc rgb "#21918c" \
        title "theory, mode 1", \
    "postProcessing/face/0/displacement.dat" using 1:(1e4*$2) every 3 \
        with points pt 6 ps 0.7 lc rgb "#440154" title "particles, 40 rows"
