# One bar of immersedBar.sh and immersedBarLong.sh; after coupled.sh

# bar RHO ROWS PERIODS
bar()
{
    local name=rho$1
    local condition="2*$1*sin(w/8)/cos(w/8) - cos(w)/sin(w)"
    copyCase immersedBar "$name"
    setEntry "$name/system/density" rho "$1"
    setEntry "$name/system/resolution" rows "$2"
    setEntry "$name/system/controlDict" periods "$3"
    run "$name" || exit 1
    expect "error of the frequency, rho = $1, $2 rows" \
        "$(fitError "$name" "$(bisect "$condition" 1e-6 1.5707)")" "<=" 0.015
    expect "greatest energy over the first, $3 periods" \
        "$(energyPeak "$name")" "<=" 1.02
}
