#include "case/argList.H"

#include "base/error.H"
#include "base/log.H"

#include <algorithm>
#include <cstdlib>

namespace gpuFsi
{

namespace
{

void printUsage
(
    const std::string& program,
    const std::string& description,
    const std::vector<argList::option>& options
)
{
    info("\nUsage: {} [OPTIONS]\n", program);
    info("{}\n\nOptions:", description);
    for (const argList::option& o : options)
    {
        std::string left = "-" + o.name;
        if (!o.parameter.empty())
        {
            left += " <" + o.parameter + ">";
        }
        if (left.size() > 22)
        {
            info("  {}\n  {:<24}{}", left, "", o.help);
        }
        else
        {
            info("  {:<24}{}", left, o.help);
        }
    }
    info("");
}

std::string withQuotes(const std::string& argument)
{
    return argument.find_first_of(" \t'\"$;|&()") == std::string::npos
        ? argument
        : '"' + argument + '"';
}

} // namespace

argList::argList
(
    int argc,
    char** argv,
    const std::string& description,
    const std::vector<option>& options,
    bool needsCase
)
{
    std::vector<option> all(options);
    all.push_back({"case", "dir", "case directory, default: this one"});
    all.push_back({"help", "", "print this and exit"});
    std::vector<std::string> words;
    for (const option& o : all)
    {
        words.push_back("-" + o.name);
    }
    const auto known = [&](const std::string& word)
    {
        return std::find(words.begin(), words.end(), word) - words.begin();
    };
    const std::string program =
        std::filesystem::path(argc ? argv[0] : "").filename().string();
    const std::string help = "Run " + program + " -help for the options.";

    commandLine_ = argc ? withQuotes(argv[0]) : "";
    for (int i = 1; i < argc; ++i)
    {
        commandLine_ += " " + withQuotes(argv[i]);
    }
    for (int i = 1; i < argc; ++i)
    {
        const std::string word = argv[i];
        if (word.empty() || word[0] != '-')
        {
            throw userError("Unexpected argument: " + word, {}, help);
        }
        const std::size_t which = known(word);
        if (which == words.size())
        {
            const std::string near = nearestWord(word, words);
            throw userError
            (
                "Invalid option: " + word
              + (near.empty() ? "" : "\nDid you mean " + near + "?"),
                {},
                help
            );
        }
        const option& o = all[which];
        if (values_.count(o.name))
        {
            throw userError("Option " + word + " is given twice", {}, help);
        }
        if (o.parameter.empty())
        {
            values_[o.name] = "";
            continue;
        }
        if (i + 1 == argc || known(argv[i + 1]) != long(words.size()))
        {
            throw userError
            (
                "Option " + word + " needs a parameter <" + o.parameter + ">",
                {},
                help
            );
        }
        values_[o.name] = argv[++i];
    }
    if (found("help"))
    {
        printUsage(program, description, all);
        std::fflush(stdout);
        std::exit(0);
    }

    const std::filesystem::path given = getOrDefault("case", ".");
    std::error_code failed;
    if (!std::filesystem::is_directory(given, failed))
    {
        throw userError
        (
            "Case directory " + given.string() + " does not exist",
            {},
            "Give the directory of a case with -case <dir>."
        );
    }
    casePath_ = std::filesystem::canonical(given);
    if (needsCase && !std::filesystem::exists(casePath_/"system/controlDict"))
    {
        throw userError
        (
            casePath_.string() + " is not a case: there is no file "
            "system/controlDict",
            {},
            "Run in a case directory, or give one with -case <dir>."
        );
    }
}

bool argList::found(const std::string& option) const
{
    return values_.count(option) != 0;
}

std::string argList::get(const std::string& option) const
{
    const auto value = values_.find(option);
    if (value == values_.end())
    {
        throw userError("Option -" + option + " is missing: it is required");
    }
    return value->second;
}

std::string argList::getOrDefault
(
    const std::string& option,
    const std::string& otherwise
) const
{
    const auto value = values_.find(option);
    return value == values_.end() ? otherwise : value->second;
}

std::string argList::caseName() const
{
    return casePath_.filename().string();
}

} // namespace gpuFsi
