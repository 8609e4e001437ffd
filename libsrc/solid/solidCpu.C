#include "solid/springStepper.H"

namespace gpuFsi
{

std::unique_ptr<elasticSolver> newCpuSolid
(
    const solidMesh& mesh,
    const solidProperties& properties,
    const solidState& initial,
    const contactWalls& walls
)
{
    return makeSpringStepper<cpuBackend>(mesh, properties, initial, walls);
}

} // namespace gpuFsi
