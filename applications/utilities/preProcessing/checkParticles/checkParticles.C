// Looks at the particles of time folders before or after a run: places,
// spacing, neighbours, weights, solids; and tells how long a time step may be.
//
// Usage: checkParticles [-case DIR] [-time RANGES] [-latestTime] [-noZero]
// Reads  constant, system/{controlDict,particleSchemes}, the times' clouds.
// Exit code: 0 Particles OK, 1 a check failed or nothing could be read.

#include "base/log.H"
#include "case/Time.H"
#include "case/argList.H"
#include "case/timeControls.H"
#include "checks.H"
#include "limits/chooseSuperSteps.H"
#include "particles/stateIO.H"

using namespace gpuFsi;

static checkedCase readCase(const std::filesystem::path& casePath)
{
    checkedCase c;
    c.space = domain::read(casePath);
    c.fluid = fluidProperties::read(casePath, c.space);
    c.schemes = particleSchemes::read(casePath, c.space);
    c.solids = solidScene::read(casePath, c.space);
    const timeControls controls = timeControls::read
    (
        dictionary::fromFile(casePath/"system"/"controlDict")
    );
    c.deltaT = controls.deltaT;
    c.adjusts = controls.adjustTimeStep;
    if (c.space.hasFluid())
    {
        c.whySuperSteps = chooseSuperSteps
        (
            c.schemes, flowScalesOf(c.space, c.fluid),
            c.adjusts ? std::nullopt : std::optional<double>(c.deltaT)
        );
    }
    return c;
}


static void checkTime
(
    const checkedCase& c,
    const std::filesystem::path& casePath,
    const instant& time,
    findings& found
)
{
    checkedTime t;
    t.state = readState(casePath/time.name, c.space, c.fluid.rho0, true);
    t.state.time = time.value;
    info("Time = {}\n", time.name);
    info
    (
        "Particles: {} fluid, {} wall, {} solid, spacing {:.6g}, {}-D",
        t.state.fluid.size(), t.state.walls.size(), t.state.solid.size(),
        c.space.spacing, c.space.dimensions
    );
    std::unique_ptr<neighbourRows> rows;
    if (c.space.hasFluid())
    {
        checkPlaces(c, t, found);
        if (t.state.fluid.size() > 0)
        {
            rows = neighbourRows::make(c, t);
            checkSpacing(c, t, found);
            checkRows(c, t, *rows, found);
        }
    }
    checkSolids(c, t, found);
    checkSteps(c, t, rows.get(), found);
}


static std::vector<instant> timesOf(const argList& args)
{
    const std::vector<instant> times =
        selectTimes(findTimes(args.casePath()), args);
    if (times.empty())
    {
        throw userError
        (
            "There is no time to check in " + args.casePath().string(),
            {},
            "Run seedParticles first; after a run on many ranks "
            "reconstructParticles."
        );
    }
    return times;
}


static int checkParticles(int argc, char** argv)
{
    const argList args
    (
        argc,
        argv,
        "Check particles and tell how long a time step may be.",
        {
            {"time", "ranges", "times to check, as ':10,20,40:70'"},
            {"latestTime", "", "the latest time only"},
            {"noZero", "", "leave time 0 out"}
        }
    );
    printBanner(args.commandLine(), args.casePath().string());

    const std::vector<instant> times = timesOf(args);
    const checkedCase c = readCase(args.casePath());
    findings found;
    for (const instant& time : times)
    {
        checkTime(c, args.casePath(), time, found);
    }
    found.printEnd();
    info("End\n");
    return found.failed() > 0 ? 1 : 0;
}


int main(int argc, char** argv)
{
    return runMain
    (
        "checkParticles", [&] { return checkParticles(argc, argv); }
    );
}
