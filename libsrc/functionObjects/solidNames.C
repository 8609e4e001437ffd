#include "functionObjects/solidNames.H"

#include "base/error.H"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace gpuFsi
{

std::vector<int> solidsOf
(
    const std::vector<std::string>& wanted,
    const sourceSpan& where,
    const std::string& functionObject,
    const hostState& state
)
{
    const std::vector<std::string>& names = state.solid.names;
    if (names.empty())
    {
        throw userError
        (
            fmt::format
            (
                "Function object {} is about solids, but there are none",
                functionObject
            ),
            where,
            "Seed solids (system/seedParticlesDict), or leave it out."
        );
    }
    std::vector<int> found;
    for (const std::string& name : wanted.empty() ? names : wanted)
    {
        const auto at = std::find(names.begin(), names.end(), name);
        if (at == names.end())
        {
            throw userError
            (
                fmt::format
                (
                    "Function object {}: there is no solid '{}'",
                    functionObject, name
                ),
                where,
                fmt::format("Valid are: {}", fmt::join(names, " "))
            );
        }
        found.push_back(int(at - names.begin()));
    }
    return found;
}

} // namespace gpuFsi
