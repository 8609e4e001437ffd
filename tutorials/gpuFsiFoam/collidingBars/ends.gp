# Ends of the three bars in time: postProcessing/ends.png
set terminal pngcairo size 900,620 font "sans,12"
set output "postProcessing/ends.png"
set xrange [0:220]
set yrange [-0.3:8.2]
set xlabel "t  [ms]"
set ylabel "where it is, but for 1 m of each bar before  [mm]"
set samples 2000
set grid lt 1 lc rgb "#dddddd"
set key bottom right samplen 3
v = 0.05                # m/s = mm/ms
c = sqrt(1200)          # m/s = mm/us
L = 1000/c              # ms, for a wave through a bar
first = 2/v             # ms, when the first collision begins
second = first + L + 2/v
# Moves at v until `a`, at v/2 until `b`, then at w; seen from time a
striker(t, a, b) = t < a ? v*t : t < b ? v*a + v/2*(t - a) : v*(a + b)/2
struck(t, a, b) = t < a ? 0 : t < b ? v/2*(t - a) : v/2*(b - a) + v*(t - b)
firstLeft(t) = striker(t, first + L, first + L)
firstRight(t) = striker(t, first, first + 2*L)
secondLeft(t) = t < second + L ? struck(t, first, first + 2*L) \
    : struck(second + L, first, first + 2*L)
secondRight(t) = t < first + L ? 0 \
    : striker(t - first - L, second - first - L, second + L - first)
thirdLeft(t) = struck(t, second, second + 2*L)
thirdRight(t) = struck(t, second + L, second + L)
file = "postProcessing/ends/0/displacement.dat"
exact = "with lines lw 2 lc rgb '#21918c'"
dots = "with points pt 6 ps 0.6 lc rgb"
plot firstLeft(x) @exact title "exact", \
    firstRight(x) @exact notitle, \
    secondLeft(x) + 2 @exact notitle, \
    secondRight(x) + 2 @exact notitle, \
    thirdLeft(x) + 4 @exact notitle, \
    thirdRight(x) + 4 @exact notitle, \
    file every 8 using ($1*1e3):($2*1e3) @dots '#440154' title "left ends", \
    file every 8 using ($1*1e3):($20*1e3 + 2) @dots '#440154' notitle, \
    file every 8 using ($1*1e3):($38*1e3 + 4) @dots '#440154' notitle, \
    file every 8 using ($1*1e3):($14*1e3) @dots '#e07020' title "right ends", \
    file every 8 using ($1*1e3):($32*1e3 + 2) @dots '#e07020' notitle, \
    file every 8 using ($1*1e3):($50*1e3 + 4) @dots '#e07020' notitle
