#include "dictionary/unitText.H"

#include "dictionary/number.H"

#include <cctype>
#include <cstring>
#include <map>

namespace gpuFsi
{

//- SI base and coherent units of .com, quantity names of .org
static const std::map<std::string, dimensionSet>& knownUnits()
{
    static const std::map<std::string, dimensionSet> units
    {
        {"kg", {1, 0, 0, 0, 0, 0, 0}},
        {"m", {0, 1, 0, 0, 0, 0, 0}},
        {"s", {0, 0, 1, 0, 0, 0, 0}},
        {"K", {0, 0, 0, 1, 0, 0, 0}},
        {"mol", {0, 0, 0, 0, 1, 0, 0}},
        {"A", {0, 0, 0, 0, 0, 1, 0}},
        {"cd", {0, 0, 0, 0, 0, 0, 1}},
        {"Hz", {0, 0, -1, 0, 0, 0, 0}},
        {"N", {1, 1, -2, 0, 0, 0, 0}},
        {"Pa", {1, -1, -2, 0, 0, 0, 0}},
        {"J", {1, 2, -2, 0, 0, 0, 0}},
        {"W", {1, 2, -3, 0, 0, 0, 0}},
        {"mass", {1, 0, 0, 0, 0, 0, 0}},
        {"time", {0, 0, 1, 0, 0, 0, 0}},
        {"length", dimensions::length},
        {"velocity", dimensions::velocity},
        {"acceleration", dimensions::acceleration},
        {"density", dimensions::density},
        {"pressure", dimensions::pressure},
        {"dynamicViscosity", dimensions::dynamicViscosity},
        {"kinematicViscosity", dimensions::kinematicViscosity}
    };
    return units;
}


namespace
{

//- product := factor {[* or /] factor};  factor := name or (product), [^ n]
class unitReader
{
public:

    unitReader(std::string text, sourceSpan where)
    :
        text_(std::move(text)),
        where_(std::move(where))
    {}

    dimensionSet all()
    {
        const dimensionSet d = product(0);
        if (peek() != '\0')
        {
            fail("has a stray " + std::string(1, peek()));
        }
        return d;
    }

private:

    std::string text_;
    sourceSpan where_;
    std::size_t at_ = 0;

    char peek()
    {
        while (at_ < text_.size() && text_[at_] == ' ')
        {
            ++at_;
        }
        return at_ < text_.size() ? text_[at_] : '\0';
    }

    [[noreturn]] void fail(const std::string& problem) const
    {
        std::string names;
        for (const auto& unit : knownUnits())
        {
            names += ' ' + unit.first;
        }
        throw userError
        (
            "Dimensions [" + text_ + "] " + problem,
            where_,
            "Write 5 or 7 exponents of kg m s K mol A cd, as in"
            " [0 2 -1 0 0 0 0], or units without a scale, as in [kg m^-3]:"
                + names
        );
    }

    dimensionSet product(int depth)
    {
        if (depth > 20)
        {
            fail("are nested too deeply");
        }
        dimensionSet total = factor(depth);
        for (char c = peek(); c != '\0' && c != ')'; c = peek())
        {
            const int sign = c == '/' ? -1 : 1;
            at_ += c == '/' || c == '*';
            const dimensionSet d = factor(depth);
            for (int i = 0; i < 7; ++i)
            {
                total[i] += sign*d[i];
            }
        }
        return total;
    }

    dimensionSet factor(int depth)
    {
        dimensionSet d;
        if (peek() == '(')
        {
            ++at_;
            d = product(depth + 1);
            if (peek() != ')')
            {
                fail("have an unclosed parenthesis");
            }
            ++at_;
        }
        else
        {
            d = unit();
        }
        if (peek() == '^')
        {
            ++at_;
            const double n = exponent();
            for (double& e : d)
            {
                e *= n;
            }
        }
        return d;
    }

    dimensionSet unit()
    {
        std::string name;
        while (std::isalpha(static_cast<unsigned char>(at_ < text_.size()
            ? text_[at_] : '\0')))
        {
            name += text_[at_++];
        }
        const auto found = knownUnits().find(name);
        if (found == knownUnits().end())
        {
            fail
            (
                name.empty() ? "lack the name of a unit"
              : "name the unknown unit '" + name + "'"
            );
        }
        return found->second;
    }

    double exponent()
    {
        const char c = peek();
        std::string digits;
        while (at_ < text_.size() && (std::isdigit(
            static_cast<unsigned char>(text_[at_]))
         || std::strchr("+-.", text_[at_])))
        {
            digits += text_[at_++];
        }
        double n = 0;
        if (c == '\0' || !readNumber(digits, n, where_))
        {
            fail("lack a number after ^");
        }
        return n;
    }
};

} // namespace


dimensionSet readDimensions
(
    const std::vector<token>& tokens,
    std::size_t begin,
    std::size_t end
)
{
    dimensionSet d = dimensions::none;
    bool allNumbers = true;
    std::string text;
    for (std::size_t i = begin; i < end; ++i)
    {
        allNumbers = allNumbers && tokens[i].type == token::kind::number;
        text += (i > begin ? " " : "") + tokens[i].text;
    }
    if (begin == end)
    {
        return d;
    }
    const sourceSpan where
    {
        tokens[begin].file, tokens[begin].line, tokens[end - 1].line
    };
    if (!allNumbers)
    {
        return unitReader(text, where).all();
    }
    const std::size_t n = end - begin;
    if (n != 5 && n != 7)
    {
        throw userError
        (
            "Dimensions [" + text + "] have " + std::to_string(n)
                + " exponents",
            where,
            "Write 5 or 7 exponents of kg m s K mol A cd."
        );
    }
    for (std::size_t i = 0; i < n; ++i)
    {
        d[i] = tokens[begin + i].number;
    }
    return d;
}


std::string dimensionsText(const dimensionSet& d)
{
    static const char* const units[] = {"kg", "m", "s", "K", "mol", "A", "cd"};
    std::string exponents, symbols;
    for (int i = 0; i < 7; ++i)
    {
        exponents += (i ? " " : "") + numberText(d[i]);
        if (d[i] != 0)
        {
            symbols += std::string(" ") + units[i]
                + (d[i] == 1 ? "" : '^' + numberText(d[i]));
        }
    }
    return '[' + exponents + ']' + (symbols.empty() ? "" : " =" + symbols);
}

} // namespace gpuFsi
