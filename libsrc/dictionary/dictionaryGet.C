#include "dictionary/dictionary.H"

#include "dictionary/entry.H"
#include "dictionary/number.H"
#include "dictionary/unitText.H"
#include "dictionary/valueForm.H"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace gpuFsi
{

namespace
{

using tokenList = std::vector<token>;


//- Skips a name and [dimensions] in front of a value
std::size_t skipDimensions(const entry& e, const dimensionSet* expected)
{
    const tokenList& t = e.tokens;
    const std::size_t open =
        t.size() > 1 && t[0].type == token::kind::word && t[1].is('[');
    if (t.empty() || !t[open].is('['))
    {
        return 0;
    }
    std::size_t close = open;
    while (!t[close].is(']'))
    {
        ++close;
    }
    const dimensionSet found = readDimensions(t, open + 1, close);
    if (expected)
    {
        for (int i = 0; i < 7; ++i)
        {
            if (std::fabs(found[i] - (*expected)[i]) > 1e-6)
            {
                throw userError
                (
                    "Entry '" + e.key + "' has the wrong dimensions:\n"
                    "    expected " + dimensionsText(*expected)
                        + "\n    found    " + dimensionsText(found),
                    e.where,
                    "Convert the value, or leave the dimensions out if it is"
                    " in SI units already."
                );
            }
        }
    }
    return close + 1;
}


//- What the value is, in words
std::string described(const tokenList& tokens)
{
    if (tokens.empty())
    {
        return "empty";
    }
    static const char* const kinds[] =
        {"the word ", "the string ", "the verbatim text ", "the number ", ""};
    return (tokens.size() == 1 ? kinds[int(tokens[0].type)] : "")
        + ('\'' + tokensText(tokens, 60) + '\'');
}


template<class T>
T readWhole
(
    const entry& e,
    const std::string& dictionaryName,
    std::size_t begin
)
{
    T value{};
    std::size_t i = begin;
    if (valueForm<T>::read(e.tokens, i, value) && i == e.tokens.size())
    {
        return value;
    }
    std::string remedy;
    const tokenList& t = e.tokens;
    int depth = 0;
    for (std::size_t j = 0; j + 1 < t.size() && remedy.empty(); ++j)
    {
        depth += t[j].is('(') || t[j].is('[');
        depth -= t[j].is(')') || t[j].is(']');
        if (depth == 0 && t[j + 1].line > t[j].line
         && t[j + 1].type == token::kind::word)
        {
            remedy = "Is a ';' missing at the end of line "
                + std::to_string(t[j].line) + '?';
        }
    }
    if (t.size() == 1 && (t[0].text == "nan" || t[0].text == "inf"
     || t[0].text == "-nan" || t[0].text == "-inf"))
    {
        remedy = "Values must be finite.";
    }
    throw userError
    (
        "Entry '" + e.key + "' in dictionary \"" + dictionaryName + "\" is "
            + described(t) + ", " + valueForm<T>::name() + " was expected",
        e.where,
        remedy
    );
}

} // namespace


template<class T>
T dictionary::get(const std::string& key) const
{
    const entry& e = primitive(key, valueForm<T>::name());
    return readWhole<T>(e, name_, skipDimensions(e, nullptr));
}

template double dictionary::get(const std::string&) const;
template int dictionary::get(const std::string&) const;
template long dictionary::get(const std::string&) const;
template bool dictionary::get(const std::string&) const;
template std::string dictionary::get(const std::string&) const;
template vector dictionary::get(const std::string&) const;
template std::vector<double> dictionary::get(const std::string&) const;
template std::vector<int> dictionary::get(const std::string&) const;
template std::vector<long> dictionary::get(const std::string&) const;
template std::vector<bool> dictionary::get(const std::string&) const;
template std::vector<std::string> dictionary::get(const std::string&) const;
template std::vector<vector> dictionary::get(const std::string&) const;


double dictionary::getNumber
(
    const std::string& key,
    double low,
    double high
) const
{
    const double value = get<double>(key);
    if (value >= low && value <= high)
    {
        return value;
    }
    const bool below = std::isfinite(low), above = std::isfinite(high);
    throw userError
    (
        "Entry '" + key + "' in dictionary \"" + name_ + "\" is "
            + numberText(value) + ", out of its range",
        where(key),
        below && above
      ? "Valid are values from " + numberText(low) + " to "
            + numberText(high) + '.'
      : below ? "Valid are values from " + numberText(low) + " upwards."
      : "Valid are values up to " + numberText(high) + '.'
    );
}


double dictionary::getNumberOrDefault
(
    const std::string& key,
    double otherwise,
    double low,
    double high
) const
{
    return found(key) ? getNumber(key, low, high) : otherwise;
}


double dictionary::getDimensioned
(
    const std::string& key,
    const dimensionSet& expected
) const
{
    const entry& e = primitive(key, valueForm<double>::name());
    return readWhole<double>(e, name_, skipDimensions(e, &expected));
}


double dictionary::getPositive
(
    const std::string& key,
    const dimensionSet& expected
) const
{
    const double value = getDimensioned(key, expected);
    if (!(value > 0))
    {
        throw userError
        (
            fmt::format("Entry '{}' is {}, but must be positive", key, value),
            where(key)
        );
    }
    return value;
}


vector dictionary::getDimensionedVector
(
    const std::string& key,
    const dimensionSet& expected
) const
{
    const entry& e = primitive(key, valueForm<vector>::name());
    return readWhole<vector>(e, name_, skipDimensions(e, &expected));
}


std::string dictionary::getChoice
(
    const std::string& key,
    const std::vector<std::string>& valid
) const
{
    const std::string word = get<std::string>(key);
    if (std::find(valid.begin(), valid.end(), word) == valid.end())
    {
        throw userError(unknownChoice(key, word, valid), where(key));
    }
    return word;
}


std::string dictionary::getChoiceOrDefault
(
    const std::string& key,
    const std::string& otherwise,
    const std::vector<std::string>& valid
) const
{
    return found(key) ? getChoice(key, valid) : otherwise;
}

} // namespace gpuFsi
