# U between the plates beside the exact solution: postProcessing/profile.png
set terminal pngcairo size 800,560 font "sans,12"
set output "postProcessing/profile.png"
set grid lt 1 lc rgb "#dddddd"
set key bottom center
set yrange [0:*]
set xlabel "y  [m]"
set ylabel "U_x  [m/s]"
file(t) = "postProcessing/profile/".t."/profile_U.xy"
array colour[4] = ["#440154", "#31688e", "#35b779", "#d1841f"]
array times[4] = ["0.5", "1", "1.5", "2"]
plot for [i=1:4] file(times[i]) using 1:5 with lines lw 2 \
        lc rgb colour[i] title "exact, t = ".times[i]." s", \
    for [i=1:4] file(times[i]) using 1:2 every 2 with points pt 6 \
        lc rgb colour[i] notitle, \
    keyentry with points pt 6 lc rgb "black" title "particles"
