#include "seeding/solidInput.H"

#include <fmt/format.h>

#include <cmath>

namespace gpuFsi
{

namespace
{

const dictionary& subDict
(
    const dictionary& dict,
    const std::string& name,
    const char* what
)
{
    if (!dict.isDict(name))
    {
        throw userError
        (
            what + (" " + name) + " is not a dictionary",
            dict.where(name),
            "Write " + name + " { type box; min (0 0 0); max (1 1 1); }"
        );
    }
    const dictionary& sub = dict.subDict(name);
    if (sub.found("side"))
    {
        throw userError
        (
            what + (" " + name) + " has a side",
            sub.where("side"),
            "A solid is what is inside its shape: remove the entry."
        );
    }
    return sub;
}

std::vector<std::string> keysOf(const dictionary* dict)
{
    return dict ? dict->keys() : std::vector<std::string>();
}

//- The shape with the fluid outside
std::unique_ptr<region> makeShape
(
    const std::string& name,
    const dictionary& dict,
    const std::filesystem::path& casePath,
    int dimensions,
    double spacing
)
{
    dictionary outside = dict;
    outside.set("side", "outside");
    return makeRegion({name, outside, casePath, dimensions, spacing});
}

double readSpacing(const dictionary& dict, double otherwise)
{
    const double spacing = dict.getOrDefault("spacing", otherwise);
    if (!(spacing > 0) || !std::isfinite(spacing))
    {
        throw userError
        (
            fmt::format("spacing {} is not a positive number", spacing),
            dict.where("spacing"),
            "Give the distance between the solid's particles in metres."
        );
    }
    return spacing;
}

std::vector<expression> readVelocity(const dictionary& dict)
{
    std::vector<expression> components;
    if (!dict.found("U"))
    {
        return components;
    }
    for (const token& t : dict.tokens("U"))
    {
        if (t.type != token::kind::punctuation)
        {
            components.emplace_back(t.text, dict.where("U"));
        }
    }
    if (components.size() != 3)
    {
        throw userError
        (
            fmt::format("U has {} values", components.size()),
            dict.where("U"),
            "Give three numbers or quoted expressions in parentheses."
        );
    }
    return components;
}

} // namespace

std::vector<solidInput> readSolids
(
    const dictionary& solids,
    const std::filesystem::path& casePath,
    int dimensions,
    double spacing
)
{
    std::vector<solidInput> result;
    for (const std::string& name : solids.keys())
    {
        const dictionary& dict = subDict(solids, name, "Solid");
        solidInput s;
        s.name = name;
        s.spacing = readSpacing(dict, spacing);
        s.where = dict.found("spacing") ? dict.where("spacing") : dict.where();
        s.U = readVelocity(dict);
        s.shape = makeShape(name, dict, casePath, dimensions, s.spacing);
        if (!s.shape->closed())
        {
            throw userError
            (
                "Solid " + name + ": a " + dict.get<std::string>("type")
              + " encloses nothing",
                dict.where("type"),
                "Valid are box, sphere, cylinder, levelSet and surface."
            );
        }
        const dictionary* parts = dict.subDictPtr("parts");
        for (const std::string& part : keysOf(parts))
        {
            const dictionary& where = subDict(*parts, part, "Part");
            const bool surface = where.getOrDefault("surface", false);
            s.parts.push_back
            ({
                part,
                makeShape(part, where, casePath, dimensions, s.spacing),
                surface
            });
        }
        result.push_back(std::move(s));
    }
    return result;
}

} // namespace gpuFsi
