#!/bin/bash
# A tiny study of the pulse: orders, range of the repeats, a variant that fails,
# going on after an interruption, curves laid over
. "$(dirname "$0")/../tutorials/functions.sh"

copyCase acousticPulse pulse
cat > "$work/pulse/system/studyDict" << 'EOF'
commands    ("seedParticles" "gpuFsiFoam");
error       { functionObject pulseError; }
repeats     2;
targets     (0.05 0.001);
resolution  h;
parameters
{
    scheme
    {
        entry       "system/particleSchemes:areaWeights";
        values      (radial moment momentum);
    }
    h
    {
        entry       "system/seedParticlesDict:spacing";
        values      (1.25 0.9375);
    }
}
EOF
program=$FSI_BUILD/bin/errorVsRunTime
study=$work/pulse/study

# column CURVE H NAME: of the table
column()
{
    awk -F, -v curve="$1" -v h="$2" -v name="$3" '
        NR == 1 { for (i = 1; i <= NF; ++i) at[$i] = i }
        $1 == curve && $2 == h { print $at[name] }' "$study/errorVsRunTime.csv"
}

"$program" -case "$work/pulse" > "$work/log.first" 2>&1
expect "exit code where variants failed" $? "==" 1
expect "variants named as failed" "$(grep -c FAILED "$work/log.first")" "==" 2
expect "with what the solver said" \
    "$(grep -c 'did you mean moment' "$work/log.first")" ">=" 2
expect "progress with the time to finish" \
    "$(grep -c 'to finish' "$work/log.first")" "==" 8
coarse=$(column radial 1.25 error)
fine=$(column radial 0.9375 error)
expect "order in the table less order of its errors" \
    "$(awk -v a="$(column radial 0.9375 order)" \
        -v b="$(order "$coarse" "$fine" 1.333333333)" \
        'BEGIN { printf "%.6f\n", (a - b)^2 }')" "<=" 1e-6
own=$(relativeL2 "pulse/study/scheme=radial_h=0.9375" pulseError 1.2)
expect "relative difference from the variant's own error" \
    "$(relativeError "$fine" "$own")" "<=" 1e-6
expect "repeats" "$(column moment 1.25 repeats)" "==" 2
expect "median less the least" \
    "$(awk -v m="$(column moment 1.25 seconds)" \
        -v l="$(column moment 1.25 secondsLeast)" 'BEGIN { print m - l }')" \
    ">=" 0
for file in csv md gp
do
    isFile pulse/study/errorVsRunTime.$file
done
if command -v gnuplot > /dev/null
then
    isFile pulse/study/errorVsRunTime.svg
    isFile pulse/study/errorVsRunTime.png
fi

# Interrupted in the last round: only what is missing runs
sed -i '$d' "$study/scheme=moment_h=1.25.runs.dat"
sed -i 's/ momentum)/)/' "$work/pulse/system/studyDict"
"$program" -case "$work/pulse" > "$work/log.second" 2>&1
expect "exit code" $? "==" 0
expect "runs done after the interruption" \
    "$(grep -c 'to finish' "$work/log.second")" "==" 1

# Runs of a variant that differ are warned of
sed -i '/^#/! s/^[^\t]*/0.5/' "$study/scheme=moment_h=1.25.runs.dat"
sed -i '$d' "$study/scheme=moment_h=1.25.runs.dat"
"$program" -case "$work/pulse" > "$work/log.differ" 2>&1
expect "exit code" $? "==" 0
expect "warning" "$(grep -c 'its runs differ in error: 0.5 and' \
    "$work/log.differ")" "==" 1

# So are errors at different times
awk -F '\t' -v OFS='\t' '!/^#/ { $8 = 0.5 } { print }' \
    "$study/scheme=moment_h=1.25.runs.dat" > "$work/runs.dat"
cp "$work/runs.dat" "$study/scheme=moment_h=1.25.runs.dat"
"$program" -case "$work/pulse" -tableOnly > "$work/log.times" 2>&1
expect "exit code" $? "==" 0
expect "warning" "$(grep -c 'is that at Time = 0.5, but' "$work/log.times")" \
    "==" 1

# Whatever changes the result makes the record void
setEntry pulse/constant/fluidProperties mu 0.5
"$program" -case "$work/pulse" -tableOnly > "$work/log.third" 2>&1
expect "exit code without results" $? "==" 1
setEntry pulse/constant/fluidProperties "mu" "1"
expect "message" "$(grep -c 'No variant has a result' "$work/log.third")" \
    "==" 1

printf 'curve,error,seconds,machine\npeer,0.01,2,far away\n' \
    > "$work/peer.csv"
"$program" -case "$work/pulse" -compare "$work/peer.csv,$work/peer.csv" \
    > "$work/log.fourth" 2>&1
expect "exit code with a peer" $? "==" 0
expect "machine of the peer named" \
    "$(grep -c 'Machine: far away' "$study/errorVsRunTime.md")" "==" 2
expect "targets told" \
    "$(grep -c '| moment | .* | not reached |' "$study/errorVsRunTime.md")" \
    "==" 1

# What a command prints, with the cost from the solver's log: the whole program
# takes longer than its loop, by parts of a second
rm -rf "$study"
cat > "$work/pulse/system/studyDict" << 'EOF'
title       printed;
commands    ("seedParticles" "gpuFsiFoam");
error       { command "echo 1.1"; exact 1; }
cost        total;
repeats     1;
parameters
{
    h
    {
        entry       "system/seedParticlesDict:spacing";
        values      (1.25);
    }
}
EOF
"$program" -case "$work/pulse" > "$work/log.printed" 2>&1
expect "exit code" $? "==" 0
total=$(column printed 1.25 totalSeconds)
expect "cost less total seconds" "$(awk -v a="$total" \
    -v b="$(column printed 1.25 seconds)" 'BEGIN { print b - a }')" "==" 0
expect "total seconds less those of the loop" "$(awk -v a="$total" \
    -v b="$(column printed 1.25 loopSeconds)" 'BEGIN { print a - b }')" ">=" 1e-3
expect "ranks" "$(column printed 1.25 ranks)" "==" 1
exit "$failures"
