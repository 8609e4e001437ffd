#include "exact/column.H"

#include <cmath>
#include <limits>

namespace gpuFsi
{

namespace
{

constexpr double huge = std::numeric_limits<double>::max();
constexpr double tiny = std::numeric_limits<double>::min();

} // namespace


column::column
(
    const dictionary& dict,
    const fluidConstants& fluid,
    bool endless
)
:
    origin(dict.getOrDefault<vector>("origin", {0, 0, 0})),
    direction(dict.getOrDefault<vector>("direction", {1, 0, 0})),
    length(endless ? 0 : dict.getNumber("length", tiny, huge)),
    rho0(dict.getNumberOrDefault("rho0", fluid.rho0, tiny, huge)),
    c(dict.getNumberOrDefault("c", fluid.c, tiny, huge)),
    nu(dict.getNumberOrDefault("nu", fluid.nu, 0, huge))
{
    const double norm = std::sqrt(dot(direction, direction));
    if (!(norm > 0))
    {
        throw userError
        (
            "direction (0 0 0) does not point anywhere",
            dict.where("direction"),
            "Give the axis from the wall into the fluid, e.g. (1 0 0)."
        );
    }
    direction = (1/norm)*direction;
}

} // namespace gpuFsi
