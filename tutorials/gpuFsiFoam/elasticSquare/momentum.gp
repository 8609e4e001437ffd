# Momentum along x that fluid and square have got: postProcessing/momentum.png
set terminal pngcairo size 800,400 font "sans,12"
set output "postProcessing/momentum.png"
set grid lt 1 lc rgb "#dddddd"
set key top right samplen 3 spacing 1.2
set xlabel "t  [s]"
set ylabel "gain of momentum along x  [10^{-3} N s]"
set yrange [-3:4.5]
dt = 0.01
sum = 0
square(t, f) = (sum = sum + (t > 0 ? f*dt : 0), 1e3*sum)
plot "postProcessing/budgets/0/budgets.dat" using 1:(1e3*$18) with lines \
        lw 2 lc rgb "#21918c" title "fluid", \
    "postProcessing/push/0/square.dat" using 1:(square($1, $2 + $5)) \
        with lines lw 2 lc rgb "#440154" title "square: sum of F dt"
