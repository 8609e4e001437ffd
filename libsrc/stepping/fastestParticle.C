#include "stepping/fastestParticle.H"

#include <cmath>
#include <fmt/format.h>

namespace gpuFsi
{

fastestParticle fastestOf(const hostState& s)
{
    fastestParticle f;
    for (std::size_t i = 0; i < s.fluid.size(); ++i)
    {
        const vector& u = s.fluid.U[i];
        const double speed = std::sqrt(dot(u, u));
        if (speed > f.speed)
        {
            const std::int64_t id =
                s.partial ? std::int64_t(s.fluidId[i]) : std::int64_t(i);
            f = {speed, id, s.fluid.positions[i]};
        }
    }
    return f;
}


std::string describeGrowth
(
    const energyBudget& budget,
    const fastestParticle& f
)
{
    return fmt::format
    (
        "the fluid's kinetic energy is {:.3g} J/kg, but its start and all work "
        "since gave {:.3g} J/kg at most; it grew {:.4g}-fold a step in the "
        "last ones. Fastest is fluid particle {} at ({:.9g} {:.9g} {:.9g}), "
        "{:.4g} m/s", budget.kinetic(), budget.given(), budget.growth(), f.id,
        f.x.x, f.x.y, f.x.z, f.speed
    );
}

} // namespace gpuFsi
