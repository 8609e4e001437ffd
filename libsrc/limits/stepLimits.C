#include "limits/stepLimits.H"

#include <cmath>
#include <limits>

namespace gpuFsi
{

static constexpr double infinite = std::numeric_limits<double>::infinity();

double growthOf
(
    const particleSchemes& schemes,
    const flowScales& s,
    double dt
)
{
    return logAmplification
    (
        schemes, s.dimensions, {s.c*dt/s.h, s.nu*dt/(s.h*s.h)}
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
