#include "case/domain.H"

#include "base/error.H"
#include "case/caseFileIO.H"
#include "case/foamFile.H"
#include "dictionary/dictionary.H"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gpuFsi
{

namespace
{

std::string triple(const vector& v)
{
    return fmt::format("({:.17g} {:.17g} {:.17g})", v.x, v.y, v.z);
}

std::string quoted(const std::string& word)
{
    return word.find_first_of(" \t'/;{}()$") == std::string::npos
        ? word
        : '"' + word + '"';
}

bool finite(const vector& v)
{
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

std::string listed(const std::vector<std::string>& words)
{
    std::string text;
    for (const std::string& word : words)
    {
        text += (text.empty() ? "" : " ") + quoted(word);
    }
    return text;
}

//- Entries that are there only with solids
std::string solidsText(const domain& d)
{
    if (d.solids.empty())
    {
        return {};
    }
    std::string text =
        "\n// By index in constant/solid\nsolids      (" + listed(d.solids)
      + ");\n";
    std::string parts;
    for (const domain::solidPart& p : d.solidParts)
    {
        parts += (parts.empty() ? "(" : " (") + listed({p.solid, p.name})
            + ")";
    }
    return parts.empty() ? text : text + "solidParts  (" + parts + ");\n";
}

[[noreturn]] void reject
(
    const dictionary& dict,
    const std::string& key,
    const std::string& message
)
{
    throw userError
    (
        message,
        dict.where(key),
        "seedParticles writes this file: run it again rather than edit it."
    );
}

void readSolids(const dictionary& dict, domain& d)
{
    d.solids = dict.getOrDefault("solids", std::vector<std::string>());
    if (!dict.found("solidParts"))
    {
        return;
    }
    std::vector<std::string> words;
    for (const token& t : dict.tokens("solidParts"))
    {
        if (t.type != token::kind::punctuation)
        {
            words.push_back(t.text);
        }
    }
    for (std::size_t i = 0; i + 1 < words.size(); i += 2)
    {
        d.solidParts.push_back({words[i], words[i + 1]});
        if
        (
            std::find(d.solids.begin(), d.solids.end(), words[i])
         == d.solids.end()
        )
        {
            reject
            (
                dict,
                "solidParts",
                "Part " + words[i + 1] + " is of " + words[i]
              + ", which is no solid"
            );
        }
    }
    if (words.size() % 2)
    {
        reject
        (
            dict,
            "solidParts",
            "solidParts holds pairs of a solid and a part, found "
          + std::to_string(words.size()) + " words"
        );
    }
}

} // namespace

void domain::write(const std::filesystem::path& casePath) const
{
    foamFile header;
    header.cls = "dictionary";
    header.location = "constant";
    header.object = "domain";
    const auto yes = [&](int d) { return periodic[d] ? "yes" : "no"; };
    writeTextFile
    (
        casePath/"constant/domain",
        header.text() + fmt::format
        (
            "// Written by seedParticles for the programs after it\n\n"
            "dimensions  {};    // 2: the x-y plane\n\n"
            "spacing     {:.17g};    // of the particles, m\n\n"
            "// Bounds, m\n"
            "lo          {};\n"
            "hi          {};\n\n"
            "periodic    ({} {} {});    // in x y z\n\n"
            "volume      {:.17g};    // of the fluid, m^3 (2-D: m^2)\n\n"
            "// By patch index\n"
            "walls       ({});\n",
            dimensions, spacing, triple(lo), triple(hi), yes(0), yes(1),
            yes(2), volume, listed(walls)
        ) + solidsText(*this)
    );
}

domain domain::read(const std::filesystem::path& casePath)
{
    const std::filesystem::path file = casePath/"constant/domain";
    if (!std::filesystem::exists(file))
    {
        throw userError
        (
            "There is no file " + file.string(),
            {file.string()},
            "Run seedParticles first: it writes it."
        );
    }
    const dictionary dict = dictionary::fromFile(file);
    domain d;
    d.dimensions = dict.get<int>("dimensions");
    d.spacing = dict.get<double>("spacing");
    d.lo = dict.get<vector>("lo");
    d.hi = dict.get<vector>("hi");
    d.volume = dict.get<double>("volume");
    d.walls = dict.get<std::vector<std::string>>("walls");
    const auto periodic = dict.get<std::vector<bool>>("periodic");

    if (d.dimensions != 2 && d.dimensions != 3)
    {
        reject
        (
            dict,
            "dimensions",
            "dimensions must be 2 or 3, found "
          + std::to_string(d.dimensions)
        );
    }
    if (!(d.spacing > 0) || !std::isfinite(d.spacing))
    {
        reject
        (
            dict,
            "spacing",
            fmt::format("spacing must be positive, found {}", d.spacing)
        );
    }
    const bool ordered = d.lo.x < d.hi.x && d.lo.y < d.hi.y
        && (d.dimensions == 2 ? d.lo.z <= d.hi.z : d.lo.z < d.hi.z);
    if (!ordered || !finite(d.lo) || !finite(d.hi))
    {
        reject
        (
            dict,
            "hi",
            "hi " + triple(d.hi) + " must be above lo " + triple(d.lo)
        );
    }
    if (periodic.size() != 3)
    {
        reject
        (
            dict,
            "periodic",
            "periodic must have three values, found "
          + std::to_string(periodic.size())
        );
    }
    if (!(d.volume >= 0) || !std::isfinite(d.volume))
    {
        reject
        (
            dict,
            "volume",
            fmt::format("volume must not be negative, found {}", d.volume)
        );
    }
    for (int axis = 0; axis < 3; ++axis)
    {
        d.periodic[axis] = periodic[axis];
    }
    readSolids(dict, d);
    dict.warnUnread();
    return d;
}

} // namespace gpuFsi
