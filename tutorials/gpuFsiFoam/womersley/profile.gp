# U between the plates over half a period beside the exact solution:
# postProcessing/profile.png
set terminal pngcairo size 800,560 font "sans,12"
set output "postProcessing/profile.png"
set grid lt 1 lc rgb "#dddddd"
set key bottom center maxrows 3 samplen 2
set yrange [-1.75:0.5]
set xlabel "y  [m]"
set ylabel "U_x  [m/s]"
file(t) = "postProcessing/profile/".t."/profile_U.xy"
array colour[5] = ["#440154", "#3b528b", "#21918c", "#5ec962", "#d1841f"]
array times[5] = ["1.5", "1.625", "1.75", "1.875", "2"]
plot for [i=1:5] file(times[i]) using 1:5 with lines lw 2 \
        lc rgb colour[i] title "exact, t = ".times[i]." s", \
    for [i=1:5] file(times[i]) using 1:2 every 2 with points pt 6 \
        lc rgb colour[i] notitle, \
    keyentry with points pt 6 lc rgb "black" title "particles"
