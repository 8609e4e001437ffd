#include "caseClouds.H"

#include "base/error.H"
#include "base/log.H"
#include "dictionary/dictionary.H"

#include <algorithm>
#include <set>

namespace gpuFsi
{

namespace fs = std::filesystem;

//- processor0 ... processorN-1, empty without any
static std::vector<std::string> findRanks(const fs::path& casePath)
{
    std::size_t found = 0;
    for (const auto& entry : fs::directory_iterator(casePath))
    {
        const std::string name = entry.path().filename().string();
        const bool numbered = name.size() > 9
            && name.compare(0, 9, "processor") == 0
            && name.find_first_not_of("0123456789", 9) == std::string::npos;
        found += entry.is_directory() && numbered;
    }
    std::vector<std::string> ranks;
    for (std::size_t r = 0; r < found; ++r)
    {
        ranks.push_back("processor" + std::to_string(r));
        if (!fs::is_directory(casePath/ranks.back()))
        {
            throw userError
            (
                "There are " + std::to_string(found) + " processor"
                " directories in " + casePath.string() + ", but no "
              + ranks.back(),
                {},
                "Decompose the case again, or remove the processor directories"
            );
        }
    }
    return ranks;
}


//- Times that every rank has, with a cloud on one of them at least
static std::vector<instant> timesOf
(
    const fs::path& casePath,
    const std::vector<std::string>& ranks
)
{
    std::vector<instant> times;
    if (ranks.empty())
    {
        return times;
    }
    for (const instant& time : findTimes(casePath/ranks.front()))
    {
        std::size_t having = 0;
        bool any = false;
        for (const std::string& rank : ranks)
        {
            const fs::path folder = casePath/rank/time.name;
            having += fs::is_directory(folder);
            any = any || !cloudNames(folder).empty();
        }
        if (having < ranks.size())
        {
            warning
            (
                "Time " + time.name + " is left out: only "
              + std::to_string(having) + " of " + std::to_string(ranks.size())
              + " processors have it"
            );
        }
        else if (any)
        {
            times.push_back(time);
        }
    }
    return times;
}


caseClouds::caseClouds(const fs::path& casePath)
:
    casePath_(casePath),
    times_(timesOf(casePath, ranks_))
{
    const std::vector<std::string> ranks = findRanks(casePath);
    const std::vector<instant> pieces = timesOf(casePath, ranks);
    if
    (
        !pieces.empty()
     && (times_.empty() || pieces.back().value > times_.back().value)
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
