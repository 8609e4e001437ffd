#include "seedSettings.H"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace gpuFsi
{

static std::array<bool, 3> readPeriodic(const dictionary& dict)
{
    if (!dict.found("periodic"))
    {
        return {};
    }
    const auto words = dict.get<std::vector<bool>>("periodic");
    if (words.size() != 3)
    {
        throw userError
        (
            fmt::format("periodic has {} words", words.size()),
            dict.where("periodic"),
            "Give three, for x, y and z, as (no no yes)."
        );
    }
    return {words[0], words[1], words[2]};
}


static seedField readField(const dictionary& dict, const std::string& key)
{
    seedField field{key, dict.where(key), {}};
    for (const token& t : dict.tokens(key))
    {
        if (t.type != token::kind::punctuation)
        {
            field.components.emplace_back(t.text, field.where);
        }
    }
    const std::size_t n = field.components.size();
    const bool fits = key == "rho" ? n == 1 : key == "U" ? n == 3
        : n == 1 || n == 3;
    if (!fits)
    {
        throw userError
        (
            fmt::format("Field {} has {} values", key, n),
            field.where,
            "Give a number or one quoted expression for a scalar (as rho),"
            " three in parentheses for a vector (as U)."
        );
    }
    return field;
}


seedSettings::seedSettings
(
    const dictionary& dict,
    const std::filesystem::path& casePath
)
:
    fluid(dict.getOrDefault("fluid", true)),
    displace(dict.getNumberOrDefault("displace", 0, 0, 0.5)),
    seed(dict.getNumberOrDefault("seed", 0, 0, 9007199254740992.0))
{
    const double dimensions = dict.getNumberOrDefault("dimensions", 3, 2, 3);
    if (dimensions != 2 && dimensions != 3)
    {
        throw userError
        (
            fmt::format("dimensions {} is neither 2 nor 3", dimensions),
            dict.where("dimensions"),
            "2 is the x-y plane."
        );
    }
    const double spacing = dict.get<double>("spacing");
    if (!(spacing > 0) || !std::isfinite(spacing))
    {
        throw userError
        (
            fmt::format("spacing {} is not a positive number", spacing),
            dict.where("spacing"),
            "Give the distance between particles in metres."
        );
    }
    if (const dictionary* given = dict.subDictPtr("solids"))
    {
        solids = readSolids(*given, casePath, int(dimensions), spacing);
    }
    if (solids.empty() || dict.found("regions"))
    {
        readRegions
        (
            dict.subDict("regions"), casePath, int(dimensions), spacing
        );
    }
    checkNames(dict);
    const box b = readBounds(dict, int(dimensions), spacing);
    mesh = std::make_unique<lattice>
    (
        int(dimensions),
        spacing,
        b.first,
        b.second,
        readPeriodic(dict),
        dict.where(dict.found("bounds") ? "bounds" : "spacing")
    );
    readFields(dict);
}


void seedSettings::readRegions
(
    const dictionary& dict,
    const std::filesystem::path& casePath,
    int dimensions,
    double spacing
)
{
    for (const std::string& name : dict.keys())
    {
        if (!dict.isDict(name))
        {
            throw userError
            (
                "Region " + name + " is not a dictionary",
                dict.where(name),
                "Write " + name + " { type box; min (0 0 0); max (1 1 1); }"
            );
        }
        regions.push_back
        (
            makeRegion
            ({
                name, dict.subDict(name), casePath, dimensions, spacing
            })
        );
    }
}


void seedSettings::checkNames(const dictionary& dict) const
{
    for (const solidInput& s : solids)
    {
        for (const auto& r : regions)
        {
            if (r->name() == s.name)
            {
                throw userError
                (
                    "Solid " + s.name + " has the name of a region",
                    s.shape->where(),
                    "Both name walls: give it another name."
                );
            }
        }
    }
    if (!fluid && solids.empty())
    {
        throw userError
        (
            "fluid is no and there are no solids: nothing is seeded",
            dict.where("fluid"),
            "Add solids, or remove the entry fluid."
        );
    }
}


void seedSettings::readFields(const dictionary& dict)
{
    const dictionary* given = dict.subDictPtr("fields");
    const std::vector<std::string> reserved
    {
        "positions", "m", "normal", "area", "patch", "node"
    };
    for (const std::string& key : given ? given->keys() : reserved)
    {
        if (!given)
        {
            break;
        }
        if (std::find(reserved.begin(), reserved.end(), key) != reserved.end())
        {
            throw userError
            (
                "Field " + key + " cannot be given",
                given->where(key),
                "seedParticles computes it."
            );
        }
        fields.push_back(readField(*given, key));
    }
    const auto has = [&](const std::string& name)
    {
        return std::any_of
        (
            fields.begin(),
            fields.end(),
            [&](const seedField& f) { return f.name == name; }
        );
    };
    if (!has("rho"))
    {
        fields.push_back({"rho", {}, {}});
        fields.back().components.emplace_back("1");
    }
    if (!has("U"))
    {
        fields.push_back({"U", {}, {}});
        for (int i = 0; i < 3; ++i)
        {
            fields.back().components.emplace_back("0");
        }
    }
}


box seedSettings::boundsOfSolids() const
{
    vector lo{INFINITY, INFINITY, INFINITY};
    vector hi{-INFINITY, -INFINITY, -INFINITY};
    for (const solidInput& s : solids)
    {
        const auto b = s.shape->bounds();
        for (int axis = 0; b && axis < 3; ++axis)
        {
            component(lo, axis) =
                std::min(component(lo, axis), component(b->first, axis));
            component(hi, axis) =
                std::max(component(hi, axis), component(b->second, axis));
        }
    }
    return {lo, hi};
}


box seedSettings::readBounds
(
    const dictionary& dict,
    int dimensions,
    double spacing
) const
{
    if (dict.found("bounds"))
    {
        const auto b = dict.get<std::vector<vector>>("bounds");
        if (b.size() != 2)
        {
            throw userError
            (
                fmt::format("bounds has {} points", b.size()),
                dict.where("bounds"),
                "Give two, as ((0 0 0) (1 1 1))."
            );
        }
        return {b[0], b[1]};
    }

    // The fluid lies within every region that has an end
    vector lo{-INFINITY, -INFINITY, -INFINITY};
    vector hi{INFINITY, INFINITY, INFINITY};
    for (const auto& r : regions)
    {
        const auto b = r->fluidInside() ? r->bounds() : std::nullopt;
        for (int axis = 0; b && axis < 3; ++axis)
        {
            component(lo, axis) =
                std::max(component(lo, axis), component(b->first, axis));
            component(hi, axis) =
                std::min(component(hi, axis), component(b->second, axis));
        }
    }
    if (!std::isfinite(lo.x))
    {
        std::tie(lo, hi) = boundsOfSolids();
    }
    if (!(lo.x <= hi.x))
    {
        throw userError
        (
            "bounds are missing and no region encloses the fluid",
            dict.where(),
            "Give bounds ((xLow yLow zLow) (xHigh yHigh zHigh));"
        );
    }
    // Whole cells, the region in their middle
    for (int axis = 0; axis < dimensions; ++axis)
    {
        double& low = component(lo, axis);
        double& high = component(hi, axis);
        const double cells = std::ceil((high - low)/spacing - 1e-6);
        const double grow = 0.5*(cells*spacing - (high - low));
        low -= grow;
        high += grow;
    }
    return {lo, hi};
}

} // namespace gpuFsi
