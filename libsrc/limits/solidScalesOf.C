#include "limits/solidScalesOf.H"

#include "coupling/touchedWalls.H"
#include "coupling/wallAcceleration.H"
#include "solid/elasticSolver.H"

#include <algorithm>

namespace gpuFsi
{

//- Explicit sub-steps beyond which solidProperties::scheme::automatic turns
//  implicit, each 0.8 of its limit (solid/springStepper.H)
static constexpr double mostExplicit = 1000*0.8;

static double leastMassPerArea(const solidScene& scene, const hostState& state)
{
    double least = std::numeric_limits<double>::infinity();
    if (state.wallNode.empty())
    {
        return least;
    }
    const std::vector<double> mass = yieldingMasses
    (
        scene.mesh, scene.properties,
        springNetwork::of(scene.mesh, scene.properties).mass
    );
    for (std::size_t i = 0; i < state.wallNode.size(); ++i)
    {
        if (state.wallNode[i] >= 0 && state.area[i] > 0)
        {
            least = std::min(least, mass[state.wallNode[i]]/state.area[i]);
        }
    }
    return least;
}


solidScales solidScalesOf
(
    const solidScene& scene,
    const fluidProperties& fluid,
    const hostState& state,
    bool always
)
{
    using scheme = solidProperties::scheme;
    const solidProperties& p = scene.properties;
    solidScales s;
    s.massPerArea = leastMassPerArea(scene, state);
    s.subSteps = p.stepping == scheme::midpoint ? 0 : p.subSteps;
    if (always || s.subSteps > 0)
    {
        s.omegaMax = elasticSolver::make
        (
            "cpu", scene.mesh, p, {},
            p.contact.active ? touchedWalls(state, fluid) : contactWalls{}
        )->omegaMax();
    }
    if (p.stepping == scheme::automatic && !p.contact.active)
    {
        s.implicitBeyond = springLimit(s.omegaMax)*mostExplicit;
    }
    return s;
}

} // namespace gpuFsi
