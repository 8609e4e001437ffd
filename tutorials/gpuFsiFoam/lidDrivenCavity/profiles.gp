# Velocities on the middle lines beside Ghia's: postProcessing/profiles.png
set terminal pngcairo size 900,430 font "sans,12"
set output "postProcessing/profiles.png"
set multiplot layout 1,2 margins 0.08,0.98,0.14,0.96 spacing 0.1
Re = int(system("sed -n 's/^Re  *\\([0-9]*\\);.*/\\1/p' constant/fluidProperties"))
last = system("ls postProcessing/profiles | sort -g | tail -n 1")
file(line) = "postProcessing/profiles/".last."/".line."_U.xy"
column = Re == 100 ? 2 : 3
set grid lt 1 lc rgb "#dddddd"
set key samplen 2 spacing 1.2
set xrange [0:1]
set key top left
set xlabel "y/L on x = L/2"
set ylabel "u/U" offset 1
plot file("alongY") using 1:2 with lines lw 2 lc rgb "#21918c" \
        title "particles, t = ".last, \
    "constant/ghia/alongY" using 1:column with points pt 6 \
        lc rgb "#440154" title "Ghia et al."
set key top right
set xlabel "x/L on y = L/2"
set ylabel "v/U" offset 1
plot file("alongX") using 1:3 with lines lw 2 lc rgb "#21918c" \
        title "particles, t = ".last, \
    "constant/ghia/alongX" using 1:column with points pt 6 \
        lc rgb "#440154" title "Ghia et al."
