#!/bin/bash
# A tiny map of the pulse: classes, boundaries, going on, what users get wrong
. "$(dirname "$0")/../tutorials/functions.sh"

copyCase acousticPulse pulse
program=$FSI_BUILD/bin/stabilityMap
map=$work/pulse/studyStability
dict=$work/pulse/system/stabilityDict

cat > "$dict" << 'DICT'
commands    ("seedParticles" "gpuFsiFoam");
timeLimit   60;
error       { functionObject pulseError; limit 0.08; }
parameters
{
    dt
    {
        entries
        (
            "system/controlDict:deltaT"
            "system/controlDict:allowUnstable"
        );
        choices { "0.02" (0.02 no); "2" (2 no); "0.6" (0.6 yes); }
    }
    h
    {
        entry       "system/seedParticlesDict:spacing";
        values      (1.25 0.9375);
    }
    OMP_NUM_THREADS { values (1); }
}
skip { one { h 0.9375; dt 0.6; } }
DICT

# classOf H DT: from the table
classOf()
{
    awk -F, -v h="$1" -v dt="$2" '$2 == h && $1 == dt { print $4 }' \
        "$map/stabilityMap.csv"
}

"$program" -case "$work/pulse" > "$work/log.first" 2>&1
expect "exit code" $? "==" 0
expect "runs" "$(grep -c 'to finish' "$work/log.first")" "==" 5
expect "small steps are accurate" \
    "$(classOf 0.9375 0.02 | grep -c '^accurate')" "==" 1
expect "too long a step is refused" \
    "$(classOf 1.25 2 | grep -c refused)" "==" 1
expect "it says which limit" \
    "$(grep -c 'and 1 more: refused: .*limit' "$map/stabilityMap.md")" "==" 1
expect "allowed all the same, it ends as it may" \
    "$(classOf 1.25 0.6 | grep -c 'accurate\|stopped')" "==" 1
expect "boundary" "$(grep -c 'accurate to 0.02; refused from 2' \
    "$map/stabilityMap.md")" "==" 1
if command -v gnuplot > "$work/log"
then
    expect "bytes of the picture" "$(stat -c %s "$map/stabilityMap.png")" \
        ">=" 4000
fi
"$program" -case "$work/pulse" > "$work/log" 2>&1
expect "nothing is run twice" "$(grep -c '0 to do, 5 kept' "$work/log")" "==" 1

# fails TEXT DICT [OPTIONS]: with this dictionary it says so
fails()
{
    local text=$1
    echo "$2" > "$dict"
    shift 2
    "$program" -case "$work/pulse" "$@" > "$work/log" 2>&1
    expect "$text: exit code" $? "==" 1
    expect "said so" "$(grep -c "$text" "$work/log")" ">=" 1
}

run='commands ("seedParticles" "gpuFsiFoam");'
error='error { functionObject pulseError; limit 1; }'
h='h { entry "system/seedParticlesDict:spacing"; values (1.25); }'
fails "Entry 'limit' not found" \
    "$run error { functionObject pulseError; } parameters { $h }"
fails "Entry 'commands' not found" "$error parameters { $h }"
fails "Unknown parameter" "$run $error parameters { $h } y k;"
fails "how many" "$run $error parameters { h { linear (1 2); } }"
fails "No variant has been run" "$run $error parameters { $h }
    directory study.none;" -tableOnly
fails "Give one of them" "$run $error parameters { $h }" -tableOnly -force
# As none may end: said, and run again
nan='mkdir postProcessing; echo 1 -nan > postProcessing/x.dat'
for how in 'crashed:kill -SEGV $$' 'hung:sleep 20' 'failed:exit 3' \
    'failed:true' "diverged:$nan"
do
    fails "h=1.25: ${how%%:*}" "commands (\"${how#*:}\");
        timeLimit 0.5; $error parameters { $h }"
    "$program" -case "$work/pulse" > "$work/log" 2>&1
    expect "run again" "$(grep -c '1 to do' "$work/log")" "==" 1
done

# Those of the tutorials are read to the last key
while read -r file
do
    "$program" -case "${file%/system/*}" -list -dict "system/${file##*/}" \
        > "$work/log" 2>&1
    expect "$file: exit code" $? "==" 0
    expect "warnings" "$(grep -c Warning "$work/log")" "==" 0
done < <(find "$tutorials" -path '*/system/stabilityDict*')
exit "$failures"
