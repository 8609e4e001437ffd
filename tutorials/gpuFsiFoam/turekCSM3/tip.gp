# Tip and energies of the beam in time: postProcessing/tip.png
set terminal pngcairo size 800,640 font "sans,12"
set output "postProcessing/tip.png"
set multiplot layout 2,1 margins 0.11,0.97,0.09,0.97 spacing 0.05
set grid lt 1 lc rgb "#dddddd"
set key top right samplen 3 horizontal
set xrange [0:10]
set format x ""
set ylabel "displacement of the tip  [mm]"
set yrange [-150:40]
set arrow from 0, -63.607 + 65.160 to 10, -63.607 + 65.160 nohead lw 2 \
    lc rgb "#21918c"
set arrow from 0, -63.607 - 65.160 to 10, -63.607 - 65.160 nohead lw 2 \
    lc rgb "#21918c"
plot NaN lw 2 lc rgb "#21918c" title "range, Turek and Hron", \
    "postProcessing/tip/0/displacement.dat" using 1:(1e3*$3) \
        with lines lw 1.5 lc rgb "#440154" title "y", \
    "" using 1:(1e3*$2) with lines lw 1.5 lc rgb "#d08770" title "x"
unset arrow
set format x "%g"
set xlabel "t  [s]"
set ylabel "energy  [J/m]"
set yrange [-0.8:1.1]
ledger = "postProcessing/ledger/0/solidEnergy.dat"
plot ledger using 1:(-$5) with lines lw 2 lc rgb "#21918c" \
        title "- work of gravity", \
    "" using 1:2 with lines lw 1.5 lc rgb "#440154" title "kinetic", \
    "" using 1:3 with lines lw 1.5 lc rgb "#d08770" title "elastic"
