#!/bin/bash
# The driven cavity at Re 100 and 100^2 particles against Ghia's table
. "$(dirname "$0")/functions.sh"

copyCase lidDrivenCavity Re100
"$work/Re100/Allrun" || exit 1
while read -r line time worst where noise
do
    expect "largest difference $line at Time = $time, there at $where" \
        "$worst" "<=" 0.015
    echo "        departures from the mean of five lid times: $noise"
done < <("$work/Re100/Allcompare")
exit "$failures"
