#include "stepping/particleSchemes.H"

#include "dictionary/dictionary.H"

#include <fmt/format.h>

namespace gpuFsi
{

particleSchemes particleSchemes::read
(
    const std::filesystem::path& casePath,
    const domain& d
)
{
    const dictionary dict =
        dictionary::fromFile(casePath/"system"/"particleSchemes");

    particleSchemes s;
    dict.getChoiceOrDefault("areaWeights", "radial", {"radial"});
    dict.getChoiceOrDefault("timeScheme", "Euler", {"Euler"});

    s.searchRadius = d.spacing*defaultSearchRadius(d.dimensions);
    if (const dictionary* n = dict.subDictPtr("neighbours"))
    {
        const std::string method = n->getChoiceOrDefault
        (
            "method", "cellSearch", {"cellSearch", "localUpdate"}
        );
        s.method = method == "cellSearch"
          ? search::cellSearch : search::localUpdate;
        s.searchRadius = d.spacing*n->getNumberOrDefault
        (
            "searchRadius", defaultSearchRadius(d.dimensions), 1.8, 4
        );
        const std::string update = n->getChoiceOrDefault
        (
            "update", "displacement", {"displacement", "interval"}
        );
        if (update == "interval")
        {
            s.update = trigger::interval;
            s.interval = int(n->getNumber("interval", 1, 1e9));
        }
        else
        {
            s.displacement =
                n->getNumberOrDefault("displacement", 0.1, 1e-6, 1);
        }
    }
    dict.warnUnread();
    return s;
}


std::string particleSchemes::describe() const
{
    return fmt::format
    (
        "areaWeights radial, timeScheme Euler, neighbours {} every {}",
        method == search::cellSearch ? "cellSearch" : "localUpdate",
        update == trigger::interval
      ? fmt::format("{} steps", interval)
      : fmt::format("{:g} h of displacement", displacement)
    );
}

} // namespace gpuFsi
