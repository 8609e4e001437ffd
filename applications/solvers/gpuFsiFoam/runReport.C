#include "runReport.H"

#include "base/log.H"

#include <algorithm>

namespace gpuFsi
{

runReport::runReport
(
    const Time& time,
    const domain& d,
    const fluidProperties& fluid,
    const particleSchemes& schemes,
    const fluidSolver& solver,
    int nRanks
)
:
    time_(time),
    domain_(d),
    fluid_(fluid),
    schemes_(schemes),
    solver_(solver),
    firstIndex_(time.index()),
    startClock_(time.clockSeconds())
{
    info_.casePath = time.casePath();
    info_.startTime = time.timeName();
    info_.dimensions = d.dimensions;
    info_.rho0 = fluid.rho0;
    info_.h = d.spacing;
    info_.ranks = nRanks;
    info_.c = fluid.c;
    info_.mu = fluid.mu;
    info_.forceVaries = fluid.g.varies();
    info_.device = solver.device();
    info_.precision = solver.precision();
    info_.scheme = schemes.describe();
    info_.pressure = [&fluid](double rho) { return fluid.pressure(rho); };
}


void runReport::printScene() const
{
    const std::size_t n =
        solver_.nFluid() + solver_.nWalls() + solver_.nSolid();
    gpuFsi::info("Device      : {}, {} precision", info_.device,
        info_.precision);
    gpuFsi::info("Particles   : {} fluid, {} wall, {} solid, spacing {:.6g}, "
        "{}-D", solver_.nFluid(), solver_.nWalls(), solver_.nSolid(),
        domain_.spacing, domain_.dimensions);
    if (solver_.nFluid() > 0)
    {
        gpuFsi::info("Fluid       : {}, mu = {:.6g}", fluid_.describe(),
            fluid_.mu);
        gpuFsi::info("Schemes     : {}", info_.scheme);
    }
    if (solver_.nSolid() > 0)
    {
        gpuFsi::info("Solids      : {}",
            solver_.describeSolids(time_.deltaT()));
    }
    if (const std::string ranks = solver_.describeRanks(); !ranks.empty())
    {
        gpuFsi::info("Ranks       : {}", ranks);
    }
    gpuFsi::info("Terms       : {}", solver_.terms());
    gpuFsi::info("Memory      : {:.1f} MB, {:.1f} bytes per particle: {}\n",
        solver_.bytes()/1e6, double(solver_.bytes())/n,
        solver_.describeMemory());
}


double runReport::loopSeconds() const
{
    return time_.clockSeconds() - startClock_ - functionSeconds_
      - writeSeconds_;
}


const runInfo& runReport::info()
{
    info_.time = time_.value();
    info_.gravity = fluid_.g.at(info_.time);
    info_.timeName = time_.timeName();
    info_.timeIndex = time_.index();
    info_.deltaT = time_.deltaT();
    info_.writeTime = time_.writeTime();
    info_.loopSeconds = loopSeconds();
    info_.totalSeconds = time_.clockSeconds();
    info_.particleSteps =
        double(solver_.nFluid() + solver_.nSolid())
       *(time_.index() - firstIndex_);
    return info_;
}


double runReport::courant(double speed) const
{
    return (fluid_.c + speed)*time_.deltaT()/domain_.spacing;
}


void runReport::printStep(const flowMonitor& m, const std::string& limiting)
{
    const runInfo& i = info();
    gpuFsi::info("Courant Number mean: {:.6g} max: {:.6g}",
        courant(m.meanSpeed), courant(m.maxSpeed));
    gpuFsi::info("deltaT = {:.6g}", time_.deltaT());
    if (!limiting.empty())
    {
        gpuFsi::info("Time step limited by {}", limiting);
        if (const int n = solver_.viscousStages(time_.deltaT()); n > 0)
        {
            gpuFsi::info("Viscosity in {} stages a half step", n);
        }
    }
    gpuFsi::info("Time = {}", time_.timeName());
    gpuFsi::info("Max speed = {:.6g}  Rate = {:.4g} MIPPS  "
        "To finish = {:.3g} s",
        m.maxSpeed, i.particleSteps/std::max(1e-9, i.loopSeconds)/1e6,
        time_.secondsToFinish());
    gpuFsi::info("{}\n", time_.executionTime());
    std::fflush(stdout);
}


void runReport::printEnd()
{
    const runInfo& i = info();
    const auto stages = solver_.stageSeconds();
    double total = functionSeconds_ + writeSeconds_;
    for (double s : stages)
    {
        total += s;
    }
    const auto line = [total](const char* name, double seconds)
    {
        gpuFsi::info("    {:<18}{:>6.1f} %{:>12.4g} s", name,
            100*seconds/std::max(total, 1e-12), seconds);
    };
    gpuFsi::info
    (
        "Share of time by stage (timed on every 16th, then every 64th step):"
    );
    for (std::size_t s = 0; s < stages.size(); ++s)
    {
        line(stageNames[s], stages[s]);
    }
    line("function objects", functionSeconds_);
    line("writing", writeSeconds_);
    gpuFsi::info("Neighbour refreshes = {}", solver_.nRefreshes());
    if (solver_.nSorts() > 0)
    {
        gpuFsi::info("Storage sorts = {}", solver_.nSorts());
    }
    if (solver_.nReplays() > 0)
    {
        gpuFsi::info("Solid steps as one launch = {}", solver_.nReplays());
    }
    if (const std::string sent = solver_.describeMessages(); !sent.empty())
    {
        gpuFsi::info("Messages: {}", sent);
    }
    if (solver_.nFallbacks() > 0)
    {
        gpuFsi::info("Area weights fell back to first order {} times",
            solver_.nFallbacks());
    }
    gpuFsi::info("Particle-steps = {:.6g}  loop = {:.4g} s  "
        "total = {:.4g} s  ranks = {}  "
        "rate = {:.4g} MIPPS (million particle-steps/s)",
        i.particleSteps, i.loopSeconds, i.totalSeconds, i.ranks,
        i.particleSteps/std::max(1e-9, i.loopSeconds)/1e6);
    gpuFsi::info("{}\n", time_.executionTime());
}

} // namespace gpuFsi
