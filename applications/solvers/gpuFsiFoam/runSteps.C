#include "runSteps.H"

#include "parallel/rankState.H"
#include "particles/stateIO.H"

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
        stepControl& stepping,
        const fluidProperties& fluid,
        fluidSolver& solver,
        functionObjectList& functions,
        runReport& report,
        const communicator& ranks
    )
    :
        time_(time),
        controls_(controls),
        stepping_(stepping),
        fluid_(fluid),
        solver_(solver),
        functions_(functions),
        report_(report),
        ranks_(ranks)
    {}

    void run()
    {
        checkDeltaT();
        if (ranks_.parallel())
        {
            functions_.dropLedgers();
        }
        if (!controls_.allowUnstable)
        {
            solver_.watchEnergy();
        }
        if (functions_.needsLedger())
        {
            solver_.keepLedger();
        }
        report_.startLoop();
        startFunctions();
        while (time_.run())
        {
            stepping_.adjust([&]
            {
                return fluid_.eos == fluidProperties::state::Tait
                  ? solver_.monitorDensity() : solver_.monitor();
            });
            const double before = time_.value();
            ++time_;
            solver_.step(before, time_.deltaT());
            report();
            observe();
            write();
            maintain();
        }
        endFunctions();
    }

    void writeInto(const std::filesystem::path& directory)
    {
        const auto pressure = [&](double rho) { return fluid_.pressure(rho); };
        if (!ranks_.parallel())
        {
            writeState(directory, solver_.present(), pressure, time_.writing());
            return;
        }
        hostState s = solver_.download();
        if (s.partial && !ranks_.master())
        {
            // Whole on every rank: one writes them
            static_cast<hostSolid&>(s.solid) = {};
            s.solid.reference.clear();
            s.solid.solid.clear();
        }
        writeState(directory, s, pressure, time_.writing());
    }

private:

    void checkDeltaT()
    {
        if (time_.run())
        {
            const flowMonitor m = solver_.monitor();
            ranks_.agree([&] { stepping_.start(m); });
        }
    }

    void report()
    {
        if (time_.index() % controls_.logInterval == 0 || time_.writeTime())
        {
            report_.printStep(solver_.monitor(), stepping_.limiting());
        }
    }

    void startFunctions()
    {
        if (!functions_.empty())
        {
            observeWith(&functionObjectList::start);
        }
    }

    void observe()
    {
        if (!functions_.empty() && due())
        {
            solver_.monitor();
            observeWith(&functionObjectList::execute);
        }
    }

    //- The seconds told are those before the particles are copied
    void observeWith
    (
        void (functionObjectList::*act)(const hostState&, const runInfo&)
    )
    {
        const double begin = time_.clockSeconds();
        const runInfo figures = report_.info();
        const hostState& whole = wholeState();
        onMaster([&] { (functions_.*act)(whole, figures); });
        gathered_ = {};
        report_.addFunctionSeconds(time_.clockSeconds() - begin);
    }

    void endFunctions()
    {
        if (!functions_.empty())
        {
            onMaster([&] { functions_.end(report_.info()); });
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

    //- Only the master's objects count what they have done
    bool due()
    {
        return ranks_.any(ranks_.master() && functions_.due(report_.info()));
    }

    void onMaster(const std::function<void()>& f)
    {
        ranks_.agree([&]
        {
            if (ranks_.master())
            {
                f();
            }
        });
    }

    //- Of all ranks, on the master; until the next call
    const hostState& wholeState()
    {
        if (!ranks_.parallel())
        {
            return solver_.present();
        }
        hostState s = solver_.download();
        gathered_ =
            s.partial ? gatherState(ranks_, std::move(s)) : std::move(s);
        return gathered_;
    }

    Time& time_;
    const runControls& controls_;
    stepControl& stepping_;
    const fluidProperties& fluid_;
    fluidSolver& solver_;
    functionObjectList& functions_;
    runReport& report_;
    const communicator& ranks_;
    hostState gathered_;
};

} // namespace


void runSteps
(
    Time& time,
    const runControls& controls,
    stepControl& stepping,
    const fluidProperties& fluid,
    fluidSolver& solver,
    functionObjectList& functions,
    runReport& report,
    const communicator& ranks
)
{
    timeLoop loop
    (
        time, controls, stepping, fluid, solver, functions, report, ranks
    );
    try
    {
        loop.run();
    }
    catch (const brokenState& e)
    {
        if (ranks.parallel())
        {
            throw;    // of the solids, on every rank alike
        }
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
                "{} That state is in the folder {}. Use a smaller deltaT or "
                "more viscosity; the last time folder is intact.",
                stepping.tellShortest(e.speed), folder
            )
        );
    }
}

} // namespace gpuFsi
