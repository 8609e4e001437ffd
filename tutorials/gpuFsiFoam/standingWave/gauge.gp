# deltaRho at x = 0.1 beside the exact solution: postProcessing/gauge.png
set terminal pngcairo size 800,400 font "sans,12"
set output "postProcessing/gauge.png"
set grid lt 1 lc rgb "#dddddd"
set key top right samplen 3 spacing 1.2
set xrange [0:10]
set samples 1000
decay = 0.01*pi**2/2
omega = sqrt(pi**2 - decay**2)
exact(t) = 1e-4*cos(0.1*pi)*exp(-decay*t) \
    *(cos(omega*t) + decay/omega*sin(omega*t))
set xlabel "t  [s]"
set ylabel "{/Symbol r} - {/Symbol r}_0 at x = 0.1  [10^{-4} kg/m^3]"
plot 1e4*exact(x) with lines lw 2 lc rgb "#21918c" title "exact", \
    "postProcessing/gauge/0/deltaRho" using 1:(1e4*$2) every 3 \
        with points pt 6 lc rgb "#440154" title "particles, 32 rows"
