# Amplitudes of the three modes in time: postProcessing/modes.png
set terminal pngcairo size 800,640 font "sans,12"
set output "postProcessing/modes.png"
set multiplot layout 3,1 margins 0.11,0.97,0.1,0.97 spacing 0.03
set xrange [0:6]
set yrange [-1.3:2]
set ytics -1, 1
set samples 1000
set grid lt 1 lc rgb "#dddddd"
set key top right samplen 3 horizontal
array words[3] = ["mode1", "mode2", "mode0"]
array orders[3] = ["1", "2", "0"]
array jPrime[3] = [1.841184, 3.054237, 3.831706]
set format x ""
do for [i=1:3] \
{
    if (i == 3) { set format x "%g"; set xlabel "t  [s]" }
    set ylabel "m = ".orders[i]
    plot cos(2*jPrime[i]*x) with lines lw 2 lc rgb "#21918c" \
            title "exact, without decay", \
        "postProcessing/".words[i]."/0/waveFit.dat" using 1:(1e4*$2) \
            with points pt 6 lc rgb "#440154" title "particles, 32 rows"
}
