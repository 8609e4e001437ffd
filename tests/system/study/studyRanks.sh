#!/bin/bash
# A study whose values are numbers of ranks, as the guide page has it: the same
# errors to the last digit, costs told by ranks
here=$(dirname "$0")
. "$here/../tutorials/functions.sh"
. "$here/../parallel/ranks.sh"

copyCase acousticPulse pulse
cat > "$work/pulse/system/decomposeParDict" << 'EOF'
numberOfSubdomains 1;
method hilbert;
EOF
cat > "$work/pulse/system/studyDict.ranks" << 'EOF'
title       "on ranks";
commands
(
    "seedParticles"
    "if [ $ranks = 1 ]; then gpuFsiFoam; exit; fi"
    "decomposeParticles"
    "mpirun -np $ranks gpuFsiFoam -parallel"
);
error       { functionObject pulseError; }
repeats     1;
resolution  h;
parameters
{
    ranks
    {
        entry       "system/decomposeParDict:numberOfSubdomains";
        values      (1 2);
    }
    h
    {
        entry       "system/seedParticlesDict:spacing";
        values      (1.25 0.9375);
    }
}
EOF
"$FSI_BUILD/bin/errorVsRunTime" -case "$work/pulse" \
    -dict system/studyDict.ranks > "$work/log.ranks" 2>&1
expect "exit code" $? "==" 0

# column RANKS H NAME: of the table
column()
{
    awk -F, -v curve="ranks $1" -v h="$2" -v name="$3" '
        NR == 1 { for (i = 1; i <= NF; ++i) at[$i] = i }
        $1 == curve && $2 == h { print $at[name] }' \
        "$work/pulse/study.ranks/errorVsRunTime.csv"
}

for h in 1.25 0.9375
do
    for ranks in 1 2
    do
        expect "ranks told, of $ranks" "$(column $ranks $h ranks)" "==" $ranks
        expect "seconds, on $ranks" "$(column $ranks $h seconds)" ">" 0
    done
    expect "error on 2 ranks less that on 1, h = $h" \
        "$(awk -v a="$(column 2 $h error)" -v b="$(column 1 $h error)" \
            'BEGIN { print a - b }')" "==" 0
    expect "particle-steps on 2 ranks less those on 1" \
        "$(awk -v a="$(column 2 $h particleSteps)" \
            -v b="$(column 1 $h particleSteps)" 'BEGIN { print a - b }')" "==" 0
done
expect "table names the ranks" "$(grep -c ' on 2 ranks, ' \
    "$work/pulse/study.ranks/errorVsRunTime.md")" "==" 1
exit "$failures"
