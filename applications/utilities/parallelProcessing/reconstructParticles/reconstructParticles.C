//- Puts the particles of the processor directories together again: the time
//  folders that a run on one rank would have written.
#include "base/log.H"
#include "case/argList.H"
#include "joinedTime.H"

#include <algorithm>

using namespace gpuFsi;

static std::vector<instant> chosenTimes(const argList& args)
{
    const std::filesystem::path& casePath = args.casePath();
    for (const incompleteTime& t : incompleteTimes(casePath))
    {
        warning
        (
            fmt::format
            (
                "Time {} is left out: only {} of {} processor directories"
                " have it",
                t.time.name, t.nProcessors, nProcessors(casePath)
            )
        );
    }
    std::vector<instant> times = selectTimes(completeTimes(casePath), args);
    if (args.found("newTimes"))
    {
        const std::vector<instant> there = findTimes(casePath);
        const auto isThere = [&](const instant& t)
        {
            return std::any_of
            (
                there.begin(),
                there.end(),
                [&](const instant& old) { return old.name == t.name; }
            );
        };
        times.erase
        (
            std::remove_if(times.begin(), times.end(), isThere), times.end()
        );
    }
    return times;
}


static int reconstructParticles(int argc, char** argv)
{
    const argList args
    (
        argc,
        argv,
        "Put the particles of processor directories together again.",
        {
            {"time", "ranges", "times to put together, as ':10,20,40:70'"},
            {"latestTime", "", "the latest time that all ranks have"},
            {"newTimes", "", "only times that the case has not got yet"},
            {"noZero", "", "leave time 0 out"}
        }
    );
    printBanner(args.commandLine(), args.casePath().string());

    const std::filesystem::path& casePath = args.casePath();
    const int nRanks = nProcessors(casePath);
    if (nRanks == 0)
    {
        throw userError
        (
            "There are no processor directories in " + casePath.string(),
            {},
            "Run decomposeParticles, and gpuFsiFoam on several ranks, first."
        );
    }
    const auto record = decompositionRecord::read(processorPath(casePath, 0));
    const std::vector<instant> times = chosenTimes(args);
    for (const instant& t : times)
    {
        joinTime(casePath, t.name, record, nRanks);
    }
    if (times.empty())
    {
        info("There is no time to put together");
    }
    info("\nEnd\n");
    return 0;
}


int main(int argc, char** argv)
{
    return runMain
    (
        "reconstructParticles",
        [&] { return reconstructParticles(argc, argv); }
    );
}
