# Tips of the three bars in time: postProcessing/tips.png
set terminal pngcairo size 800,560 font "sans,12"
set output "postProcessing/tips.png"
set multiplot layout 3,1 margins 0.11,0.97,0.11,0.95 spacing 0.04
set xrange [0:0.24]
set yrange [-1.3:1.9]
set ytics -1, 1
set samples 1000
set grid lt 1 lc rgb "#dddddd"
set key top right samplen 3 horizontal
c = sqrt(1.2*1e6/1000)
omega(n) = (2*n - 1)*pi/2*c
set format x ""
do for [n=1:3] \
{
    if (n == 3) { set format x "%g"; set xlabel "t  [s]" }
    set ylabel sprintf("mode %d", n)
    sign = n == 2 ? -1 : 1
    plot sin(omega(n)*x) with lines lw 2 lc rgb "#21918c" title "exact", \
        "postProcessing/tips/0/displacement.dat" every 2 \
            using 1:(sign*1e3*omega(n)*column(6*n - 4)) \
            with points pt 6 ps 0.7 lc rgb "#440154" title "tip, 32 cells"
}
