#include "stepping/fluidSolver.H"

#include "parallel/agreedError.H"

#include "device/useCuda.H"
#include "stepping/backendSolvers.H"

#include <fmt/format.h>

namespace gpuFsi
{

//- Below this the nearest images of a particle would be seen twice
static constexpr double leastPeriod = 3;    // spacings

static void checkPeriods(const domain& d)
{
    const double length[3] =
    {
        d.hi.x - d.lo.x, d.hi.y - d.lo.y, d.hi.z - d.lo.z
    };
    for (int i = 0; i < d.dimensions; ++i)
    {
        if (d.periodic[i] && length[i] < (leastPeriod - 1e-6)*d.spacing)
        {
            throw userError
            (
                fmt::format
                (
                    "The period in {} is {:g} spacings; at least {:g} are "
                    "needed",
                    "xyz"[i], length[i]/d.spacing, leastPeriod
                ),
                {},
                "Widen the bounds in system/seedParticlesDict, or use 2 "
                "dimensions."
            );
        }
    }
}


//- The reaction is that of the area-weight passes
static void checkCoupling
(
    const particleSchemes& schemes,
    const solidScene* solids
)
{
    using law = couplingProperties::law;
    if
    (
        solids && solids->coupling.force == law::reaction
     && schemes.areaWeights == particleSchemes::weight::radial
    )
    {
        throw userError
        (
            "The solids are to feel the reaction of the area-weight passes, "
            "but areaWeights is radial",
            {},
            "Set 'areaWeights moment' in system/particleSchemes, or 'force "
            "surface' in constant/couplingProperties."
        );
    }
    if (solids && solids->coupling.force == law::reaction && schemes.superSteps)
    {
        throw userError
        (
            "The solids are to feel the reaction of the fluid's forces, which "
            "super-steps of viscosity do not tell",
            {},
            "Set 'superTimeStepping off' in system/particleSchemes, or 'force "
            "surface' in constant/couplingProperties."
        );
    }
}


//- What looks at the neighbours of particles that other ranks own
static void checkRanks(const particleSchemes& schemes, const solidScene* solids)
{
    if (schemes.method == particleSchemes::search::localUpdate)
    {
        throw userError
        (
            "On many ranks neighbours are found by cells, but "
            "system/particleSchemes asks for localUpdate",
            {},
            "Set 'method cellSearch' there."
        );
    }
    using law = couplingProperties::law;
    if (solids && solids->coupling.force == law::reaction)
    {
        throw userError
        (
            "The solids are to feel the reaction of the fluid's forces, which "
            "needs one rank",
            {},
            "Set 'force surface' in constant/couplingProperties."
        );
    }
}


//- A GPU for every rank, or for none
static void chooseGpu
(
    [[maybe_unused]] const std::string& backend,
    const communicator& ranks
)
{
#ifdef FSI_HAVE_CUDA
    const bool here = backend != "cpu" && cudaBackend::available();
#else
    const bool here = false;
#endif
    const bool some = ranks.any(here), lack = ranks.any(!here);
    if (some && lack)
    {
        throw agreedError
        (
            "Some ranks have a GPU and others have none\n    Set 'backend cpu' "
            "in system/controlDict, or leave those nodes out.",
            false
        );
    }
#ifdef FSI_HAVE_CUDA
    if (here)
    {
        cudaBackend::choose(ranks.rankOnNode());
    }
#endif
}


std::unique_ptr<fluidSolver> fluidSolver::make
(
    const std::string& backend,
    const std::string& precision,
    const domain& d,
    const fluidProperties& properties,
    const particleSchemes& schemes,
    hostState initial,
    const solidScene* solids,
    const rankSetup* ranks
)
{
    checkPeriods(d);
    checkCoupling(schemes, solids);
    if (ranks)
    {
        checkRanks(schemes, solids);
        chooseGpu(backend, ranks->ranks);
    }
    if (useCuda(backend))
    {
#ifdef FSI_HAVE_CUDA
        return newCudaSolver
        (
            precision, d, properties, schemes, std::move(initial), solids, ranks
        );
#endif
    }
    return newCpuSolver
    (
        precision, d, properties, schemes, std::move(initial), solids, ranks
    );
}

} // namespace gpuFsi
