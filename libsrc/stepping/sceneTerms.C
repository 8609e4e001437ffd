#include "stepping/sceneTerms.H"

#include <algorithm>
#include <fmt/format.h>

namespace gpuFsi
{

namespace
{

//- Terms in use and left out
struct termLists
{
    std::string in, out;

    void sort(bool used, const char* term)
    {
        std::string& list = used ? in : out;
        list += list.empty() ? term : std::string(", ") + term;
    }
};

void sortFluid
(
    termLists& terms,
    const fluidProperties& properties,
    const particleSchemes& schemes,
    const domain& d
)
{
    terms.sort(true, "pressure");
    terms.sort
    (
        properties.mu > 0,
        schemes.superSteps ? "viscosity in super-steps" : "viscosity"
    );
    const bodyForce& g = properties.g;
    terms.sort(g.acts(), g.varies() ? "body force in time" : "gravity");
    terms.sort(!d.walls.empty(), "walls");
    terms.sort(properties.wallsMove(), "wall motion");
    terms.sort(properties.wallsSlip(), "slip");
    using weight = particleSchemes::weight;
    terms.sort(schemes.areaWeights == weight::moment, "area weights");
    terms.sort(schemes.needsGradients(), "gradients");
    terms.sort(schemes.dissipation > 0, "dissipation");
    terms.sort(schemes.shifting > 0, "shifting");
}

void sortSolids(termLists& terms, const solidProperties& p)
{
    const auto some = [&](const auto& has)
    {
        return std::any_of(p.materials.begin(), p.materials.end(), has);
    };
    using material = const solidMaterial&;
    terms.sort(some([](material m) { return m.kappa != 0; }), "volume change");
    terms.sort
    (
        some([](material m)
        {
            return m.dashpot > 0 || m.friction > 0 || m.viscous > 0;
        }),
        "damping"
    );
    terms.sort(some([](material m) { return m.breakStrain > 0; }),
        "breaking bonds");
    terms.sort(p.contact.active, "contact");
}

} // namespace

std::string sceneTerms
(
    const fluidProperties& properties,
    const particleSchemes& schemes,
    const domain& d,
    const solidScene* solids
)
{
    termLists terms;
    if (d.hasFluid())
    {
        sortFluid(terms, properties, schemes, d);
    }
    else
    {
        terms.sort(false, "fluid");
    }
    terms.sort(solids != nullptr, "elastic solids");
    if (solids)
    {
        sortSolids(terms, solids->properties);
    }
    return terms.in + "; left out: "
      + (terms.out.empty() ? "nothing" : terms.out);
}


std::string describe(const memoryShares& shares, double n)
{
    std::string text;
    for (const auto& [name, bytes] : shares)
    {
        if (bytes > 0)
        {
            text += fmt::format
            (
                "{}{} {:.1f}", text.empty() ? "" : ", ", name, bytes/n
            );
        }
    }
    return text;
}

} // namespace gpuFsi
