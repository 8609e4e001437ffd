#include "scene.H"

#include "base/digest.H"
#include "base/log.H"
#include "decomposition/decomposeParDict.H"
#include "decomposition/processorDirectories.H"
#include "limits/chooseSuperSteps.H"
#include "parallel/agreedError.H"
#include "particles/stateIO.H"

#include <limits>

namespace gpuFsi
{

namespace fs = std::filesystem;

static void checkDirectories(const fs::path& casePath, int nRanks)
{
    const int n = nProcessors(casePath);
    if (n == 0)
    {
        throw userError
        (
            "There is no processor directory in " + casePath.string(),
            {},
            "Run decomposeParticles first."
        );
    }
    if (n != nRanks)
    {
        throw userError
        (
            fmt::format
            (
                "The case is decomposed for {} ranks, but there are {}",
                n, nRanks
            ),
            {},
            fmt::format
            (
                "Use mpirun -np {}, or reconstructParticles and "
                "decomposeParticles -force for {}.", n, nRanks
            )
        );
    }
}


static timeGroup groupOf(const communicator& ranks, const fs::path& casePath)
{
    timeGroup g;
    if (!ranks.parallel())
    {
        return g;
    }
    g.directory = processorPath(casePath, ranks.rank());
    g.times = [casePath] { return completeTimes(casePath); };
    g.master = ranks.master();
    g.either = [&ranks](std::uint64_t bits)
    {
        ranks.bitOr(&bits, 1);
        return bits;
    };
    g.agree = [&ranks](const std::function<void()>& f) { ranks.agree(f); };
    return g;
}


scene::scene(const communicator& ranks, const fs::path& casePath)
:
    ranks_(ranks),
    casePath_(casePath)
{
    ranks.agree([&] { read(casePath); });
    compareRanks();
}


//- Nodes may see different states of a shared file system
void scene::compareRanks() const
{
    const std::string start = time->startPath().filename().string();
    const bool same = ranks_.same
    (
        digestOf(start) ^ digestOfFile(casePath_/"system/controlDict")
    );
    if (!same)
    {
        throw agreedError
        (
            "The ranks do not read the same case: another start time than "
          + start + ", or another system/controlDict\n    Wait until all nodes "
            "see the same files, then run again.",
            false
        );
    }
}


void scene::read(const fs::path& casePath)
{
    if (ranks_.parallel())
    {
        checkDirectories(casePath, ranks_.size());
    }
    time = std::make_unique<Time>(casePath, groupOf(ranks_, casePath));
    controls.emplace(time->controlDict());
    space = domain::read(casePath);
    fluid = fluidProperties::read(casePath, space);
    schemes = particleSchemes::read(casePath, space);
    solids = solidScene::read(casePath, space);
    chooseSteps();
}


void scene::chooseSteps()
{
    if (space.hasFluid())
    {
        whySuperSteps = chooseSuperSteps
        (
            schemes, flowScalesOf(space, fluid),
            time->adjustTimeStep()
          ? std::nullopt : std::optional<double>(time->deltaT())
        );
    }
}


rankSettings scene::settings() const
{
    const decomposeParDict dict = decomposeParDict::read(casePath_);
    if (dict.numberOfSubdomains != ranks_.size())
    {
        throw userError
        (
            fmt::format
            (
                "numberOfSubdomains is {}, but there are {} ranks",
                dict.numberOfSubdomains, ranks_.size()
            ),
            {(casePath_/"system/decomposeParDict").string()},
            "Decompose for as many ranks as run."
        );
    }
    rankSettings s;
    s.method = dict.methodName;
    s.assign = [method = dict.method, n = ranks_.size()]
    (
        const blockGrid& grid,
        const std::vector<double>& weight
    )
    {
        return method->assign(grid, weight, n);
    };
    s.fluidWeight = dict.weights.fluid;
    s.wallWeight = dict.weights.wall;
    s.limit = dict.balance.active
      ? dict.balance.limit : std::numeric_limits<double>::infinity();
    s.always = dict.balance.every;
    using mode = decomposeParDict::transportMode;
    const bool can = ranks_.takesDeviceMemory();
    if (dict.transport == mode::direct && !can)
    {
        throw userError
        (
            "transport is direct, but this MPI library does not take the "
            "memory of a GPU",
            {(casePath_/"system/decomposeParDict").string()},
            "Set 'transport auto' or 'transport staged', or use a CUDA-aware "
            "MPI."
        );
    }
    s.direct = can && dict.transport != mode::staged;
    s.peers = dict.transport == mode::automatic;
    return s;
}


std::unique_ptr<fluidSolver> scene::newSolver() const
{
    hostState initial;
    std::unique_ptr<rankSetup> setup;
    ranks_.agree([&]
    {
        if (!ranks_.parallel())
        {
            initial = readState(time->startPath(), space, fluid.rho0);
        }
        else
        {
            const fs::path solids = processorPath(casePath_, 0)
              /time->startPath().filename();
            initial =
                readPart(time->startPath(), solids, space, fluid.rho0);
            setup.reset(new rankSetup{ranks_, settings()});
        }
    });
    initial.time = time->value();
    return fluidSolver::make
    (
        controls->backend, controls->precision, space, fluid, schemes,
        std::move(initial), solids.get(), setup.get()
    );
}

} // namespace gpuFsi
