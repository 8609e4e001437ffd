#include "stepControl.H"

#include "base/log.H"
#include "limits/chooseSuperSteps.H"
#include "limits/solidScalesOf.H"

#include <cmath>

namespace gpuFsi
{

//- Of a limit, that a step may take; as for the sub-steps of solids
static constexpr double share = 0.8;

static constexpr double infinite = std::numeric_limits<double>::infinity();

//- Of all ranks
static solidScales solidsOf
(
    const scene& s,
    fluidSolver& solver,
    const communicator& ranks
)
{
    solidScales solid;
    if (s.solids)
    {
        solid = solidScalesOf(*s.solids, s.fluid, solver.download());
        double most[2] = {-solid.massPerArea, solid.omegaMax};
        ranks.max(most, 2);
        solid.massPerArea = -most[0];
        solid.omegaMax = most[1];
    }
    return solid;
}


//- A restart must find it again where deltaT follows it: then the least that
//  seeding gives walls that rest
static double wallGapOf(const scene& s, fluidSolver& solver)
{
    constexpr double seeded = 0.5;
    return solver.nWalls() == 0 || s.fluid.mu == 0 ? 0
      : s.time->adjustTimeStep() ? seeded : solver.wallGap();
}


stepControl::stepControl
(
    const scene& s,
    fluidSolver& solver,
    const communicator& ranks
)
:
    time_(*s.time),
    solver_(solver),
    whySuperSteps_(s.whySuperSteps),
    controls_(*s.controls),
    fluid_(s.fluid),
    schemes_(s.schemes),
    acoustic_{"acoustic", infinite},
    viscous_{"viscous", infinite}
{
    const bool fluid = s.space.hasFluid();
    scales_.flow = fluid ? flowScalesOf(s.space, s.fluid)
      : flowScales{s.space.dimensions, s.space.spacing, 0, 0};
    scales_.flow.wallGap = fluid ? wallGapOf(s, solver) : 0;
    scales_.rho = s.fluid.rho0;
    scales_.solid = solidsOf(s, solver, ranks);
}


//- Where the fluid is densest, m/s
double stepControl::soundSpeed(const flowMonitor& m) const
{
    return fluid_.eos == fluidProperties::state::Tait && m.maxDeltaRho > 0
      ? fluid_.c*std::pow
        (
            1 + m.maxDeltaRho/fluid_.rho0, 0.5*(fluid_.gamma - 1)
        )
      : fluid_.c;
}


caseScales stepControl::scalesOf(const flowMonitor& m) const
{
    caseScales s = scales_;
    if (s.flow.c > 0)
    {
        const vector g = fluid_.g.at(time_.value());
        s.flow.c = soundSpeed(m);
        s.relativeSpeed = m.maxRelativeSpeed;
        s.force = std::sqrt(dot(g, g));
    }
    return s;
}


std::string stepControl::describe
(
    const termLimit& l,
    const caseScales& s
) const
{
    std::string text = fmt::format
    (
        "deltaT {:.6g} is beyond the {} limit {:.6g}", time_.deltaT(), l.term,
        l.deltaT
    );
    const double grows =
        s.flow.c > 0 ? growthOf(schemes_, s.flow, time_.deltaT()) : 0;
    if (grows > slowGrowth)
    {
        text += fmt::format
        (
            ": the fastest waves grow {:.4g}-fold a step", std::exp(grows)
        );
    }
    return text;
}


//- With adjustTimeStep their number follows deltaT
void stepControl::tellOfSuperSteps() const
{
    if (const int n = solver_.viscousStages(time_.deltaT()); n > 0)
    {
        info
        (
            "Viscosity: {}: RKL2, {}\n", whySuperSteps_,
            time_.adjustTimeStep()
          ? "as many stages as deltaT needs"
          : fmt::format("{} stages in each half of a step", n)
        );
    }
}


void stepControl::start(const flowMonitor& m)
{
    if (time_.adjustTimeStep())
    {
        tellOfSuperSteps();
        if (wanted(m).deltaT == infinite)
        {
            throw userError
            (
                "adjustTimeStep has no limit to follow: there is no fluid, and "
                "the solids' sub-steps follow deltaT",
                time_.controlDict().where("adjustTimeStep"),
                "Leave it out: deltaT is then the time from one load and log "
                "entry to the next."
            );
        }
        return;
    }
    tellOfSuperSteps();
    checked_ = time_.deltaT();
    const caseScales scales = scalesOf(m);
    const auto beyond = exceeded(schemes_, scales, checked_, fastGrowth);
    if (beyond && !controls_.allowUnstable)
    {
        throw userError
        (
            describe(*beyond, scales), time_.controlDict().where("deltaT"),
            "Take a smaller deltaT, or 'adjustTimeStep yes'; checkParticles "
            "tells all limits. With 'allowUnstable yes' it runs all the same."
        );
    }
    warnBeyond(scales);
}


void stepControl::warnBeyond(const caseScales& scales) const
{
    if (const auto beyond = exceeded(schemes_, scales, checked_))
    {
        warning(describe(*beyond, scales));
    }
}


//- The shortest of what the limits and the user allow
termLimit stepControl::wanted(const flowMonitor& m) const
{
    const caseScales s = scalesOf(m);
    std::vector<termLimit> limits = plainLimits(s);
    limits.push_back(acoustic_);
    limits.push_back(viscous_);
    for (termLimit& l : limits)
    {
        l.deltaT *= share;
    }
    const flowScales& f = s.flow;
    if (f.c > 0)
    {
        limits.push_back
        ({
            "maxCo", time_.maxCo()*f.h/(f.c + m.maxSpeed)
        });
        limits.push_back
        ({
            "maxDi", f.nu > 0 && !schemes_.superSteps
          ? controls_.maxDi*f.h*f.h/f.nu : infinite
        });
    }
    return shortest(limits);
}


//- A search is dear: limits are searched for speeds of sound 2% apart. Between
//  them they fall with the square, as where viscosity alone damps.
void stepControl::followSound(double c)
{
    constexpr double apart = 1.02;
    flowScales flow = scales_.flow;
    flow.c *= std::pow
    (
        apart, std::floor(std::log(c/flow.c)/std::log(apart) + 1e-9)
    );
    if (searchedC_ != flow.c)
    {
        searchedC_ = flow.c;
        searchedLimit_ = acousticLimit(schemes_, flow);
        viscous_.deltaT = viscousLimit(schemes_, flow);
    }
    const double ratio = searchedC_/c;
    acoustic_.deltaT = searchedLimit_*ratio*ratio;
}


void stepControl::follow(const flowMonitor& m)
{
    if (scales_.flow.c > 0)
    {
        followSound(soundSpeed(m));
    }
    const termLimit next = wanted(m);
    if (next.deltaT == infinite)
    {
        return;
    }
    limiting_ = next.term;
    time_.adjustDeltaT(time_.maxCo()*time_.deltaT()/next.deltaT);
}


std::string stepControl::tellShortest(double speed) const
{
    flowMonitor m;
    m.maxRelativeSpeed = speed;
    const termLimit least = shortest(termLimits(schemes_, scalesOf(m)));
    return fmt::format
    (
        "deltaT {:.6g} s is {} the shortest limit of an even lattice, the {} "
        "one, {:.6g} s.", time_.deltaT(),
        time_.deltaT() > least.deltaT ? "beyond" : "within",
        least.term, least.deltaT
    );
}


//- controlDict was changed while the case runs
void stepControl::warnOfChange(const flowMonitor& m)
{
    checked_ = time_.deltaT();
    warnBeyond(scalesOf(m));
}

} // namespace gpuFsi
