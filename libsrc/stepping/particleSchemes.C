#include "stepping/particleSchemes.H"

#include "dictionary/dictionary.H"

#include <fmt/format.h>

namespace gpuFsi
{

static void readAccuracy(const dictionary& dict, int D, particleSchemes& s)
{
    using schemes = particleSchemes;
    s.areaWeights = dict.getChoiceOrDefault
    (
        "areaWeights", "radial", {"radial", "moment"}
    ) == "moment" ? schemes::weight::moment : schemes::weight::radial;
    if (s.areaWeights == schemes::weight::moment)
    {
        s.weightExponent = dict.getChoiceOrDefault
        (
            "weightExponent", "1", {"1", "3"}
        ) == "3" ? 3 : 1;
    }
    s.faces = dict.getChoiceOrDefault
    (
        "faces", "linear", {"linear", "hermite"}
    ) == "hermite" ? schemes::face::hermite : schemes::face::linear;

    const std::string time = dict.getChoiceOrDefault
    (
        "timeScheme", "Euler", {"Euler", "symplecticEuler", "RK2"}
    );
    s.time = time == "Euler" ? schemes::timeScheme::Euler
      : time == "RK2" ? schemes::timeScheme::RK2
      : schemes::timeScheme::symplecticEuler;

    const std::string super = dict.getChoiceOrDefault
    (
        "superTimeStepping", "auto", {"auto", "on", "off"}
    );
    s.superTimeStepping = super == "on" ? schemes::superStepping::on
      : super == "off" ? schemes::superStepping::off
      : schemes::superStepping::automatic;

    if (s.faces == schemes::face::hermite)
    {
        s.laplacianFactor =
            dict.getNumberOrDefault("laplacianFactor", 1, 0.5, 2);
    }
    s.dissipation = dict.getNumberOrDefault("dissipation", 0, 0, 1);
    s.shifting = dict.getNumberOrDefault("shifting", 0, 0, 5);
    if (s.shifting > 0)
    {
        s.shiftingCap =
            dict.getNumberOrDefault("shiftingCap", D == 3 ? 80 : 8, 1, 1e4);
    }
}


static void refuseWithRadial(const dictionary& dict, const particleSchemes& s)
{
    using schemes = particleSchemes;
    if (s.areaWeights == schemes::weight::moment)
    {
        return;
    }
    const char* key = s.faces == schemes::face::hermite ? "faces"
      : s.dissipation > 0 ? "dissipation"
      : s.shifting > 0 ? "shifting"
      : s.superTimeStepping == schemes::superStepping::on
      ? "superTimeStepping"
      : s.time == schemes::timeScheme::symplecticEuler
      ? "timeScheme" : nullptr;
    if (key)
    {
        throw userError
        (
            fmt::format
            (
                "'{}' goes beyond the published scheme, but areaWeights is "
                "radial", key
            ),
            dict.where(key),
            "Set 'areaWeights moment', or leave the entry out."
        );
    }
}


static void refuseWithGradients
(
    const dictionary& dict,
    const particleSchemes& s
)
{
    if
    (
        s.superTimeStepping == particleSchemes::superStepping::on
     && !s.canSuperStep()
    )
    {
        throw userError
        (
            fmt::format
            (
                "superTimeStepping is on, but laplacianFactor is {:g}, which "
                "needs gradients in every stage", s.laplacianFactor
            ),
            dict.where("superTimeStepping"),
            "Set 'laplacianFactor 1', or 'superTimeStepping off'."
        );
    }
}


particleSchemes particleSchemes::read
(
    const std::filesystem::path& casePath,
    const domain& d
)
{
    particleSchemes s;
    if (!d.hasFluid())
    {
        s.searchRadius = d.spacing*defaultSearchRadius(d.dimensions);
        return s;
    }
    const dictionary dict =
        dictionary::fromFile(casePath/"system"/"particleSchemes");
    readAccuracy(dict, d.dimensions, s);
    refuseWithRadial(dict, s);
    refuseWithGradients(dict, s);

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
    const char* times[] = {"Euler", "symplecticEuler", "RK2"};
    std::string text = fmt::format
    (
        "areaWeights {}, faces {}, timeScheme {}",
        areaWeights == weight::moment ? "moment" : "radial",
        faces == face::hermite ? "hermite" : "linear",
        times[int(time)]
    );
    if (weightExponent > 1)
    {
        text += fmt::format(", weightExponent {}", weightExponent);
    }
    if (faces == face::hermite)
    {
        text += fmt::format(", laplacianFactor {:.6g}", laplacianFactor);
    }
    if (dissipation > 0)
    {
        text += fmt::format(", dissipation {:g}", dissipation);
    }
    if (superSteps)
    {
        text += ", superTimeStepping RKL2";
    }
    if (shifting > 0)
    {
        text += fmt::format(", shifting {:g} (cap {:g})", shifting,
            shiftingCap);
    }
    return text + fmt::format
    (
        ", neighbours {} every {}",
        method == search::cellSearch ? "cellSearch" : "localUpdate",
        update == trigger::interval
      ? fmt::format("{} steps", interval)
      : fmt::format("{:g} h of displacement", displacement)
    );
}

} // namespace gpuFsi
