#include "exact/periodicFlow.H"

#include <cmath>
#include <limits>

namespace gpuFsi
{

periodicFlow::periodicFlow
(
    const dictionary& dict,
    const fluidConstants& fluid
)
:
    origin(dict.getOrDefault<vector>("origin", {0, 0, 0}))
{
    const double tiny = std::numeric_limits<double>::min();
    const double huge = std::numeric_limits<double>::max();
    k = 2*std::acos(-1.0)/dict.getNumberOrDefault("length", 1, tiny, huge);
    rho0 = dict.getNumberOrDefault("rho0", fluid.rho0, tiny, huge);
    c = dict.getNumberOrDefault("c", fluid.c, tiny, huge);
    nu = dict.getNumberOrDefault("nu", fluid.nu, 0, huge);
}

} // namespace gpuFsi
