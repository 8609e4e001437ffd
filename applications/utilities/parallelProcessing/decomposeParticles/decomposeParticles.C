//- Shares out the particles of a case among ranks, as system/decomposeParDict
//  says: processor directories, of which each rank of a run reads its own.
#include "base/log.H"
#include "case/argList.H"
#include "decomposeReport.H"
#include "decomposedFiles.H"
#include "decomposition/blockDecomposition.H"
#include "startTimes.H"
#include "stepping/particleSchemes.H"

using namespace gpuFsi;
namespace fs = std::filesystem;

static void writeAll(const argList& args, const std::vector<instant>& times)
{
    const fs::path& casePath = args.casePath();
    const decomposeParDict dict = decomposeParDict::read(casePath);
    const domain space = domain::read(casePath);
    const frame coordinates = frame::of(space);
    const blockGrid grid = blockGrid::of
    (
        space, coordinates,
        particleSchemes::read(casePath, space).searchRadius
    );
    info
    (
        "Decomposing by {} into {} ranks: {} x {} x {} blocks of"
        " ({:.4g} {:.4g} {:.4g}) m\n",
        dict.methodName, dict.numberOfSubdomains, grid.n[0], grid.n[1],
        grid.n[2], grid.size.x, grid.size.y, grid.size.z
    );

    decomposedFiles files(casePath, dict.numberOfSubdomains);
    for (const instant& time : times)
    {
        const decomposedTime t
        (
            casePath/time.name, grid, coordinates, dict
        );
        reportTime(t, grid);
        files.add(t);
        if (&time != &times.back())
        {
            continue;
        }
        files.addConstant(space, t);
        if (args.found("blockDist"))
        {
            writeBlockDecomposition
            (
                casePath/"constant/blockDecomposition", grid, t.rankOfBlock()
            );
            info("Wrote constant/blockDecomposition, for method manual");
        }
    }
    files.moveIn();
    info("Wrote processor0 to processor{}", dict.numberOfSubdomains - 1);
}


static int decomposeParticles(int argc, char** argv)
{
    const argList args
    (
        argc,
        argv,
        "Share out the particles of a case among ranks.",
        {
            {"time", "ranges", "times to decompose, as ':10,20,40:70';"
                " default: where a run starts"},
            {"latestTime", "", "decompose the latest time"},
            {"force", "", "remove former processor directories"},
            {"blockDist", "", "write constant/blockDecomposition too, to edit"
                " for method manual"}
        }
    );
    printBanner(args.commandLine(), args.casePath().string());
    try
    {
        checkPlace(args.casePath(), args.found("force"));
        writeAll(args, startTimes(args));
    }
    catch (const fs::filesystem_error& e)
    {
        throw userError
        (
            std::string("Cannot write the processor directories: ")
          + e.what(),
            {},
            "Check the disk and the permissions of the case directory."
        );
    }
    info("\nEnd\n");
    return 0;
}


int main(int argc, char** argv)
{
    return runMain
    (
        "decomposeParticles", [&] { return decomposeParticles(argc, argv); }
    );
}
