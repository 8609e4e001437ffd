#include "solid/springStepper.H"

namespace gpuFsi
{

std::unique_ptr<elasticSolver> newCpuSolid
(
    const solidMesh& mesh,
    const solidProperties& properties,
    const solidState& initial
)
{
    return makeSpringStepper<cpuBackend>(mesh, properties, initial);
}

} // namespace gpuFsi
