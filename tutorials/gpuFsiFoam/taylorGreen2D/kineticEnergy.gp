# Kinetic energy beside the exact decay: postProcessing/kineticEnergy.png
set terminal pngcairo size 760,420 font "sans,12"
set output "postProcessing/kineticEnergy.png"
set xlabel "t  [s]"
set ylabel "kinetic energy  [J/m]"
set grid lt 1 lc rgb "#dddddd"
set key top right samplen 3 spacing 1.3
file = "postProcessing/budgets/0/budgets.dat"
nu = real(system("sed -n 's/^nu *\\([^;]*\\);.*/\\1/p' constant/fluidProperties"))
exact(t) = 0.25*exp(-16*pi**2*nu*t)
stats file using 1 nooutput
set xrange [0:STATS_max]
set yrange [0:0.27]
plot exact(x) with lines lw 2 lc rgb "#21918c" title "exact", \
    file using 1:10 with points pt 6 ps 1.2 lc rgb "#440154" \
        title "particles"
