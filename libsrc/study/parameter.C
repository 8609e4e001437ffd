#include "study/parameter.H"

#include "dictionary/entry.H"
#include "dictionary/number.H"

#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <set>

namespace gpuFsi
{

entryAddress::entryAddress(const std::string& text, const sourceSpan& where)
{
    std::vector<std::string> words(1);
    for (const char c : text)
    {
        if (c == ':')
        {
            words.emplace_back();
        }
        else
        {
            words.back() += c;
        }
    }
    bool good = words.size() > 1 && words[0][0] != '/'
     && words[0].find("..") == std::string::npos;
    for (const std::string& word : words)
    {
        good = good && !word.empty()
         && word.find_first_of(" \t\";{}$") == std::string::npos;
    }
    if (!good)
    {
        throw userError
        (
            "'" + text + "' is no entry of a case's file", where,
            "Write \"system/controlDict:deltaT\", or with the names of "
            "sub-dictionaries \"system/controlDict:functions:e:region\"."
        );
    }
    file = words[0];
    keys.assign(words.begin() + 1, words.end());
}


std::string entryAddress::assignment(const std::string& valueText) const
{
    std::string text;
    for (std::size_t i = 0; i + 1 < keys.size(); ++i)
    {
        text += keys[i] + " { ";
    }
    text += keys.back() + " " + valueText + ";";
    for (std::size_t i = 0; i + 1 < keys.size(); ++i)
    {
        text += " }";
    }
    return text + '\n';
}


double parameter::number(std::size_t i) const
{
    double value = 0;
    const choice& c = choices[i];
    if (readNumber(c.label, value)
     || (!c.values.empty() && readNumber(c.values[0], value)))
    {
        return value;
    }
    return std::numeric_limits<double>::quiet_NaN();
}


namespace
{

//- One value: a token, or all between a bracket and its partner
std::string valueText(const std::vector<token>& tokens, std::size_t& i)
{
    if (!tokens[i].is('('))
    {
        const token& t = tokens[i++];
        return t.type == token::kind::string ? t.text : tokensText({t});
    }
    std::vector<token> group;
    int depth = 0;
    do
    {
        depth += tokens[i].is('(') - tokens[i].is(')');
        group.push_back(tokens[i++]);
    }
    while (depth > 0 && i < tokens.size());
    return tokensText(group);
}


std::vector<std::string> valueList
(
    const dictionary& dict,
    const std::string& key
)
{
    const std::vector<token>& tokens = dict.tokens(key);
    std::vector<std::string> values;
    if (tokens.size() > 2 && tokens.front().is('(') && tokens.back().is(')'))
    {
        for (std::size_t i = 1; i + 1 < tokens.size();)
        {
            values.push_back(valueText(tokens, i));
        }
    }
    if (values.empty())
    {
        throw userError
        (
            "Entry '" + key + "' in dictionary \"" + dict.name()
          + "\" is '" + tokensText(tokens, 60) + "', a list of one value or "
            "more was expected",
            dict.where(key), "Write " + key + " (0.02 0.01);"
        );
    }
    return values;
}


void readEntries(parameter& p, const dictionary& dict)
{
    std::vector<std::string> texts;
    std::string key = "entry";
    if (dict.found("entries"))
    {
        key = "entries";
        texts = dict.get<std::vector<std::string>>(key);
    }
    else if (dict.found(key))
    {
        texts = {dict.get<std::string>(key)};
    }
    for (const std::string& text : texts)
    {
        p.entries.emplace_back(text, dict.where(key));
    }
}


void readChoices(parameter& p, const dictionary& choices)
{
    for (const std::string& label : choices.keys())
    {
        p.choices.push_back({label, valueList(choices, label)});
        const std::size_t n = p.choices.back().values.size();
        if (n != p.entries.size())
        {
            throw userError
            (
                fmt::format
                (
                    "Choice '{}' of parameter '{}' has {} values, but there "
                    "are {} entries", label, p.name, n, p.entries.size()
                ),
                choices.where(label),
                "Give one value for each entry, in their order; asIs leaves "
                "an entry as the case has it."
            );
        }
    }
}


//- linear or logarithmic (from to number), both ends among them
std::vector<std::string> spacedValues
(
    const dictionary& dict,
    const std::string& key
)
{
    const auto given = dict.get<std::vector<double>>(key);
    const bool logs = key == "logarithmic";
    const bool good = given.size() == 3 && given[2] >= 2 && given[2] <= 1000
     && given[2] == std::floor(given[2]) && given[0] != given[1]
     && !(logs && (given[0] <= 0 || given[1] <= 0));
    if (!good)
    {
        throw userError
        (
            "Entry '" + key + "' is '" + tokensText(dict.tokens(key), 60)
          + "', from, to (another" + (logs ? ", both positive" : "")
          + ") and how many (2 to 1000) were expected",
            dict.where(key), "Write " + key + " (0.01 100 9);"
        );
    }
    std::vector<std::string> values;
    for (int i = 0; i < int(given[2]); ++i)
    {
        const double part = i/(given[2] - 1);
        const double value = logs
          ? given[0]*std::pow(given[1]/given[0], part)
          : given[0] + (given[1] - given[0])*part;
        values.push_back(fmt::format("{:.5g}", value));
    }
    return values;
}


std::vector<std::string> listedValues(const dictionary& dict)
{
    for (const char* key : {"linear", "logarithmic"})
    {
        if (dict.found(key))
        {
            return spacedValues(dict, key);
        }
    }
    return valueList(dict, "values");
}


//- A shell takes no other names
void checkName(const std::string& name, const sourceSpan& where)
{
    const std::string letters =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_";
    if (name.find_first_not_of(letters + "0123456789") != std::string::npos
     || letters.find(name[0]) == std::string::npos || name == "PATH")
    {
        throw userError
        (
            "'" + name + "' cannot name a parameter", where,
            "Use letters, digits and _, a letter first: commands see it as "
            "an environment variable."
        );
    }
}


void checkLabels(const parameter& p, const dictionary& dict)
{
    std::set<std::string> labels;
    for (const parameter::choice& c : p.choices)
    {
        if (!labels.insert(c.label).second)
        {
            throw userError
            (
                "Parameter '" + p.name + "' has the value " + c.label
              + " twice", dict.where(), "Leave one out."
            );
        }
    }
    if (labels.empty())
    {
        throw userError
        (
            "Parameter '" + p.name + "' has no choices", dict.where(),
            "Give values (...) or choices { label (...); }."
        );
    }
}

} // namespace


parameter readParameter(const std::string& name, const dictionary& dict)
{
    checkName(name, dict.where());
    parameter p;
    p.name = name;
    readEntries(p, dict);
    if (dict.found("choices"))
    {
        readChoices(p, dict.subDict("choices"));
    }
    else
    {
        for (const std::string& value : listedValues(dict))
        {
            // Without entries only the variable carries it
            p.choices.push_back
            (
                {value, std::vector<std::string>(p.entries.size(), value)}
            );
        }
    }
    checkLabels(p, dict);
    return p;
}

} // namespace gpuFsi
