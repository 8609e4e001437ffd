//- Seeds the particles of a case: fluid on a lattice, walls on surfaces.
#include "base/log.H"
#include "case/argList.H"
#include "seedFiles.H"
#include "seedReport.H"

#include <chrono>
#include <ctime>

#ifdef FSI_HAVE_CGAL
#include "surface/surfaceRegion.H"
#endif

using namespace gpuFsi;

#ifdef FSI_HAVE_CGAL
static const regionSelection::add<surfaceRegion> addSurface("surface");
#endif

static int seedParticles(int argc, char** argv)
{
    const argList args
    (
        argc,
        argv,
        "Seed fluid, wall and solid particles from system/seedParticlesDict.",
        {{
            "dict", "file",
            "relative to the case, default system/seedParticlesDict"
        }}
    );
    printBanner(args.commandLine(), args.casePath().string());

    const auto start = std::chrono::steady_clock::now();
    const writeOptions options = readWriteOptions(args.casePath());

    const std::filesystem::path file = args.casePath()
        /args.getOrDefault("dict", "system/seedParticlesDict");
    info("Reading {}\n", file.string());
    const dictionary dict = dictionary::fromFile(file);
    seedSettings settings(dict, args.casePath());
    reportSettings(settings);

    seededSolids solids =
        seedSolids(std::move(settings.solids), *settings.mesh);
    reportSolids(solids.reports);
    for (auto& solid : solids.regions)
    {
        settings.regions.push_back(std::move(solid));
    }
    seededParticles seeded;
    if (settings.fluid)
    {
        seeded = seedFluid(*settings.mesh, settings.regions);
    }
    if (settings.displace > 0)
    {
        displaceBulk(*settings.mesh, seeded, settings.displace, settings.seed);
    }
    if (settings.fluid)
    {
        reportSeeded(settings, seeded);
    }

    const std::vector<cloud> clouds = makeClouds(settings, seeded, solids);
    dict.warnUnread();
    const std::size_t bytes = writeSeed
    (
        args.casePath(),
        clouds,
        makeDomain(settings, seeded, solids),
        solids.mesh,
        options
    );
    info
    (
        "Wrote 0/lagrangian ({:.3g} MB), constant/domain, constant/polyMesh{}"
        " and {}.foam\n",
        1e-6*bytes, solids.mesh.empty() ? "" : ", constant/solid",
        args.caseName()
    );
    const std::chrono::duration<double> clock =
        std::chrono::steady_clock::now() - start;
    info
    (
        "ExecutionTime = {:.2f} s  ClockTime = {:.2f} s\n\nEnd\n",
        double(std::clock())/CLOCKS_PER_SEC, clock.count()
    );
    return 0;
}


int main(int argc, char** argv)
{
    return runMain("seedParticles", [&] { return seedParticles(argc, argv); });
}
