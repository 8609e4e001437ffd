#include "solid/contactProperties.H"

#include <algorithm>
#include <limits>

namespace gpuFsi
{

static constexpr dimensionSet dimLength{0, 1, 0, 0, 0, 0, 0};


static double lengthOf(const dictionary& d, const char* key)
{
    return d.found(key) ? d.getPositive(key, dimLength) : 0;
}


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
    p.active = d.getOrDefault("active", true);
    p.stiffness = d.getNumberOrDefault("stiffness", 1, 1e-3, 1e3);
    p.friction = d.getNumberOrDefault("friction", 0, 0, unlimited);
    p.damping = d.getNumberOrDefault("damping", 0, 0, 1);
    p.walls = d.getOrDefault("walls", true);
    p.gap = lengthOf(d, "gap");
    p.margin = lengthOf(d, "margin");
    return p;
}

} // namespace gpuFsi
