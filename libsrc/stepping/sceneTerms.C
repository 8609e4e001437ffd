#include "stepping/sceneTerms.H"

namespace gpuFsi
{

std::string sceneTerms
(
    const fluidProperties& properties,
    const particleSchemes& schemes,
    bool walls,
    bool solids
)
{
    std::string in = "pressure", out;
    const auto sort = [&](bool used, const char* term)
    {
        std::string& list = used ? in : out;
        list += list.empty() ? term : std::string(", ") + term;
    };
    sort(properties.mu > 0, "viscosity");
    const bodyForce& g = properties.g;
    sort(g.acts(), g.varies() ? "body force in time" : "gravity");
    sort(walls, "walls");
    sort(properties.wallsMove(), "wall motion");
    sort(properties.wallsSlip(), "slip");
    sort(schemes.dissipation > 0, "dissipation");
    sort(schemes.shifting > 0, "shifting");
    sort(solids, "elastic solids");
    return in + "; left out: " + (out.empty() ? "nothing" : out);
}

} // namespace gpuFsi
