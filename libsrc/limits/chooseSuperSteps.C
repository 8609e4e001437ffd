#include "limits/chooseSuperSteps.H"

#include "stepping/latticeViscosity.H"

#include <fmt/format.h>
#include <limits>

namespace gpuFsi
{

//- Of the acoustic limit, from which on explicit viscosity costs more: with r
//  explicit steps in one, each as dear as two stages of its about 1.4 sqrt(r)
//  in either half, 1 + 1.4 sqrt(r) < r
static constexpr double share = 0.25;

double explicitViscousLimit
(
    const particleSchemes& schemes,
    const flowScales& s
)
{
    if (!(s.nu > 0))
    {
        return std::numeric_limits<double>::infinity();
    }
    const auto even =
        latticeViscosity::of(s.dimensions, schemes.weightExponent);
    return even.limit()*s.h*s.h/s.nu;
}


std::string chooseSuperSteps
(
    particleSchemes& schemes,
    const flowScales& s,
    std::optional<double> deltaT
)
{
    using choice = particleSchemes::superStepping;
    const choice wanted = schemes.superTimeStepping;
    schemes.superSteps = false;
    if (!(s.nu > 0) || !schemes.canSuperStep() || wanted == choice::off)
    {
        return "";
    }
    const double viscous = explicitViscousLimit(schemes, s);
    if (wanted == choice::automatic && deltaT && *deltaT <= viscous)
    {
        return "";
    }
    particleSchemes split = schemes;
    split.superSteps = true;
    const double acoustic = acousticLimit(split, s);
    schemes.superSteps =
        wanted == choice::on || viscous < share*acoustic;
    return schemes.superSteps
      ? fmt::format
        (
            "viscous limit {:.3g} s, acoustic {:.3g} s", viscous, acoustic
        )
      : "";
}

} // namespace gpuFsi
