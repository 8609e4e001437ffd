#include "parallel/parallelMain.H"

#include "base/error.H"
#include "base/log.H"
#include "parallel/agreedError.H"

#include <algorithm>
#include <chrono>
#include <string_view>
#include <thread>

namespace gpuFsi
{

//- Lets the ranks before this one speak first: whoever speaks ends the others
static void waitForOtherVoices(int rank)
{
    const auto patience = std::chrono::milliseconds(400 + 50*std::min(rank, 20));
    if (rank > 0)
    {
        std::this_thread::sleep_for(patience);
    }
}


static int runRanks
(
    const char* application,
    const communicator& ranks,
    const std::function<int(const communicator&)>& body
)
{
    try
    {
        return body(ranks);
    }
    catch (const agreedError& e)
    {
        if (ranks.master())
        {
            printFatal(application, e.what(), e.ofFile());
        }
        return 1;
    }
    catch (const std::exception& e)
    {
        if (!ranks.parallel())
        {
            throw;
        }
        waitForOtherVoices(ranks.rank());
        const std::string what =
            "On rank " + std::to_string(ranks.rank()) + ": " + e.what();
        printFatal(application, what.c_str(), namesFile(e));
        ranks.abort();
    }
}


int runParallelMain
(
    const char* application,
    int argc,
    char** argv,
    const std::function<int(const communicator&)>& body
)
{
    const bool parallel = std::any_of
    (
        argv, argv + argc,
        [](const char* word) { return std::string_view(word) == "-parallel"; }
    );
    return runMain(application, [&]
    {
        const communicator ranks(argc, argv, parallel);
        silenceLog(!ranks.master());
        return runRanks(application, ranks, body);
    });
}

} // namespace gpuFsi
