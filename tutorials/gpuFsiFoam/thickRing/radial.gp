# Radial displacement of all particles: postProcessing/radial.png
set terminal pngcairo size 640,480 font "sans,12"
set output "postProcessing/radial.png"
set grid lt 1 lc rgb "#dddddd"
set xrange [0.48:1.02]
set xlabel "r  [m]"
set ylabel "radial displacement  [{/Symbol m}m]"
plot "postProcessing/radial.dat" using 1:(1e6*$2) \
        with points pt 7 ps 0.25 lc rgb "#440154" title "particles", \
    1e6*1.3*100*0.25/(1e6*0.75)*(0.4*x + 1/x) \
        with lines lw 2 lc rgb "#21918c" title "Lame"
