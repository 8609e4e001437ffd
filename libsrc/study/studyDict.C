#include "study/studyDict.H"

#include <limits>

namespace gpuFsi
{

namespace
{

namespace fs = std::filesystem;

constexpr double huge = std::numeric_limits<double>::max();

studyDict::errorSource readError(const dictionary& dict)
{
    studyDict::errorSource e;
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


std::size_t indexOf
(
    const std::vector<parameter>& parameters,
    const std::string& name,
    const sourceSpan& where
)
{
    std::vector<std::string> names;
    for (std::size_t i = 0; i < parameters.size(); ++i)
    {
        if (parameters[i].name == name)
        {
            return i;
        }
        names.push_back(parameters[i].name);
    }
    throw userError(unknownChoice("parameter", name, names), where);
}


void checkLabel
(
    const parameter& p,
    const std::string& label,
    const sourceSpan& where
)
{
    std::vector<std::string> labels;
    for (const parameter::choice& c : p.choices)
    {
        if (c.label == label)
        {
            return;
        }
        labels.push_back(c.label);
    }
    throw userError
    (
        unknownChoice("choice of parameter " + p.name, label, labels), where
    );
}


void readSkip(studyDict& s, const dictionary& dict)
{
    for (const std::string& name : dict.keys())
    {
        const dictionary& rule = dict.subDict(name);
        std::map<std::string, std::string> labels;
        for (const std::string& key : rule.keys())
        {
            const sourceSpan where = rule.where(key);
            const std::string label = rule.get<std::string>(key);
            checkLabel
            (
                s.parameters[indexOf(s.parameters, key, where)], label, where
            );
            labels[key] = label;
        }
        if (labels.empty())
        {
            throw userError
            (
                "The rule " + name + " of skip is empty: it would skip all",
                dict.where(name), "Write " + name + " { parameter value; }"
            );
        }
        s.skip.push_back(labels);
    }
}


void readParameters(studyDict& s, const dictionary& dict)
{
    for (const std::string& name : dict.keys())
    {
        s.parameters.push_back(readParameter(name, dict.subDict(name)));
    }
    if (s.parameters.empty())
    {
        throw userError
        (
            "There are no parameters: nothing to study", dict.where(),
            "Write h { entry \"system/seedParticlesDict:spacing\"; values "
            "(0.2 0.1); }"
        );
    }
}


//- studyDict.gpu: study.gpu, as two studies in one directory would void each
//  other's records
std::string defaultDirectory(const fs::path& file)
{
    const std::string name = file.filename().string();
    return name.compare(0, 9, "studyDict") == 0
      ? "study" + name.substr(9) : "study." + name;
}


std::string readDirectory(const dictionary& dict, const fs::path& file)
{
    const std::string name = dict.getOrDefault<std::string>
    (
        "directory", defaultDirectory(file)
    );
    // Removed and made anew piecemeal: never a directory of the case itself
    if (name.compare(0, 5, "study") != 0
     || name.find('/') != std::string::npos)
    {
        throw userError
        (
            "directory is '" + name + "'", dict.where("directory"),
            "Give a plain name that begins with study."
        );
    }
    return name;
}


void checkFiles(const studyDict& s, const fs::path& casePath)
{
    for (const parameter& p : s.parameters)
    {
        for (const entryAddress& e : p.entries)
        {
            if (!fs::exists(casePath/e.file))
            {
                throw userError
                (
                    "Parameter " + p.name + " varies an entry of " + e.file
                  + ", which is not there",
                    {(casePath/e.file).string()},
                    "Name the file relative to the case."
                );
            }
        }
    }
}

} // namespace


studyDict studyDict::read(const fs::path& casePath, const std::string& file)
{
    const dictionary dict = dictionary::fromFile(casePath/file);
    studyDict s;
    s.title = dict.getOrDefault<std::string>
    (
        "title", casePath.filename().string()
    );
    s.directory = readDirectory(dict, file);
    s.commands = dict.get<std::vector<std::string>>("commands");
    s.error = readError(dict.subDict("error"));
    s.repeats = int(dict.getNumberOrDefault("repeats", 3, 1, 1000));
    s.timeLimit = dict.getNumberOrDefault("timeLimit", 600, 0.1, huge);
    s.total = dict.getChoiceOrDefault("cost", "loop", {"loop", "total"})
     == "total";
    s.targets = dict.getOrDefault<std::vector<double>>("targets", {});
    s.noCopy = dict.getOrDefault<std::vector<std::string>>("noCopy", {});
    readParameters(s, dict.subDict("parameters"));
    s.resolution = indexOf
    (
        s.parameters,
        dict.getOrDefault<std::string>("resolution", s.parameters[0].name),
        dict.where(dict.found("resolution") ? "resolution" : "parameters")
    );
    if (const dictionary* rules = dict.subDictPtr("skip"))
    {
        readSkip(s, *rules);
    }
    checkFiles(s, casePath);
    dict.warnUnread();
    return s;
}

} // namespace gpuFsi
