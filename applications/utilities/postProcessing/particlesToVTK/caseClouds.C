#include "caseClouds.H"

#include "base/error.H"
#include "base/log.H"
#include "decomposition/processorDirectories.H"
#include "dictionary/dictionary.H"

#include <algorithm>
#include <set>

namespace gpuFsi
{

namespace fs = std::filesystem;

//- Those times with a cloud on one of the ranks at least
static std::vector<instant> withClouds
(
    const fs::path& casePath,
    const std::vector<std::string>& ranks,
    const std::vector<instant>& times
)
{
    std::vector<instant> some;
    for (const instant& time : times)
    {
        for (const std::string& rank : ranks)
        {
            if (!cloudNames(casePath/rank/time.name).empty())
            {
                some.push_back(time);
                break;
            }
        }
    }
    return some;
}


//- Times that every rank has; warns of the others
static std::vector<instant> timesOfRanks
(
    const fs::path& casePath,
    const std::vector<std::string>& ranks
)
{
    for (const incompleteTime& t : incompleteTimes(casePath))
    {
        warning
        (
            "Time " + t.time.name + " is left out: only "
          + std::to_string(t.nProcessors) + " of "
          + std::to_string(ranks.size()) + " processors have it"
        );
    }
    return withClouds(casePath, ranks, completeTimes(casePath));
}


caseClouds::caseClouds(const fs::path& casePath, bool decomposed)
:
    casePath_(casePath),
    times_(withClouds(casePath, ranks_, findTimes(casePath)))
{
    std::vector<std::string> ranks;
    for (int r = 0; r < nProcessors(casePath); ++r)
    {
        ranks.push_back("processor" + std::to_string(r));
    }
    const std::vector<instant> pieces = timesOfRanks(casePath, ranks);
    if (decomposed && pieces.empty())
    {
        throw userError
        (
            "There is no time that all processor directories have, with a"
            " cloud, in " + casePath.string(),
            {},
            "Leave -decomposed out, or run decomposeParticles first"
        );
    }
    if
    (
        !pieces.empty()
     && (
            decomposed || times_.empty()
         || pieces.back().value > times_.back().value
        )
    )
    {
        decomposed_ = true;
        ranks_ = ranks;
        times_ = pieces;
    }
    if (times_.empty())
    {
        throw userError
        (
            "There is no time folder with a cloud in " + casePath.string(),
            {},
            "Run seedParticles, which writes time 0, or give another -case"
        );
    }
    findIndices();
}


void caseClouds::findIndices()
{
    std::set<long> different;
    for (const instant& time : times_)
    {
        const fs::path file = folder(ranks_.front(), time)/"uniform"/"time";
        if (fs::exists(file))
        {
            const dictionary state = dictionary::fromFile(file);
            if (state.found("index"))
            {
                indices_.push_back(state.get<long>("index"));
                different.insert(indices_.back());
            }
        }
    }
    if (different.size() < times_.size())
    {
        indices_.resize(times_.size());
        for (std::size_t i = 0; i < times_.size(); ++i)
        {
            indices_[i] = static_cast<long>(i);
        }
    }
}


long caseClouds::index(const instant& time) const
{
    const auto at = std::find_if
    (
        times_.begin(),
        times_.end(),
        [&](const instant& t) { return t.name == time.name; }
    );
    developerAssert(at != times_.end(), "the time is one of times()");
    return indices_[static_cast<std::size_t>(at - times_.begin())];
}


std::vector<std::string> caseClouds::names(const instant& time) const
{
    std::set<std::string> all;
    for (const std::string& rank : ranks_)
    {
        const auto some = cloudNames(folder(rank, time));
        all.insert(some.begin(), some.end());
    }
    return {all.begin(), all.end()};
}


std::set<std::string> caseClouds::fieldNames
(
    const instant& time,
    const std::string& cloudName
) const
{
    std::set<std::string> fields;
    for (const std::string& rank : ranks_)
    {
        const fs::path directory =
            folder(rank, time)/"lagrangian"/cloudName;
        if (!fs::is_directory(directory))
        {
            continue;
        }
        for (const auto& entry : fs::directory_iterator(directory))
        {
            fs::path file = entry.path().filename();
            if (file.extension() == ".gz")
            {
                file.replace_extension();
            }
            fields.insert(file.string());
        }
    }
    fields.erase("positions");
    fields.erase("coordinates");
    return fields;
}


std::vector<cloud> caseClouds::read
(
    const instant& time,
    const std::string& cloudName
) const
{
    const std::vector<std::string> known = names(time);
    if (std::find(known.begin(), known.end(), cloudName) == known.end())
    {
        throw userError
        (
            unknownChoice("cloud at time " + time.name, cloudName, known)
        );
    }
    std::vector<cloud> pieces;
    for (const std::string& rank : ranks_)
    {
        const fs::path directory = folder(rank, time);
        const auto here = cloudNames(directory);
        cloud piece;
        piece.name = cloudName;
        if (std::find(here.begin(), here.end(), cloudName) != here.end())
        {
            piece = readCloud(directory, cloudName);
        }
        pieces.push_back(std::move(piece));
    }
    return pieces;
}

} // namespace gpuFsi
