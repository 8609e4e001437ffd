#include "runSteps.H"

#include "particles/stateIO.H"

#include <algorithm>
#include <fmt/format.h>

namespace gpuFsi
{

namespace
{

class timeLoop
{
public:

    timeLoop
    (
        Time& time,
        const runControls& controls,
        const fluidProperties& fluid,
        fluidSolver& solver,
        functionObjectList& functions,
        runReport& report
    )
    :
        time_(time),
        controls_(controls),
        fluid_(fluid),
        solver_(solver),
        functions_(functions),
        report_(report)
    {}

    void run()
    {
        if (functions_.needsLedger())
        {
            solver_.keepLedger();
        }
        if (!functions_.empty())
        {
            functions_.start(state(), report_.info());
        }
        while (time_.run())
        {
            adjustDeltaT();
            const double before = time_.value();
            ++time_;
            solver_.step(before, time_.deltaT());
            report();
            observe();
            write();
            maintain();
        }
    }

    void writeInto(const std::filesystem::path& directory)
    {
        const auto pressure = [&](double rho) { return fluid_.pressure(rho); };
        writeState(directory, state(), pressure, time_.writing());
    }

private:

    void adjustDeltaT()
    {
        if (time_.adjustTimeStep())
        {
            const double viscous =
                report_.diffusion()*time_.maxCo()/controls_.maxDi;
            const double courant = report_.courant(solver_.monitor());
            time_.adjustDeltaT(std::max(courant, viscous));
        }
    }

    void report()
    {
        if (time_.index() % controls_.logInterval == 0 || time_.writeTime())
        {
            report_.printStep(solver_.monitor());
        }
    }

    void observe()
    {
        if (functions_.due(report_.info()))
        {
            solver_.monitor();
            const double begin = time_.clockSeconds();
            functions_.execute(state(), report_.info());
            report_.addFunctionSeconds(time_.clockSeconds() - begin);
        }
    }

    //- A restart finds fresh neighbours; so must the run that goes on
    void write()
    {
        if (!time_.writeTime())
        {
            return;
        }
        solver_.maintain();
        solver_.refreshNeighbours();
        const double begin = time_.clockSeconds();
        time_.write([&](const std::filesystem::path& d) { writeInto(d); });
        report_.addWriteSeconds(time_.clockSeconds() - begin);
    }

    void maintain()
    {
        if (solver_.maintenanceDue())
        {
            solver_.maintain();
        }
    }

    hostState state() const
    {
        hostState s = solver_.download();
        s.time = time_.value();
        return s;
    }

    Time& time_;
    const runControls& controls_;
    const fluidProperties& fluid_;
    fluidSolver& solver_;
    functionObjectList& functions_;
    runReport& report_;
};

} // namespace


void runSteps
(
    Time& time,
    const runControls& controls,
    const fluidProperties& fluid,
    fluidSolver& solver,
    functionObjectList& functions,
    runReport& report
)
{
    timeLoop loop(time, controls, fluid, solver, functions, report);
    try
    {
        loop.run();
    }
    catch (const brokenState& e)
    {
        const std::string folder = "broken_" + time.timeName(e.time);
        time.writeAside
        (
            folder,
            [&](const std::filesystem::path& d) { loop.writeInto(d); }
        );
        throw userError
        (
            fmt::format
            (
                "The solution broke down at Time = {}: {}",
                time.timeName(e.time), e.what()
            ),
            {},
            fmt::format
            (
                "That state is in the folder {}. Use a smaller deltaT or more "
                "viscosity; the last time folder is intact.", folder
            )
        );
    }
}

} // namespace gpuFsi
