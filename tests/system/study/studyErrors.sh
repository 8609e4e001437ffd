#!/bin/bash
# What users get wrong in a study: exit code 1, and a message that helps
. "$(dirname "$0")/../tutorials/functions.sh"

copyCase acousticPulse pulse
program=$FSI_BUILD/bin/errorVsRunTime
h='h { entry "system/seedParticlesDict:spacing"; values (1.25); }'
error='error { functionObject pulseError; }'
run='commands ("seedParticles" "gpuFsiFoam"); repeats 1;'

# fails TEXT STUDY [OPTIONS]: with this studyDict it says so
fails()
{
    local text=$1
    echo "$2" > "$work/pulse/system/studyDict"
    shift 2
    "$program" -case "$work/pulse" "$@" > "$work/log" 2>&1
    expect "$text: exit code" $? "==" 1
    expect "said so" "$(grep -c "$text" "$work/log")" ">=" 1
}

fails "Entry 'commands' not found" "$error parameters { $h }"
fails "did you mean h" "$run $error parameters { $h } resolution H;"
fails "is no entry" \
    "$run $error parameters { h { entry spacing; values (1); } }"
fails "which is not there" "$run $error
    parameters { h { entry \"system/none:a\"; values (1); } }"
fails "left no cost.dat" \
    "$run error { functionObject other; } parameters { $h }"
fails "longer than timeLimit" \
    "commands (\"sleep 20\"); timeLimit 0.3; repeats 1; $error
     parameters { h { entry \"system/seedParticlesDict:spacing\";
     values (1.25 1); } }"
expect "finer ones left out" "$(grep -c 'left out, as h=1.25' "$work/log")" \
    ">=" 1
# Not tried again, but with a longer limit
slow='repeats 1; commands ("sleep 1"); parameters { h {
    entry "system/seedParticlesDict:spacing"; values (1.25 1); } }'
fails "longer than timeLimit, 0.2" "$slow $error timeLimit 0.2;"
fails "h=1.25: left out, as it took longer" "$slow $error timeLimit 0.1;"
expect "none was run" "$(grep -c "longer than timeLimit, 0.1" "$work/log")" \
    "==" 0
fails "left no cost.dat" "$slow $error timeLimit 20;"
fails "longer than timeLimit, 0.1" "$slow $error timeLimit 0.1;" -force
fails "printed no number" \
    "$run error { command \"echo word\"; exact 1; } parameters { $h }"
# The coarser run is not taken for the finest, which has failed
fails "left out, as the run at 1, " "repeats 1;
    commands (\"[ \$h = 1.25 ]\" \"seedParticles\" \"gpuFsiFoam\");
    error { command \"echo 2\"; finest yes; } parameters { h {
    entry \"system/seedParticlesDict:spacing\"; values (1.25 1); } }"
fails "'abc'" "$run $error
    parameters { h { entry \"system/controlDict:deltaT\"; values (abc); } }"
fails "to compare with" "$run $error parameters { $h }" -compare nowhere
fails "Give one of them" "$run $error parameters { $h }" -force -tableOnly
mkdir -p "$work/pulse/study"
exec 9> "$work/pulse/study/.lock"
flock 9
fails "Another program" "$run $error parameters { $h }"
exec 9>&-
fails "Invalid option" "$run $error parameters { $h }" -comparison x

# Those of the tutorials are read to the last key
for dict in "$tutorials"/*/system/studyDict*
do
    tutorial=$(basename "${dict%/system/*}")
    "$program" -case "$tutorials/$tutorial" -list \
        -dict "system/${dict##*/}" > "$work/log" 2>&1
    expect "$tutorial, ${dict##*/}: exit code" $? "==" 0
    expect "warnings" "$(grep -c Warning "$work/log")" "==" 0
done

# Ended from outside: so are its commands; the next call goes on
echo "repeats 2; $error parameters { h {
    entry \"system/seedParticlesDict:spacing\"; values (1.25); } }
    commands (\"seedParticles\" \"gpuFsiFoam\"
    \"if [ -f ../slow ]; then echo \\$\\$ > ../child; exec sleep 60; fi\");" \
    > "$work/pulse/system/studyDict"
rm -rf "$work/pulse/study"
mkdir "$work/pulse/study"
touch "$work/pulse/study/slow"
"$program" -case "$work/pulse" > "$work/log" 2>&1 &
id=$!
for ((i = 0; i < 200; ++i))
do
    [ -s "$work/pulse/study/child" ] && break
    sleep 0.1
done
kill -TERM $id
wait $id
expect "exit code after SIGTERM" $? "==" 143
sleep 0.5
expect "commands left running" \
    "$(kill -0 "$(cat "$work/pulse/study/child")" 2> /dev/null && echo 1 \
        || echo 0)" "==" 0
rm "$work/pulse/study/slow"
"$program" -case "$work/pulse" > "$work/log" 2>&1
expect "exit code after going on" $? "==" 0

# Slips that do not stop a study are warned of
echo "$run $error parameters { $h } repeat 3;
    parameters { other { entry \"system/particleSchemes:face\";
    values (hermite); } }" > "$work/pulse/system/studyDict"
"$program" -case "$work/pulse" > "$work/log" 2>&1
expect "exit code" $? "==" 0
expect "unread key of the study" "$(grep -c "'repeats' meant" "$work/log")" \
    "==" 1
expect "key that the solver does not read" \
    "$(grep -c "Warning.*Unused entry 'face'" "$work/log")" "==" 1
exit "$failures"
