#!/bin/bash
# The pulse as users run it, pictures and all, and its order of convergence
. "$(dirname "$0")/functions.sh"

copyCase acousticPulse asItIs
"$work/asItIs/Allrun" || exit 1
expect "relative L2 at h = 15/64, dt = 0.02" \
    "$(relativeL2 asItIs pulseError 1.2)" "<=" 0.0035
isFile asItIs/asItIs.foam
isFile asItIs/postProcessing/yAxis/1.2/yAxis_rho.xy
command -v gnuplot > /dev/null && isFile asItIs/postProcessing/rhoAlongY.png
[ -x "$FSI_BUILD/bin/particlesToVTK" ] \
    && isFile asItIs/postProcessing/seeded.png

copyCase acousticPulse coarse
setEntry coarse/system/seedParticlesDict spacing 0.46875
coarse=$(solve coarse pulseError 1.2) || exit 1

copyCase acousticPulse fine
setEntry fine/system/controlDict deltaT 0.005
fine=$(solve fine pulseError 1.2) || exit 1
echo "relative L2: $coarse at h = 15/32, $fine at h = 15/64, dt/h^2 fixed"
expect "order" "$(order "$coarse" "$fine")" ">=" 1.9

"$work/asItIs/Allclean" || exit 1
expect "number of files that Allclean left beside the tutorial's own" \
    "$(diff -rq "$tutorials/acousticPulse" "$work/asItIs" \
        | grep -c "^Only in $work")" "<=" 0
exit "$failures"
