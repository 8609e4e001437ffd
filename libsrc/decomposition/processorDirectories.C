#include "decomposition/processorDirectories.H"

#include "case/caseFileIO.H"
#include "case/foamFile.H"

#include <fmt/format.h>

#include <algorithm>

namespace gpuFsi
{

namespace fs = std::filesystem;

void decompositionRecord::write(const fs::path& processor) const
{
    foamFile header;
    header.cls = "dictionary";
    header.location = "constant";
    header.object = "decomposition";
    std::string text = header.text() + fmt::format
    (
        "// Written by decomposeParticles for the programs after it\n\n"
        "numberOfSubdomains  {};\n\n"
        "// Particles of all ranks\nclouds\n{{\n",
        numberOfSubdomains
    );
    for (const auto& [name, size] : clouds)
    {
        text += fmt::format("    {:<15} {};\n", name, size);
    }
    writeTextFile(processor/"constant/decomposition", text + "}\n");
}


decompositionRecord decompositionRecord::read(const fs::path& processor)
{
    decompositionRecord r;
    const fs::path file = processor/"constant/decomposition";
    if (fs::exists(file))
    {
        const dictionary dict = dictionary::fromFile(file);
        r.numberOfSubdomains = dict.get<int>("numberOfSubdomains");
        const dictionary& sizes = dict.subDict("clouds");
        for (const std::string& name : sizes.keys())
        {
            r.clouds[name] = std::size_t(sizes.get<long>(name));
        }
    }
    return r;
}


fs::path processorPath(const fs::path& casePath, int rank)
{
    return casePath/("processor" + std::to_string(rank));
}


static int countProcessors(const fs::path& casePath)
{
    int found = 0;
    for (const auto& entry : fs::directory_iterator(casePath))
    {
        const std::string name = entry.path().filename().string();
        found += entry.is_directory() && name.size() > 9
            && name.compare(0, 9, "processor") == 0
            && name.find_first_not_of("0123456789", 9) == std::string::npos;
    }
    return found;
}


int nProcessors(const fs::path& casePath)
{
    const int found = countProcessors(casePath);
    const char* remedy = "Decompose the case again (decomposeParticles"
        " -force), or remove the processor directories.";
    for (int r = 0; r < found; ++r)
    {
        const fs::path p = processorPath(casePath, r);
        if (!fs::is_directory(p))
        {
            throw userError
            (
                fmt::format
                (
                    "There are {} processor directories in {}, but no {}",
                    found, casePath.string(), p.filename().string()
                ),
                {},
                remedy
            );
        }
    }
    // A last directory that is missing leaves no gap
    const fs::path first = processorPath(casePath, 0);
    const int wanted = decompositionRecord::read(first).numberOfSubdomains;
    if (wanted > 0 && wanted != found)
    {
        throw userError
        (
            fmt::format
            (
                "There are {} processor directories in {}, but the case was"
                " decomposed for {}",
                found, casePath.string(), wanted
            ),
            {(first/"constant/decomposition").string()},
            remedy
        );
    }
    return found;
}


//- Times of all processor directories, those in all of them or the others
static std::vector<incompleteTime> timesOf
(
    const fs::path& casePath,
    bool complete
)
{
    const int n = nProcessors(casePath);
    std::map<std::string, incompleteTime> found;
    for (int r = 0; r < n; ++r)
    {
        for (const instant& t : findTimes(processorPath(casePath, r)))
        {
            ++found.insert({t.name, {t, 0}}).first->second.nProcessors;
        }
    }
    std::vector<incompleteTime> times;
    for (const auto& [name, t] : found)
    {
        if ((t.nProcessors == n) == complete)
        {
            times.push_back(t);
        }
    }
    std::sort
    (
        times.begin(),
        times.end(),
        [](const incompleteTime& a, const incompleteTime& b)
        {
            return a.time.value < b.time.value
                || (a.time.value == b.time.value
                 && a.time.name < b.time.name);
        }
    );
    return times;
}


std::vector<instant> completeTimes(const fs::path& casePath)
{
    std::vector<instant> times;
    for (const incompleteTime& t : timesOf(casePath, true))
    {
        times.push_back(t.time);
    }
    return times;
}


std::vector<incompleteTime> incompleteTimes(const fs::path& casePath)
{
    return timesOf(casePath, false);
}

} // namespace gpuFsi
