#include "limits/stepLimits.H"

#include "limits/wallRows.H"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gpuFsi
{

static constexpr double infinite = std::numeric_limits<double>::infinity();

//- Logarithm of what a step makes of a wave that viscosity slows, z = dt
//  times its rate
static double viscousGrowth(particleSchemes::timeScheme scheme, double z)
{
    const double factor = scheme == particleSchemes::timeScheme::RK2
      ? 1 - z + 0.5*z*z : 1 - z;
    return std::log(std::abs(factor));
}


//- Where rows beside walls are stiffer than those between
static double growthBesideWalls
(
    const particleSchemes& schemes,
    const flowScales& s,
    double diffusion
)
{
    // Displaced particles stand nearer here and there, no whole row does
    constexpr double least = 0.5;
    const bool none = s.wallGap == 0 || s.wallGap >= 1 || diffusion == 0;
    return none || schemes.superSteps ? 0 : viscousGrowth
    (
        schemes.time,
        diffusion*wallRowsRate
        (
            schemes, s.dimensions, std::max(least, s.wallGap)
        )
    );
}


double growthOf
(
    const particleSchemes& schemes,
    const flowScales& s,
    double dt
)
{
    const stepNumbers step{s.c*dt/s.h, s.nu*dt/(s.h*s.h)};
    return std::max
    (
        logAmplification(schemes, s.dimensions, step),
        growthBesideWalls(schemes, s, step.diffusion)
    );
}


//- Largest dt below `high`, which is unstable
static double bisect
(
    const particleSchemes& schemes,
    const flowScales& s,
    double high,
    double growth
)
{
    constexpr int halvings = 24;
    double low = 0;
    for (int k = 0; k < halvings; ++k)
    {
        const double middle = 0.5*(low + high);
        (growthOf(schemes, s, middle) > growth ? high : low) = middle;
    }
    return low;
}


//- Beyond these numbers every scheme is unstable
static constexpr stepNumbers beyond{5, 4};

double acousticLimit
(
    const particleSchemes& schemes,
    const flowScales& s,
    double growth
)
{
    return s.c > 0
      ? bisect(schemes, s, beyond.acoustic*s.h/s.c, growth) : infinite;
}


double viscousLimit
(
    const particleSchemes& schemes,
    const flowScales& s,
    double growth
)
{
    flowScales still = s;
    still.c = 0;
    return s.nu > 0 && !schemes.superSteps
      ? bisect(schemes, still, beyond.diffusion*s.h*s.h/s.nu, growth)
      : infinite;
}


double convectiveLimit(double h, double relativeSpeed)
{
    return relativeSpeed > 0 ? h/relativeSpeed : infinite;
}


double bodyForceLimit(double h, double force)
{
    return force > 0 ? std::sqrt(h/force) : infinite;
}


double springLimit(double omegaMax, int subSteps)
{
    return omegaMax > 0 ? 2*subSteps/omegaMax : infinite;
}


} // namespace gpuFsi
