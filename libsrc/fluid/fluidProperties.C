#include "fluid/fluidProperties.H"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace gpuFsi
{

namespace fs = std::filesystem;

static constexpr double unlimited = std::numeric_limits<double>::max();


static double soundSpeed(const dictionary& eos)
{
    if (eos.found("c") && eos.found("c2"))
    {
        throw userError
        (
            "Entries 'c' and 'c2' both give the sound speed",
            eos.where("c"),
            "Keep one of them."
        );
    }
    if (eos.found("c"))
    {
        return eos.getPositive("c", dimensions::velocity);
    }
    if (eos.found("c2"))
    {
        return std::sqrt(eos.getPositive("c2", {0, 2, -2, 0, 0, 0, 0}));
    }
    return 1/std::sqrt(3.0);    // eq (3)
}


static double viscosity(const dictionary& d, double rho0)
{
    if (d.found("mu") && d.found("nu"))
    {
        throw userError
        (
            "Entries 'mu' and 'nu' both give the viscosity",
            d.where("nu"),
            "Keep one of them."
        );
    }
    const double mu = d.found("nu")
      ? rho0*d.getDimensioned("nu", dimensions::kinematicViscosity)
      : d.getDimensioned("mu", dimensions::dynamicViscosity);
    if (mu < 0)
    {
        throw userError
        (
            fmt::format("The viscosity is {}, but must not be negative", mu),
            d.where(d.found("nu") ? "nu" : "mu")
        );
    }
    return mu;
}


static bool isSolid(const domain& d, std::size_t patch)
{
    return patch + d.solids.size() >= d.walls.size();
}


//- The surface of a solid goes where the solid goes
static void refuseMovedSolid
(
    const domain& d,
    std::size_t patch,
    const dictionary& wall
)
{
    if (isSolid(d, patch) && wall.found("type"))
    {
        throw userError
        (
            fmt::format
            (
                "'{}' is an elastic solid: its surface moves with it",
                d.walls[patch]
            ),
            wall.where("type"),
            "Drive a part of it in constant/solidProperties; here a solid's "
            "surface may only say 'slip yes;'."
        );
    }
}


static void readWalls
(
    const fs::path& casePath,
    const domain& d,
    fluidProperties& properties
)
{
    properties.motions.resize(d.walls.size());
    properties.slip.resize(d.walls.size(), false);
    const fs::path file = casePath/"constant"/"wallProperties";
    if (!fs::exists(file))
    {
        return;
    }
    const dictionary walls = dictionary::fromFile(file);
    for (std::size_t p = 0; p < d.walls.size(); ++p)
    {
        if (walls.found(d.walls[p]))
        {
            const dictionary& wall = walls.subDict(d.walls[p]);
            refuseMovedSolid(d, p, wall);
            if (!isSolid(d, p))
            {
                properties.motions[p] = wallMotion::make(wall);
            }
            properties.slip[p] = wall.getOrDefault("slip", false);
        }
    }
    walls.warnUnread();
}


static void readFluid(const fs::path& file, fluidProperties& p)
{
    using state = fluidProperties::state;
    const dictionary dict = dictionary::fromFile(file);
    p.rho0 = dict.found("rho0")
      ? dict.getPositive("rho0", dimensions::density)
      : 1;
    p.mu = viscosity(dict, p.rho0);

    const dictionary& eos = dict.subDict("equationOfState");
    const std::string word =
        eos.getChoice("type", {"isothermal", "linear", "Tait"});
    p.eos = word == "Tait" ? state::Tait
      : word == "linear" ? state::linear : state::isothermal;
    p.c = soundSpeed(eos);
    if (p.eos == state::Tait)
    {
        p.gamma = eos.getNumberOrDefault("gamma", 7, 1, unlimited);
    }
    dict.warnUnread();
}


fluidProperties fluidProperties::read
(
    const fs::path& casePath,
    const domain& d
)
{
    fluidProperties p;
    if (d.hasFluid())
    {
        readFluid(casePath/"constant"/"fluidProperties", p);
    }
    p.g = bodyForce::read(casePath);
    readWalls(casePath, d, p);
    return p;
}


double fluidProperties::pressure(double rho) const
{
    switch (eos)
    {
        case state::isothermal:
            return c*c*rho;

        case state::linear:
            return c*c*(rho - rho0);

        case state::Tait:
            break;
    }
    return rho0*c*c/gamma*std::expm1(gamma*std::log1p((rho - rho0)/rho0));
}


std::string fluidProperties::describe() const
{
    const char* word = eos == state::Tait ? "Tait"
      : eos == state::linear ? "linear" : "isothermal";
    return fmt::format("{}, c = {:.6g}, rho0 = {:.6g}", word, c, rho0);
}


bool fluidProperties::wallsMove() const
{
    for (const auto& m : motions)
    {
        if (m)
        {
            return true;
        }
    }
    return false;
}


bool fluidProperties::wallsSlip() const
{
    return std::find(slip.begin(), slip.end(), true) != slip.end();
}


bool fluidProperties::slips(int patch) const
{
    return std::size_t(patch) < slip.size() && slip[patch];
}

} // namespace gpuFsi
