# Rate at which kinetic energy is lost, beside the reference:
# postProcessing/dissipation.png
set terminal pngcairo size 760,440 font "sans,12"
set output "postProcessing/dissipation.png"
set xlabel "t  [s]"
set ylabel "dissipation rate  [10^{-3} W/kg]"
set grid lt 1 lc rgb "#dddddd"
set key bottom left samplen 3 spacing 1.3
set xrange [0:10]
set yrange [0:16]
plot "constant/dissipation.dat" using 1:(1e3*$3) with lines lw 2 \
        lc rgb "#21918c" title "spectral, incompressible", \
    "postProcessing/dissipation.dat" using 1:(1e3*$2) with points pt 6 \
        ps 1.1 lc rgb "#440154" title "particles"
