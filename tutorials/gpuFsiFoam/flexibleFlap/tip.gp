# Force, stream and tip in time: postProcessing/tip.png
set terminal pngcairo size 800,560 font "sans,12"
set output "postProcessing/tip.png"
set multiplot layout 2,1 margins 0.1,0.97,0.1,0.97 spacing 0.04
set grid lt 1 lc rgb "#dddddd"
set key top right samplen 2 horizontal
set xrange [0:10]
set format x ""
set ylabel "g  [m/s^2],  U  [m/s]"
set yrange [-2:2.6]
plot 1.6*cos(2*pi*x/4) with lines lw 2 lc rgb "#21918c" title "force", \
    "postProcessing/budgets/0/budgets.dat" using 1:($7/$2) with lines lw 2 \
        lc rgb "#440154" title "mean velocity of the fluid"
set format x "%g"
set xlabel "t  [s]"
set ylabel "tip  [m]"
set yrange [-0.25:0.32]
tip = "postProcessing/tip/0/displacement.dat"
plot tip using 1:2 with lines lw 2 lc rgb "#d1841f" title "x", \
    "" using 1:4 with lines lw 2 lc rgb "#3b528b" title "z"
