#include "startTimes.H"

#include "case/timeControls.H"

#include <algorithm>
#include <cmath>

namespace gpuFsi
{

static instant timeOfRun
(
    const std::vector<instant>& all,
    const std::filesystem::path& casePath
)
{
    const dictionary dict =
        dictionary::fromFile(casePath/"system/controlDict");
    const timeControls controls = timeControls::read(dict);
    if (controls.startFrom != "startTime")
    {
        return controls.startFrom == "firstTime" ? all.front() : all.back();
    }
    const double wanted = controls.startTime;
    const std::string name =
        controls.timeName(wanted, controls.timePrecision);
    const auto found = std::find_if
    (
        all.begin(),
        all.end(),
        [&](const instant& t)
        {
            return t.name == name
                || std::abs(t.value - wanted) <= 1e-9*std::abs(wanted);
        }
    );
    if (found == all.end())
    {
        throw userError
        (
            "There is no folder of startTime " + name + " in "
          + casePath.string(),
            dict.where("startTime"),
            "Give a time that is there, or decompose with -latestTime."
        );
    }
    return *found;
}


std::vector<instant> startTimes(const argList& args)
{
    const std::vector<instant> all = findTimes(args.casePath());
    if (all.empty())
    {
        throw userError
        (
            "There is no time folder in " + args.casePath().string(),
            {},
            "Run seedParticles first: it writes time 0."
        );
    }
    return args.found("time") || args.found("latestTime")
      ? selectTimes(all, args)
      : std::vector<instant>{timeOfRun(all, args.casePath())};
}

} // namespace gpuFsi
