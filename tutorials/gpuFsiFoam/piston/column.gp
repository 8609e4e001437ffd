# rho - rho0 and U beside the exact solution: postProcessing/column.png
set terminal pngcairo size 800,640 font "sans,12"
set output "postProcessing/column.png"
set multiplot layout 2,1 margins 0.13,0.97,0.1,0.97 spacing 0.03
set xrange [0:1]
set grid lt 1 lc rgb "#dddddd"
set key top right samplen 3 spacing 1.2
file(t) = "postProcessing/column/".t."/column_deltaRho_U.xy"
array colour[3] = ["#440154", "#21918c", "#d1841f"]
array times[3] = ["0.4", "0.8", "1.2"]
set format x ""
set ylabel "{/Symbol r} - {/Symbol r}_0  [10^{-3} kg/m^3]"
plot for [i=1:3] file(times[i]) using 1:(1e3*$3) with lines lw 2 \
        lc rgb colour[i] title "exact, t = ".times[i]." s", \
    for [i=1:3] file(times[i]) using 1:(1e3*$2) every 3 with points pt 6 \
        lc rgb colour[i] notitle, \
    keyentry with points pt 6 lc rgb "black" title "particles"
set format x "%g"
set xlabel "x  [m]"
set ylabel "U_x  [10^{-3} m/s]"
plot for [i=1:3] file(times[i]) using 1:(1e3*$7) with lines lw 2 \
        lc rgb colour[i] notitle, \
    for [i=1:3] file(times[i]) using 1:(1e3*$4) every 3 with points pt 6 \
        lc rgb colour[i] notitle
