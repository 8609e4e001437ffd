# U_y on the x axis beside the final profile: postProcessing/profile.png
set terminal pngcairo size 800,560 font "sans,12"
set output "postProcessing/profile.png"
set grid lt 1 lc rgb "#dddddd"
set key top right samplen 3
set xlabel "r  [m]"
set ylabel "U_{/Symbol q}  [m/s]"
set yrange [0:*]
exact(r) = -r/3 + 4/(3*r)
file(t) = "postProcessing/profile/".t."/profile_U_deltaRho.xy"
array colour[3] = ["#440154", "#31688e", "#d1841f"]
array times[3] = ["1", "2", "6"]
set xrange [1:2]
plot exact(x) with lines lw 2 lc rgb "#888888" title "A r + B/r", \
    for [i=1:3] file(times[i]) using 1:3 with points pt 6 \
        lc rgb colour[i] title "t = ".times[i]." s"
