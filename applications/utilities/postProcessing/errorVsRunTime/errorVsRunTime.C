//- What accuracy costs: runs the variants of a case that system/studyDict
//  lists, and writes a table and a picture of their error against run time.
#include "base/log.H"
#include "study/comparison.H"
#include "study/machine.H"
#include "study/studyRun.H"
#include "study/variantOptions.H"
#include "studyFiles.H"

using namespace gpuFsi;
namespace fs = std::filesystem;

static std::vector<curve> readAll(const std::string& list)
{
    std::vector<curve> all;
    for (std::size_t from = 0; from <= list.size();)
    {
        const std::size_t comma = std::min(list.find(',', from), list.size());
        for (curve& c : readCurves(list.substr(from, comma - from)))
        {
            all.push_back(std::move(c));
        }
        from = comma + 1;
    }
    return all;
}


static int errorVsRunTime(int argc, char** argv)
{
    const argList args
    (
        argc,
        argv,
        "Run the variants of a case and tie their error to their run time.",
        variantOptions::besides
        ({
            {"dict", "file", "default: system/studyDict"},
            {"compare", "list", "directories of other studies, or csv files,"
                " separated by commas: laid over"}
        })
    );
    printBanner(args.commandLine(), args.casePath().string());
    variantOptions options(args);
    const studyDict study = studyDict::read
    (
        args.casePath(), args.getOrDefault("dict", "system/studyDict")
    );
    if (options.lists(study))
    {
        return 0;
    }
    const std::vector<curve> compared =
        args.found("compare") ? readAll(args.get("compare"))
                              : std::vector<curve>();
    info("Machine     : {}", machineName());
    const fs::path directory = args.casePath()/study.directory;
    options.lock(directory);
    studyRun runs(study, args.casePath());
    options.carryOut(runs);
    const std::vector<curve> curves = runs.curves();
    writeStudyFiles(study, directory, curves, compared, runs.failures());
    if (!runs.failures().empty())
    {
        info("\n{} failures, see above", runs.failures().size());
        return 1;
    }
    info("\nEnd\n");
    return 0;
}


int main(int argc, char** argv)
{
    return runMain
    (
        "errorVsRunTime", [&] { return errorVsRunTime(argc, argv); }
    );
}
