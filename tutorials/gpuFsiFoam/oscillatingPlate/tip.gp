# Tip and energy of the plate in time: postProcessing/tip.png
set terminal pngcairo size 800,560 font "sans,12"
set output "postProcessing/tip.png"
set multiplot layout 2,1 margins 0.12,0.97,0.11,0.96 spacing 0.05
set xrange [0:5.2]
set samples 4000
set grid lt 1 lc rgb "#dddddd"
set key top right samplen 3 horizontal
set format x ""
set ylabel "tip  [mm]"
set yrange [-2.6:3.4]
plot 50*0.2565/(2*pi)*sin(2*pi*x/0.2565) with lines lw 2 lc rgb "#21918c" \
        title "T = 0.2565 s", \
    "postProcessing/tip/0/displacement.dat" every 5 using 1:(1e3*$3) \
        with points pt 6 ps 0.4 lc rgb "#440154" title "8 cells across"
set format x "%g"
set xlabel "t  [s]"
set ylabel "change of energy  [10^{-6}]"
set yrange [*:*]
stats "postProcessing/ledger/0/solidEnergy.dat" using ($2 + $3) \
    every ::0::0 nooutput
plot "postProcessing/ledger/0/solidEnergy.dat" \
    using 1:(1e6*(($2 + $3)/STATS_max - 1)) \
    with lines lw 1.5 lc rgb "#440154" notitle
