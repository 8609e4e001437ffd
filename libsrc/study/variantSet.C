#include "study/variantSet.H"

#include <limits>

namespace gpuFsi
{

namespace
{

namespace fs = std::filesystem;

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


void readSkip(variantSet& s, const dictionary& dict)
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
                s.parameters[s.indexOf(key, where)], label, where
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


void readParameters(variantSet& s, const dictionary& dict)
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


void checkFiles(const variantSet& s, const fs::path& casePath)
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


//- studyDict.gpu: study.gpu, as two studies in one directory would void each
//  other's records
std::string defaultDirectory
(
    const fs::path& file,
    const std::string& word,
    const std::string& directory
)
{
    const std::string name = file.filename().string();
    return name.compare(0, word.size(), word) == 0
      ? directory + name.substr(word.size()) : "study." + name;
}


std::string readDirectory(const dictionary& dict, const std::string& otherwise)
{
    const std::string name =
        dict.getOrDefault<std::string>("directory", otherwise);
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

} // namespace


std::size_t variantSet::indexOf
(
    const std::string& name,
    const sourceSpan& where
) const
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


std::size_t variantSet::chosen
(
    const dictionary& dict,
    const std::string& key,
    std::size_t otherwise
) const
{
    return dict.found(key)
      ? indexOf(dict.get<std::string>(key), dict.where(key)) : otherwise;
}


void variantSet::read
(
    const dictionary& dict,
    const fs::path& casePath,
    const fs::path& file,
    const std::string& word,
    const std::string& defaultName
)
{
    title = dict.getOrDefault<std::string>
    (
        "title", casePath.filename().string()
    );
    directory = readDirectory(dict, defaultDirectory(file, word, defaultName));
    commands = dict.get<std::vector<std::string>>("commands");
    timeLimit = dict.getNumberOrDefault
    (
        "timeLimit", 600, 0.1, std::numeric_limits<double>::max()
    );
    noCopy = dict.getOrDefault<std::vector<std::string>>("noCopy", {});
    readParameters(*this, dict.subDict("parameters"));
    if (const dictionary* rules = dict.subDictPtr("skip"))
    {
        readSkip(*this, *rules);
    }
    checkFiles(*this, casePath);
}

} // namespace gpuFsi
