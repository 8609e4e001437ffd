#include "solid/contactProperties.H"

#include <algorithm>
#include <fmt/format.h>
#include <limits>

namespace gpuFsi
{

static constexpr dimensionSet dimLength{0, 1, 0, 0, 0, 0, 0};


contactProperties contactProperties::read
(
    const dictionary& dict,
    const std::vector<std::string>& solids
)
{
    contactProperties p;
    if (!dict.found("contact"))
    {
        return p;
    }
    if (std::find(solids.begin(), solids.end(), "contact") != solids.end())
    {
        throw userError
        (
            "A solid is called contact, as the dictionary of their contact is",
            dict.where("contact"),
            "Seed the solid under another name."
        );
    }
    const dictionary& d = dict.subDict("contact");
    const double unlimited = std::numeric_limits<double>::max();
    p.where = d.where();
    p.active = d.getOrDefault("active", true);
    p.stiffness = d.getNumberOrDefault("stiffness", 1, 1e-3, 1e3);
    p.friction = d.getNumberOrDefault("friction", 0, 0, unlimited);
    p.damping = d.getNumberOrDefault("damping", 0, 0, 1);
    p.walls = d.getOrDefault("walls", true);
    if (d.found("gap"))
    {
        p.gap = d.getDimensioned("gap", dimLength);
    }
    if (p.gap && !(*p.gap >= 0))
    {
        throw userError
        (
            fmt::format("gap is {:g} m, but must not be negative", *p.gap),
            d.where("gap")
        );
    }
    p.margin = d.found("margin") ? d.getPositive("margin", dimLength) : 0;
    return p;
}

} // namespace gpuFsi
