#include "solid/springStepper.H"

namespace gpuFsi
{

std::unique_ptr<elasticSolver> newCudaSolid
(
    const solidMesh& mesh,
    const solidProperties& properties,
    const solidState& initial,
    const contactWalls& walls
)
{
    return makeSpringStepper<cudaBackend>(mesh, properties, initial, walls);
}

} // namespace gpuFsi
