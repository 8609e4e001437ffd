#include "limits/termLimits.H"

#include "limits/couplingLimit.H"

#include <algorithm>

namespace gpuFsi
{

static constexpr double infinite = std::numeric_limits<double>::infinity();

std::vector<termLimit> plainLimits(const caseScales& s)
{
    const flowScales& f = s.flow;
    return
    {
        {"convective", convectiveLimit(f.h, s.relativeSpeed)},
        {"bodyForce", bodyForceLimit(f.h, s.force)},
        {
            "spring",
            s.solid.subSteps > 0
          ? springLimit(s.solid.omegaMax, s.solid.subSteps) : infinite
        },
        {
            "coupling",
            f.c > 0 && s.solid.massPerArea < infinite
          ? couplingLimit(f.h, f.c, s.rho, s.solid.massPerArea) : infinite
        },
        {
            "viscousCoupling",
            f.nu > 0 && s.solid.massPerArea < infinite
          ? viscousCouplingLimit
            (
                f.h, s.rho*f.nu, s.rho, s.solid.massPerArea
            )
          : infinite
        }
    };
}


std::vector<termLimit> termLimits
(
    const particleSchemes& schemes,
    const caseScales& s,
    double growth
)
{
    std::vector<termLimit> limits
    {
        {"acoustic", acousticLimit(schemes, s.flow, growth)},
        {"viscous", viscousLimit(schemes, s.flow, growth)}
    };
    const std::vector<termLimit> plain = plainLimits(s);
    limits.insert(limits.end(), plain.begin(), plain.end());
    return limits;
}


//- acoustic takes viscosity along: where that alone would limit as much, it
//  is viscosity that does
static bool viscosityLimits
(
    const std::vector<termLimit>& limits,
    const termLimit& least
)
{
    return std::any_of
    (
        limits.begin(), limits.end(),
        [&](const termLimit& l)
        {
            return std::string(l.term) == "viscous"
             && l.deltaT < 1.1*least.deltaT;
        }
    );
}


termLimit shortest(const std::vector<termLimit>& limits)
{
    termLimit least = *std::min_element
    (
        limits.begin(), limits.end(),
        [](const termLimit& a, const termLimit& b)
        {
            return a.deltaT < b.deltaT;
        }
    );
    if
    (
        std::string(least.term) == "acoustic"
     && viscosityLimits(limits, least)
    )
    {
        least.term = "viscous";
    }
    return least;
}


std::optional<termLimit> exceeded
(
    const particleSchemes& schemes,
    const caseScales& s,
    double dt,
    double growth
)
{
    std::vector<termLimit> limits = plainLimits(s);
    if (dt > s.solid.implicitBeyond)
    {
        limits.erase
        (
            std::remove_if
            (
                limits.begin(), limits.end(),
                [](const termLimit& l)
                {
                    return std::string(l.term) == "spring";
                }
            ),
            limits.end()
        );
    }
    if (s.flow.c > 0 && growthOf(schemes, s.flow, dt) > growth)
    {
        limits.push_back({"viscous", viscousLimit(schemes, s.flow, growth)});
        limits.push_back({"acoustic", acousticLimit(schemes, s.flow, growth)});
    }
    const termLimit least = shortest(limits);
    return dt > least.deltaT*(1 + 1e-6)
      ? std::optional<termLimit>(least) : std::nullopt;
}

} // namespace gpuFsi
