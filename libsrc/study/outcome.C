#include "study/outcome.H"

#include "case/cloud.H"
#include "dictionary/number.H"
#include "study/logWords.H"

#include <algorithm>
#include <sstream>

namespace gpuFsi
{

namespace
{

namespace fs = std::filesystem;

const char* const names[nOutcomes] =
{
    "accurate", "inaccurate", "refused", "stopped", "diverged", "crashed",
    "hung", "failed"
};


//- Does the last row hold nan or inf, of either sign? (Those before may, as
//  of a fit that has not seen enough yet.)
bool holdsNotFinite(const std::string& text)
{
    std::istringstream lines(text);
    std::string last;
    for (std::string line; std::getline(lines, line);)
    {
        last = line.empty() || line[0] == '#' ? last : line;
    }
    std::istringstream words(last);
    for (std::string word; words >> word;)
    {
        word.erase(0, word.find_first_not_of("-+("));
        word = word.substr(0, 3);
        if (word == "nan" || word == "inf")
        {
            return true;
        }
    }
    return false;
}


fs::path tableNotFinite(const fs::path& directory)
{
    std::vector<fs::path> bad;
    if (fs::is_directory(directory))
    {
        for (const auto& e : fs::recursive_directory_iterator(directory))
        {
            if (e.path().extension() == ".dat"
             && holdsNotFinite(bytesOf(e.path())))
            {
                bad.push_back(e.path());
            }
        }
    }
    return bad.empty() ? fs::path() : *std::min_element(bad.begin(), bad.end());
}


fs::path lastTime(const fs::path& casePath)
{
    fs::path last;
    double latest = 0, value = 0;
    for (const auto& e : fs::directory_iterator(casePath))
    {
        if (readNumber(e.path().filename().string(), value)
         && (last.empty() || value > latest))
        {
            last = e.path();
            latest = value;
        }
    }
    return last;
}


//- Reading a cloud refuses such values
fs::path cloudNotFinite(const fs::path& time)
{
    if (time.empty())
    {
        return {};
    }
    for (const std::string& name : cloudNames(time))
    {
        try
        {
            readCloud(time, name);
        }
        catch (const userError& e)
        {
            return e.where().file.empty() ? time.string() : e.where().file;
        }
    }
    return {};
}

} // namespace


const char* nameOf(outcome o)
{
    return names[int(o)];
}


outcome outcomeNamed(const std::string& name)
{
    for (int i = 0; i < nOutcomes; ++i)
    {
        if (name == names[i])
        {
            return outcome(i);
        }
    }
    throw userError
    (
        unknownChoice("outcome", name, {names, names + nOutcomes})
    );
}


bool allowed(outcome o)
{
    return o <= outcome::stopped;
}


outcome outcomeOf(const commandOutcome& ran, const std::string& log)
{
    if (ran.timedOut)
    {
        return outcome::hung;
    }
    if (ran.good())
    {
        return outcome::accurate;
    }
    if (ran.code > 128)
    {
        return outcome::crashed;
    }
    const std::size_t fatal = log.rfind("--> FOAM FATAL");
    if (ran.code != 1 || fatal == log.npos)
    {
        return outcome::failed;
    }
    // Steps are logged now and then only, but who breaks down tells the time
    const bool begun = log.find("\nTime = ") < fatal
     || log.find("broke down at Time = ", fatal) != log.npos
     || log.find("has left the domain", fatal) != log.npos;
    return begun ? outcome::stopped : outcome::refused;
}


fs::path notFinite(const fs::path& casePath)
{
    const fs::path table = tableNotFinite(casePath/"postProcessing");
    return table.empty() ? cloudNotFinite(lastTime(casePath)) : table;
}

} // namespace gpuFsi
