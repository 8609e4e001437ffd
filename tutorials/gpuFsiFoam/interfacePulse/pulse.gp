# Pressure that passes the gauge and the bar's middle: postProcessing/pulse.png
set terminal pngcairo size 800,400 font "sans,12"
set output "postProcessing/pulse.png"
set grid lt 1 lc rgb "#dddddd"
set key top left samplen 3 spacing 1.2
Z = 4
T = 2*Z/(1.0 + Z)
R = (Z - 1)/(1.0 + Z)
pulse(t) = exp(-(t/0.2)**2)
set xrange [0:1.8]
set yrange [-0.1:1.9]
set samples 1000
set xlabel "t  [s]"
set ylabel "pressure  [10^{-4} Pa]"
plot pulse(x - 0.5) + R*pulse(x - 1.5) with lines lw 2 lc rgb "#21918c" \
        title "theory: fluid, 0.5 m before the interface", \
    T*pulse(x - 1.5) with lines lw 2 lc rgb "#5ec962" \
        title "theory: bar, 1 m behind it", \
    "postProcessing/gauge/0/deltaRho" using 1:(1e4*$2) every 8 \
        with points pt 6 ps 0.7 lc rgb "#440154" title "particles, 64 rows", \
    "postProcessing/middle/0/displacement.dat" using 1:(1e4*Z*$5) every 8 \
        with points pt 4 ps 0.7 lc rgb "#3b528b" notitle
