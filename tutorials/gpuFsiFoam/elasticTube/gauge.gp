# Density along the tube in time: postProcessing/gauge.png
set terminal pngcairo size 800,420 font "sans,12"
set output "postProcessing/gauge.png"
set xlabel "t  [ms]"
set ylabel "{/Symbol r} - {/Symbol r}_0  [kg/m^3]"
set grid lt 1 lc rgb "#dddddd"
set key bottom left samplen 2
array names[8] = ["y = -160 mm", "-140", "-120", "-100", "-60", "-20", \
    "80, z = 20", "80, z = -20"]
plot for [i=1:4] "postProcessing/gauge/0/deltaRho" using (1e3*$1):i+1 \
        with lines lw 2 title names[i], \
    for [i=1:4] "postProcessing/downstream/0/deltaRho" using (1e3*$1):i+1 \
        with lines lw 2 dt 2 title names[i + 4]
