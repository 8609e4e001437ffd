#include "checks.H"

#include "base/log.H"
#include "worstParticles.H"

#include <algorithm>
#include <array>
#include <cmath>

using namespace gpuFsi;

namespace
{

using timeScheme = particleSchemes::timeScheme;

constexpr std::array<const char*, 3> schemeNames
{
    "Euler", "symplecticEuler", "RK2"
};

particleSchemes with(particleSchemes s, std::size_t scheme)
{
    s.time = timeScheme(scheme);
    return s;
}

std::string number(double deltaT)
{
    return deltaT < std::numeric_limits<double>::infinity()
      ? fmt::format("{:.4g}", deltaT) : "-";
}

//- A line of the table; limits by time scheme
void printRow
(
    const std::string& term,
    const std::array<double, 3>& limits,
    bool radial,
    const std::string& by
)
{
    info
    (
        "    {:<16}{:>12}{:>18}{:>12}    {}", term, number(limits[0]),
        radial ? "" : number(limits[1]), number(limits[2]), by
    );
}

std::string solidName(const checkedCase& c, int node)
{
    const vector& x = c.solids->mesh.points[node];
    return fmt::format
    (
        "solid {} at ({:.4g} {:.4g} {:.4g})", node, x.x, x.y, x.z
    );
}

//- Prints the table
void printLocal
(
    const checkedCase& c,
    const checkedTime& t,
    const worstParticles& worst,
    const solidScales& solid
)
{
    const bool radial =
        c.schemes.areaWeights == particleSchemes::weight::radial;
    info("    {:<16}{:>12}{:>18}{:>12}    set by", "term", schemeNames[0],
        radial ? "" : schemeNames[1], schemeNames[2]);
    std::array<std::vector<termLimit>, 3> limits;
    for (std::size_t s = 0; s < limits.size(); ++s)
    {
        limits[s] = worst.limits(with(c.schemes, s), solid);
    }
    std::array<double, 3> least;
    for (std::size_t s = 0; s < limits.size(); ++s)
    {
        least[s] = shortest(limits[s]).deltaT;
    }
    for (std::size_t k = 0; k < limits[0].size(); ++k)
    {
        const std::string term = limits[0][k].term;
        const int node =
            term == "spring" ? worst.stiffest : worst.lightestNode;
        const std::string by = k < worst.fluid.size()
          ? (limits[0][k].deltaT < HUGE_VAL ? t.name(worst.fluid[k]) : "")
          : node >= 0 ? solidName(c, node) : "";
        printRow
        (
            term,
            {limits[0][k].deltaT, limits[1][k].deltaT, limits[2][k].deltaT},
            radial, by
        );
    }
    printRow("deltaT", least, radial, "");
}

//- What follows deltaT by itself, and what no limit knows of
void tellOfSubSteps
(
    const checkedCase& c,
    const solidScales& solid
)
{
    if (solid.subSteps == 0)
    {
        info
        (
            "    The solids' sub-steps follow deltaT; explicit ones are "
            "stable below {:.4g} s", springLimit(solid.omegaMax)
        );
    }
    const double halfPeriod = M_PI/solid.omegaMax;
    const bool wet = solid.massPerArea < HUGE_VAL;
    if (wet && c.deltaT > halfPeriod && c.deltaT < solid.implicitBeyond)
    {
        info
        (
            "    deltaT is longer than half a period of their highest "
            "frequency, {:.4g} s: they may resonate with the fluid's load",
            halfPeriod
        );
    }
}

//- On an even lattice, as gpuFsiFoam does
void checkDeltaT
(
    const checkedCase& c,
    const caseScales& whole,
    findings& found
)
{
    const termLimit least = shortest(termLimits(c.schemes, whole));
    info
    (
        "    On an even lattice: {}", least.deltaT < HUGE_VAL
      ? fmt::format("{:.4g} ({})", least.deltaT, least.term) : "no limit"
    );
    if (c.adjusts)
    {
        found.good("deltaT follows the limits (adjustTimeStep)");
        return;
    }
    const auto refused = exceeded(c.schemes, whole, c.deltaT, fastGrowth);
    if (refused)
    {
        found.bad
        (
            fmt::format
            (
                "deltaT {:.6g} of system/controlDict is beyond the limit "
                "({}): gpuFsiFoam refuses it", c.deltaT, refused->term
            )
        );
    }
    else if (exceeded(c.schemes, whole, c.deltaT))
    {
        info
        (
            "    deltaT {:.6g} of system/controlDict is beyond it: waves grow "
            "slowly", c.deltaT
        );
    }
    else
    {
        found.good(fmt::format("deltaT {:.6g} within the limits", c.deltaT));
    }
}

} // namespace


void checkSteps
(
    const checkedCase& c,
    const checkedTime& t,
    const neighbourRows* rows,
    findings& found
)
{
    info("Step limits, s");
    const worstParticles worst(c, t, rows);
    const solidScales solid = c.solids
      ? solidScalesOf(*c.solids, c.fluid, t.state, true) : solidScales{};
    printLocal(c, t, worst, solid);
    if (!c.whySuperSteps.empty())
    {
        info
        (
            "    Viscosity takes super-steps (RKL2): {}", c.whySuperSteps
        );
    }
    if (c.solids)
    {
        tellOfSubSteps(c, solid);
    }
    checkDeltaT(c, worst.wholeCase(solid), found);
}
