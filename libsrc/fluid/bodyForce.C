#include "fluid/bodyForce.H"

#include "dictionary/dictionary.H"
#include "dictionary/expression.H"

#include <cmath>
#include <fmt/format.h>

namespace gpuFsi
{

namespace fs = std::filesystem;

struct bodyForce::law
{
    std::vector<expression> components;
    sourceSpan where;
};


bodyForce::bodyForce(const vector& constant)
:
    constant_(constant)
{}


static bool hasString(const std::vector<token>& tokens)
{
    for (const token& t : tokens)
    {
        if (t.type == token::kind::string)
        {
            return true;
        }
    }
    return false;
}


static void refusePlaces(const expression& e, const sourceSpan& where)
{
    for (const char* name : {"x", "y", "z", "r"})
    {
        if (e.uses(name))
        {
            throw userError
            (
                fmt::format
                (
                    "The body force '{}' depends on {}, but is to be the "
                    "same everywhere", e.text(), name
                ),
                where,
                "Write expressions of the time t alone."
            );
        }
    }
}


static std::vector<expression> components
(
    const dictionary& dict,
    const sourceSpan& where
)
{
    const auto texts = dict.get<std::vector<std::string>>("value");
    if (texts.size() != 3)
    {
        throw userError
        (
            fmt::format
            (
                "The body force has {} components, not 3", texts.size()
            ),
            where,
            "Write value (\"cos(t)\" 0 0);"
        );
    }
    std::vector<expression> list;
    for (const std::string& text : texts)
    {
        list.emplace_back(text, where);
        refusePlaces(list.back(), where);
    }
    return list;
}


bodyForce bodyForce::read(const fs::path& casePath)
{
    bodyForce g;
    const fs::path file = casePath/"constant"/"g";
    if (!fs::exists(file))
    {
        return g;
    }
    const dictionary dict = dictionary::fromFile(file);
    if (dict.found("dimensions"))
    {
        dict.tokens("dimensions");
    }
    if (dict.found("value") && hasString(dict.tokens("value")))
    {
        const sourceSpan where = dict.where("value");
        const auto all = std::make_shared<const law>
        (
            law{components(dict, where), where}
        );
        g.law_ = all;
        bool steady = true;
        for (const expression& e : all->components)
        {
            steady = steady && !e.uses("t");
        }
        if (steady)
        {
            g = bodyForce(g.at(0));
        }
    }
    else
    {
        g.constant_ =
            dict.getDimensionedVector("value", dimensions::acceleration);
    }
    dict.warnUnread();
    return g;
}


bool bodyForce::acts(int axis) const
{
    const double constants[3] = {constant_.x, constant_.y, constant_.z};
    return law_
      ? law_->components[axis].uses("t")
     || law_->components[axis]({0, 0, 0}, 0) != 0
      : constants[axis] != 0;
}


vector bodyForce::fromLaw(double t) const
{
    double g[3];
    for (int i = 0; i < 3; ++i)
    {
        const expression& e = law_->components[i];
        g[i] = e({0, 0, 0}, t);
        if (!std::isfinite(g[i]))
        {
            throw userError
            (
                fmt::format
                (
                    "The body force '{}' is {} at t = {:.9g}",
                    e.text(), g[i], t
                ),
                law_->where,
                "Guard the singular time, as in t > 0 ? sin(t)/t : 1."
            );
        }
    }
    return {g[0], g[1], g[2]};
}

} // namespace gpuFsi
