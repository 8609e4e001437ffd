#include "dictionary/dictionary.H"

#include "dictionary/entry.H"
#include "dictionary/tokenizer.H"
#include "dictionary/unitText.H"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace gpuFsi
{

namespace
{

using tokenList = std::vector<token>;

//- Reads one T at tokens[i] and moves i behind it; false if there is none
template<class T> struct form;

template<> struct form<double>
{
    static constexpr const char* name = "a number";

    static bool read(const tokenList& tokens, std::size_t& i, double& value)
    {
        if (i >= tokens.size() || tokens[i].type != token::kind::number)
        {
            return false;
        }
        value = tokens[i++].number;
        return true;
    }
};

template<class Integer>
struct integerForm
{
    static constexpr const char* name = "an integer";

    static bool read(const tokenList& tokens, std::size_t& i, Integer& value)
    {
        if (i >= tokens.size() || tokens[i].type != token::kind::number)
        {
            return false;
        }
        const std::string& text = tokens[i].text;
        const char* last = text.data() + text.size();
        const char* first = text.data() + (text[0] == '+');
        const auto [end, status] = std::from_chars(first, last, value);
        if (end != last || status != std::errc())
        {
            // 1e6 is an integer too, as far as a double is exact
            const double number = tokens[i].number;
            if
            (
                number != std::floor(number)
             || std::fabs(number) > 9007199254740992.0
             || number < double(std::numeric_limits<Integer>::min())
             || number > double(std::numeric_limits<Integer>::max())
            )
            {
                return false;
            }
            value = Integer(number);
        }
        ++i;
        return true;
    }
};

template<> struct form<int> : integerForm<int> {};
template<> struct form<long> : integerForm<long> {};

template<> struct form<bool>
{
    static constexpr const char* name =
        "a switch (true on yes y t or false off no n f)";

    static bool read(const tokenList& tokens, std::size_t& i, bool& value)
    {
        if (i >= tokens.size())
        {
            return false;
        }
        for (const char* word : {"true", "on", "yes", "y", "t", "1"})
        {
            if (tokens[i].text == word)
            {
                value = true;
                ++i;
                return true;
            }
        }
        for (const char* word : {"false", "off", "no", "n", "f", "0"})
        {
            if (tokens[i].text == word)
            {
                value = false;
                ++i;
                return true;
            }
        }
        return false;
    }
};

template<> struct form<std::string>
{
    static constexpr const char* name = "a word or string";

    static bool read
    (
        const tokenList& tokens,
        std::size_t& i,
        std::string& value
    )
    {
        if (i >= tokens.size() || tokens[i].type == token::kind::punctuation)
        {
            return false;
        }
        value = tokens[i++].text;
        return true;
    }
};

template<> struct form<vector>
{
    static constexpr const char* name = "a vector (x y z)";

    static bool read(const tokenList& tokens, std::size_t& i, vector& v)
    {
        if (i >= tokens.size() || !tokens[i].is('('))
        {
            return false;
        }
        std::size_t j = i + 1;
        using number = form<double>;
        if
        (
            !number::read(tokens, j, v.x)
         || !number::read(tokens, j, v.y)
         || !number::read(tokens, j, v.z)
         || j >= tokens.size()
         || !tokens[j].is(')')
        )
        {
            return false;
        }
        i = j + 1;
        return true;
    }
};

template<class T> struct form<std::vector<T>>
{
    static inline const std::string text =
        std::string("a list, (..) N(..) or N{..}, of which each is ")
      + form<T>::name;
    static inline const char* const name = text.c_str();

    static bool read
    (
        const tokenList& tokens,
        std::size_t& i,
        std::vector<T>& list
    )
    {
        list.clear();
        int count = -1;
        if (form<int>::read(tokens, i, count) && count < 0)
        {
            return false;
        }
        if (i >= tokens.size())
        {
            return count == 0;
        }
        if (tokens[i].is('{') && count >= 0 && count <= 100000000)
        {
            T value{};
            if (!form<T>::read(tokens, ++i, value) || i >= tokens.size()
             || !tokens[i].is('}'))
            {
                return false;
            }
            ++i;
            list.assign(std::size_t(count), value);
            return true;
        }
        if (!tokens[i].is('('))
        {
            return false;
        }
        for (++i; i < tokens.size() && !tokens[i].is(')');)
        {
            T value{};
            if (!form<T>::read(tokens, i, value))
            {
                return false;
            }
            list.push_back(value);
        }
        return i++ < tokens.size()
            && (count < 0 || std::size_t(count) == list.size());
    }
};


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
    if (form<T>::read(e.tokens, i, value) && i == e.tokens.size())
    {
        return value;
    }
    std::string remedy;
    const tokenList& t = e.tokens;
    for (std::size_t j = 0; j + 1 < t.size() && remedy.empty(); ++j)
    {
        if (t[j + 1].line > t[0].line && t[0].line == t[j].line
         && !t[j].is('(') && !t[j + 1].is('('))
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
            + described(t) + ", " + form<T>::name + " was expected",
        e.where,
        remedy
    );
}

} // namespace


template<class T>
T dictionary::get(const std::string& key) const
{
    const entry& e = primitive(key, form<T>::name);
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
    const entry& e = primitive(key, form<double>::name);
    return readWhole<double>(e, name_, skipDimensions(e, &expected));
}


vector dictionary::getDimensionedVector
(
    const std::string& key,
    const dimensionSet& expected
) const
{
    const entry& e = primitive(key, form<vector>::name);
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
