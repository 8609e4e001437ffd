# For the tests of the tutorial flexibleFlap; after functions.sh

# setRows CASE ROWS: of the fluid; edges of the flap's cells of 0.8 h
setRows()
{
    setEntry "$1/system/seedParticlesDict" rows "$2"
    setEntry "$1/system/seedParticlesDict" cells $(($2/4))
    setEntry "$1/system/controlDict" deltaT \
        "$(awk -v rows="$2" 'BEGIN { printf "%.12g", 0.04/rows }')"
}

# swung CASE WHAT: a figure of the case's Allswing
swung()
{
    "$work/$1/Allswing" | awk -v what="$2" '$1 == what { print $2 }'
}

# expectSwing CASE OTHERWAY: settled, with the force, even, losing energy;
# half a period later the tip is as far on the other side to within OTHERWAY
expectSwing()
{
    expect "$1: amplitude, m, of a flap of 0.5 m" \
        "$(swung "$1" amplitude)" ">=" 0.15
    expect "$1: error of the period" \
        "$(relativeError "$(swung "$1" period)" 4)" "<=" 0.01
    expect "$1: other way half a period later, of the amplitude" \
        "$(swung "$1" halfPeriod)" "<=" "$2"
    expect "$1: one corner less the other, of the amplitude" \
        "$(swung "$1" asymmetry)" "<=" 0.03
    expect "$1: energy gained beyond the work, J" \
        "$(swung "$1" greatestGain)" "<=" 1e-6
    expect "$1: rows of the ledger" "$(swung "$1" rows)" ">=" 80
}
