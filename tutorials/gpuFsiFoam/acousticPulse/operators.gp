# Operators of the first steps, particles beside finite differences:
# studyFigures/operators.png
set terminal pngcairo size 1000,460 font "sans,11"
set output "studyFigures/operators.png"
set multiplot layout 1,2
set grid lt 1 lc rgb "#dddddd"
set xlabel "r  [m]"
set xrange [0:7.5]
a = 0.01
c2 = 1.0/3
dt = 0.02
rho(r) = 1 + a*exp(-r*r/5)
slope(r) = -0.4*r*a*exp(-r*r/5)
s1(r) = slope(r)/rho(r)
s2(r) = a*exp(-r*r/5)*(0.16*r*r - 0.4)/rho(r) - s1(r)**2
div(r) = -dt*c2*(s2(r) + 2*s1(r)/r)
p = "studyFigures/particleOperators.dat"
g = "studyFigures/gridOperators.dat"
set title "square norm of grad P at t = 0  [Pa^2/m^2]"
set format y "%.1t 10^{%T}"
plot [0.001:7.5] (c2*slope(x))**2 with lines lw 2 lc rgb "#21918c" \
        title "exact", \
    p using 1:2 with points pt 6 ps 0.9 lc rgb "#440154" title "particles", \
    g using 1:2 with points pt 2 ps 0.9 lc rgb "#d1841f" \
        title "finite differences, 64^3"
set title "div v after one step, t = 0.02 s  [1/s]"
plot [0.001:7.5] div(x) with lines lw 2 lc rgb "#21918c" title "exact", \
    p using 1:3 with points pt 6 ps 0.9 lc rgb "#440154" title "particles", \
    g using 1:3 with points pt 2 ps 0.9 lc rgb "#d1841f" \
        title "finite differences, 64^3"
unset multiplot
