# rho along the y axis: particles, the semi-Lagrangian scheme, the exact solution:
# studyFigures/besideGrid.png
set terminal pngcairo size 800,520 font "sans,12"
set output "studyFigures/besideGrid.png"
set xlabel "y  [m]"
set ylabel "{/Symbol r}  [kg/m^3]"
set xrange [0:7.2]
set yrange [0.9998:1.0102]
set format y "%.3f"
set grid lt 1 lc rgb "#dddddd"
set key top right samplen 3 spacing 1.3
file(w, t) = "studyFigures/".w."/postProcessing/yAxis/".t."/yAxis_rho.xy"
array colour[3] = ["#440154", "#21918c", "#d1841f"]
array times[3] = ["0.2", "0.6", "1.2"]
plot for [i=1:3] file("particles", times[i]) using 1:3 with lines lw 2 \
        lc rgb colour[i] title "exact, t = ".times[i]." s", \
    for [i=1:3] file("particles", times[i]) using 1:2 every 4 with points \
        pt 6 ps 1.1 lc rgb colour[i] notitle, \
    for [i=1:3] file("grid", times[i]) using 1:2 every 4::2 with points \
        pt 2 ps 1 lc rgb colour[i] notitle, \
    keyentry with points pt 6 ps 1.1 lc rgb "black" title "particles", \
    keyentry with points pt 2 ps 1 lc rgb "black" \
        title "semi-Lagrangian, 64^3"
