# How far the block's corners are above the floor: postProcessing/way.png
set terminal pngcairo size 800,480 font "sans,12"
set output "postProcessing/way.png"
set xlabel "t  [s]"
set ylabel "corner above the floor  [m]"
set yrange [0:0.27]
set y2range [-0.3:0]
set y2label "its speed  [m/s]"
set ytics nomirror
set y2tics
set key right center
set grid lt 1 lc rgb "#dddddd"
file = "postProcessing/corners/0/displacement.dat"
plot file using 1:(0.25 + $3) with lines lw 2 lc rgb "#440154" \
        title "left", \
    file using 1:(0.25 + $9) with lines lw 2 dt 2 lc rgb "#21918c" \
        title "right", \
    0.5/24 with lines lt 1 lc rgb "#888888" title "half a spacing", \
    file using 1:6 axes x1y2 with lines lw 1 lc rgb "#e07020" title "speed"
