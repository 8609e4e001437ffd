//- What is stable: runs a case over the parameters that system/stabilityDict
//  lists, tells how each run ended, and writes tables and a map of it.
#include "base/log.H"
#include "case/caseFileIO.H"
#include "study/gnuplot.H"
#include "study/stabilityReport.H"
#include "study/stabilityRun.H"
#include "study/variantOptions.H"

#include <algorithm>

using namespace gpuFsi;
namespace fs = std::filesystem;

static void writeMap
(
    const stabilityDict& map,
    const fs::path& directory,
    const std::vector<stabilityResult>& results
)
{
    const bool any = std::any_of(results.begin(), results.end(), [](auto& r)
    {
        return bool(r.record);
    });
    if (!any)
    {
        throw userError
        (
            "No variant has been run", {directory.string()},
            "Leave out -tableOnly."
        );
    }
    const std::string stem = "stabilityMap";
    const std::string table = markdownOf(map, results);
    writeTextFile(directory/(stem + ".csv"), csvOf(map, results));
    writeTextFile(directory/(stem + ".md"), table);
    writeTextFile(directory/(stem + ".gp"), gnuplotOf(map, results, stem));
    info("\n{}", table);
    paint(directory, stem);
}


static int stabilityMap(int argc, char** argv)
{
    const argList args
    (
        argc,
        argv,
        "Run a case over a grid of parameters and map what is stable.",
        variantOptions::besides
        ({
            {"dict", "file", "default: system/stabilityDict"}
        })
    );
    printBanner(args.commandLine(), args.casePath().string());
    variantOptions options(args);
    const stabilityDict map = stabilityDict::read
    (
        args.casePath(), args.getOrDefault("dict", "system/stabilityDict")
    );
    if (options.lists(map))
    {
        return 0;
    }
    const fs::path directory = args.casePath()/map.directory;
    options.lock(directory);
    stabilityRun runs(map, args.casePath());
    options.carryOut(runs);
    writeMap(map, directory, runs.results());
    if (runs.nBad() > 0)
    {
        info("\n{} runs ended as none may, see above", runs.nBad());
        return 1;
    }
    info("\nEnd\n");
    return 0;
}


int main(int argc, char** argv)
{
    return runMain("stabilityMap", [&] { return stabilityMap(argc, argv); });
}
