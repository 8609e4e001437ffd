#!/bin/bash
# The grid schemes to compare with: second order in h and dt against the
# solution of the full equations, and the two agree
. "$(dirname "$0")/../tutorials/functions.sh"

export OMP_NUM_THREADS=1
program=$FSI_BUILD/bin/gridReference

# solveGrid SCHEME N DT: prints the relative L2 error
solveGrid()
{
    local name=$1$2
    copyCase acousticPulse "$name"
    cat > "$work/$name/system/gridDict" << EOF
scheme  $1;
n       $2;
length  15;
rho     "1 + 0.01*exp(-r^2/5)";
EOF
    setEntry "$name/system/controlDict" deltaT "$3"
    setEntry "$name/system/controlDict" writeControl none
    echo 'functions { pulseError { exact nonlinearPulse; } }' \
        >> "$work/$name/system/controlDict"
    "$program" -case "$work/$name" > "$work/$name/log.gridReference" 2>&1 \
        || tail -n 20 "$work/$name/log.gridReference" >&2
    relativeL2 "$name" pulseError 1.2
}

for scheme in finiteDifferences semiLagrangian
do
    coarse=$(solveGrid $scheme 16 0.04)
    fine=$(solveGrid $scheme 32 0.02)
    finest=$(solveGrid $scheme 48 0.01)
    echo "$scheme: relative L2 $coarse, $fine, $finest at 16^3, 32^3, 48^3"
    expect "$scheme: order 16 to 32" "$(order "$coarse" "$fine")" ">=" 1.8
    expect "$scheme: order 32 to 48" "$(order "$fine" "$finest" 1.5)" ">=" 1.85
    isFile "${scheme}16/postProcessing/pulseError/0/cost.dat"
done
expect "relative difference of the schemes' errors" \
    "$(relativeError "$(relativeL2 finiteDifferences32 pulseError 1.2)" \
        "$(relativeL2 semiLagrangian32 pulseError 1.2)")" "<=" 1e-3

# The same bytes on any number of threads
OMP_NUM_THREADS=3 "$program" -case "$work/semiLagrangian16" > /dev/null 2>&1
tables=$work/semiLagrangian16/postProcessing/pulseError/0
expect "errors on three threads as on one" \
    "$(cut -f 1-7 "$tables"/error*.dat \
        | sort | uniq -c | awk '$1 != 2' | wc -l)" "==" 0

# fails TEXT FILE KEY VALUE
fails()
{
    setEntry "semiLagrangian16/$2" "$3" "$4"
    "$program" -case "$work/semiLagrangian16" > "$work/log" 2>&1
    expect "$1: exit code" $? "==" 1
    expect "said so" "$(grep -c "$1" "$work/log")" ">=" 1
}
fails "did you mean semiLagrangian" system/gridDict scheme semiLagrangan
setEntry semiLagrangian16/system/gridDict scheme semiLagrangian
fails "'n'" system/gridDict n 2
setEntry semiLagrangian16/system/gridDict n 64
fails "Use a smaller deltaT" system/controlDict deltaT 0.1

# Without density all rates are 0/0: no number, which no maximum shows
setEntry semiLagrangian16/system/gridDict n 16
fails "velocity is no longer finite" system/gridDict rho '"0"'
setEntry semiLagrangian16/system/gridDict scheme finiteDifferences
fails "solution is not finite" system/gridDict rho '"0"'
exit "$failures"
