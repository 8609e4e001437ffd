#include "solid/elasticSolver.H"

#include "device/useCuda.H"

#include <fmt/format.h>

namespace gpuFsi
{

static void checkState(const solidMesh& mesh, const solidState& s)
{
    for (const std::size_t size :
        {
            s.positions.size(), s.U.size(), s.accelerations.size(),
            s.load.size(), s.broken.size()
        })
    {
        if (size > 0 && size != mesh.size())
        {
            throw userError
            (
                fmt::format
                (
                    "The state of the solids has {} particles, their mesh {}",
                    size, mesh.size()
                ),
                {},
                "Seed the case again, or restart from this case's folders."
            );
        }
    }
}


std::unique_ptr<elasticSolver> elasticSolver::make
(
    const std::string& backend,
    const solidMesh& mesh,
    const solidProperties& properties,
    const solidState& initial,
    const contactWalls& walls
)
{
    checkState(mesh, initial);
    if (useCuda(backend))
    {
#ifdef FSI_HAVE_CUDA
        return newCudaSolid(mesh, properties, initial, walls);
#endif
    }
    return newCpuSolid(mesh, properties, initial, walls);
}

} // namespace gpuFsi
