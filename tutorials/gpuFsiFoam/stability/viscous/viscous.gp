# Error and seconds against nu deltaT/h^2: postProcessing/viscous.png
set terminal pngcairo size 900,400 font "sans,11"
set output "postProcessing/viscous.png"
set multiplot layout 1,2
set logscale xy
set format x "10^{%L}"
set format y "10^{%L}"
set grid lt 1 lc rgb "#dddddd"
set xrange [0.007:150]
set xlabel "nu deltaT/h^2"
set key top left samplen 2 spacing 1.2
set arrow 1 from 0.5, graph 0 to 0.5, graph 1 nohead dt 2 lc rgb "#888888"
set label 1 "explicit limit" at 0.55, graph 0.06 tc rgb "#666666"
rows(scheme, super) = \
    "< awk '$1 == \"".scheme."\" && $2 == \"".super."\" && $4 + 0 < 1' ".\
    "postProcessing/viscous.dat"
set ylabel "relative L2 error of U"
set yrange [5e-6:1e-4]
plot rows("Euler", "off") using 3:4 with linespoints pt 4 lc rgb "#e08214" \
        title "Euler", \
    rows("RK2", "off") using 3:4 with linespoints pt 6 lc rgb "#440154" \
        title "RK2", \
    rows("RK2", "on") using 3:4 with linespoints pt 7 lc rgb "#21918c" \
        title "RK2, viscosity RKL2"
set ylabel "seconds, one core"
set yrange [0.01:300]
set key top right
plot rows("Euler", "off") using 3:5 with linespoints pt 4 lc rgb "#e08214" \
        notitle, \
    rows("RK2", "off") using 3:5 with linespoints pt 6 lc rgb "#440154" \
        notitle, \
    rows("RK2", "on") using 3:5 with linespoints pt 7 lc rgb "#21918c" \
        notitle
unset multiplot
