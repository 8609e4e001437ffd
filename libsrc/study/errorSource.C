#include "study/errorSource.H"

#include "study/commandRun.H"
#include "study/logWords.H"

#include <cmath>
#include <cstdlib>
#include <fmt/format.h>
#include <fstream>
#include <limits>

namespace gpuFsi
{

namespace
{

namespace fs = std::filesystem;

constexpr double huge = std::numeric_limits<double>::max();

//- cost.dat, and the like that a second run from the same time leaves
std::vector<fs::path> costFilesIn(const fs::path& directory)
{
    std::vector<fs::path> files;
    if (fs::is_directory(directory))
    {
        for (const auto& entry : fs::directory_iterator(directory))
        {
            const std::string name = entry.path().filename().string();
            if (name.compare(0, 4, "cost") == 0
             && entry.path().extension() == ".dat")
            {
                files.push_back(entry.path());
            }
        }
    }
    return files;
}


double startTime(const fs::path& directory)
{
    return std::atof(directory.filename().c_str());
}

} // namespace


errorSource errorSource::read(const dictionary& dict)
{
    errorSource e;
    e.label = dict.getOrDefault<std::string>("label", "");
    if (dict.found("functionObject") == dict.found("command"))
    {
        throw userError
        (
            "error needs either a functionObject or a command", dict.where(),
            "Write functionObject pulseError; norm relL2; or command \"tail "
            "-n 1 log.wave | cut -f 2\"; exact 1.2; (or finest yes;)."
        );
    }
    if (dict.found("functionObject"))
    {
        e.functionObject = dict.get<std::string>("functionObject");
        e.norm = dict.getChoiceOrDefault
        (
            "norm", "relL2",
            {"L1", "L2", "Linf", "relL1", "relL2", "relLinf", "rmsByMax"}
        );
        return e;
    }
    e.command = dict.get<std::string>("command");
    e.finest = dict.getOrDefault<bool>("finest", false);
    e.direct = dict.getOrDefault<bool>("direct", false);
    if (int(e.finest) + int(e.direct) + int(dict.found("exact")) != 1)
    {
        throw userError
        (
            "The number that command prints needs something to be compared "
            "with", dict.where("command"),
            "Give one of exact <number>; finest yes; direct yes;."
        );
    }
    if (dict.found("exact"))
    {
        e.exact = dict.getNumber("exact", -huge, huge);
        if (e.exact == 0)
        {
            throw userError
            (
                "exact is 0, but the error is relative to it",
                dict.where("exact"), "Let command print the departure from a "
                "number that is not 0."
            );
        }
    }
    return e;
}


std::string errorSource::settings() const
{
    return "error " + functionObject + " " + norm + command
      + fmt::format(" {} {} {:.17g}\n", direct, finest, exact);
}


double errorSource::errorOf(double printed) const
{
    return exact == 0 ? printed : std::abs(printed/exact - 1);
}


fs::path costFileOf
(
    const fs::path& casePath,
    const std::string& functionObject
)
{
    const fs::path top = casePath/"postProcessing"/functionObject;
    fs::path latest;
    if (fs::is_directory(top))
    {
        for (const auto& entry : fs::directory_iterator(top))
        {
            if (!costFilesIn(entry.path()).empty() && (latest.empty()
             || startTime(entry.path()) > startTime(latest)))
            {
                latest = entry.path();
            }
        }
    }
    const std::vector<fs::path> files = costFilesIn(latest);
    if (files.size() != 1)
    {
        throw userError
        (
            files.empty()
              ? "The commands left no cost.dat of function object "
              + functionObject
              : fmt::format("There are {} tables cost*.dat: which is the "
                    "run's?", files.size()),
            {(latest.empty() ? top : latest).string()},
            "controlDict needs a function object of that name, of type error; "
            "the commands must run gpuFsiFoam once from a start time."
        );
    }
    return files[0];
}


double printedNumber
(
    const fs::path& casePath,
    const std::string& command,
    const std::vector<std::string>& environment,
    double timeLimit
)
{
    const fs::path output = casePath/"error.txt";
    const commandOutcome ran = runCommands
    (
        casePath, {command}, environment, output, timeLimit
    );
    std::ifstream stream(output);
    double value = 0;
    if (!ran.good() || !(stream >> value))
    {
        throw userError
        (
            "The command of error printed no number:" + lastWords(output),
            {output.string()}
        );
    }
    return value;
}

} // namespace gpuFsi
