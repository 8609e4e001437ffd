#include "stepping/backendSolvers.H"
#include "stepping/makeSolver.H"

namespace gpuFsi
{

std::unique_ptr<fluidSolver> newCpuSolver
(
    const std::string& precision,
    const domain& d,
    const fluidProperties& properties,
    const particleSchemes& schemes,
    hostState&& s,
    const solidScene* solids,
    const rankSetup* ranks
)
{
    return makeSolver<cpuBackend>
    (
        precision, d, properties, schemes, std::move(s), solids, ranks
    );
}

} // namespace gpuFsi
