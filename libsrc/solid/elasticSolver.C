#include "solid/elasticSolver.H"

#include "base/log.H"
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


static void warnOfNothingToTouch
(
    const solidMesh& mesh,
    const contactProperties& contact,
    const contactWalls& walls
)
{
    if
    (
        contact.active && mesh.names.size() < 2
     && (walls.empty() || !contact.walls)
    )
    {
        warning
        (
            "constant/solidProperties has the dictionary contact, but there is "
            "one solid and no wall: nothing can touch."
        );
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
    warnOfNothingToTouch(mesh, properties.contact, walls);
    if (useCuda(backend))
    {
#ifdef FSI_HAVE_CUDA
        return newCudaSolid(mesh, properties, initial, walls);
#endif
    }
    return newCpuSolid(mesh, properties, initial, walls);
}

} // namespace gpuFsi
