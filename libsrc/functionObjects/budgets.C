//- type budgets: what a closed flow must keep, by sums over the particles.
//  In 2-D all are per metre of depth. Drifts are since the first state of
//  this run. A body force that varies with time has no potential: its work
//  since then, by the trapezoidal rule over the rows, is a column more. No keys
//  of its own.

#include "base/log.H"
#include "base/sum.H"
#include "functionObjects/functionObject.H"
#include "functionObjects/internalEnergy.H"
#include "functionObjects/outputFile.H"

#include <cmath>
#include <optional>

namespace gpuFsi
{

namespace
{

struct totals
{
    double mass = 0;           // fluid, kg
    double wallMass = 0;       // the half layer that the walls own, kg
    double volume = 0;         // sum m/rho of the fluid, m^3
    double wallVolume = 0;
    vector momentum{0, 0, 0};
    double kinetic = 0;        // J
    double internal = 0;       // above rho0
    double potential = 0;      // -sum m g.x of a steady g
    double power = 0;          // of a g that varies, W
    vector centre{0, 0, 0};    // of the fluid's mass

    double energy() const { return kinetic + internal + potential; }
};


totals totalsOf(const hostState& state, const runInfo& info)
{
    const particleSet& f = state.fluid;
    const auto sum = [](std::size_t n, const auto& value)
    {
        return pairwiseSum(0, n, value);
    };
    const auto fluid = [&](const auto& value) { return sum(f.size(), value); };
    using index = std::size_t;

    totals t;
    t.mass = fluid([&](index i) { return f.mass[i]; });
    t.volume = fluid
    (
        [&](index i) { return f.mass[i]/(state.rho0 + f.deltaRho[i]); }
    );
    t.momentum =
    {
        fluid([&](index i) { return f.mass[i]*f.U[i].x; }),
        fluid([&](index i) { return f.mass[i]*f.U[i].y; }),
        fluid([&](index i) { return f.mass[i]*f.U[i].z; })
    };
    t.centre =
    {
        fluid([&](index i) { return f.mass[i]*f.positions[i].x; })/t.mass,
        fluid([&](index i) { return f.mass[i]*f.positions[i].y; })/t.mass,
        fluid([&](index i) { return f.mass[i]*f.positions[i].z; })/t.mass
    };
    t.kinetic = fluid
    (
        [&](index i) { return f.mass[i]*dot(f.U[i], f.U[i])/2; }
    );
    if (info.forceVaries)
    {
        t.power = dot(info.gravity, t.momentum);
    }
    else
    {
        t.potential = -t.mass*dot(info.gravity, t.centre);
    }

    const auto energy = internalEnergy(f.deltaRho, state.rho0, info.pressure);
    t.internal = fluid([&](index i) { return f.mass[i]*energy[i]; });

    const particleSet& w = state.walls;
    t.wallVolume = sum
    (
        w.size(),
        [&](index i) { return state.area[i]*state.h/2; }
    );
    t.wallMass = sum
    (
        w.size(),
        [&](index i)
        {
            return (state.rho0 + w.deltaRho[i])*state.area[i]*state.h/2;
        }
    );
    return t;
}


class budgets
:
    public functionObject
{
public:

    using functionObject::functionObject;

    void start(const hostState& state, const runInfo& info) override
    {
        first_ = totalsOf(state, info);
        power_ = first_.power;
        before_ = info.time;
    }

    void execute(const hostState& state, const runInfo& info) override
    {
        if (!file_)
        {
            open(info);
        }
        const totals t = totalsOf(state, info);
        work_ += (info.time - before_)*(power_ + t.power)/2;
        power_ = t.power;
        before_ = info.time;
        const double all = t.volume + t.wallVolume;
        const double massDrift = (t.mass - first_.mass)/first_.mass;
        const double volumeError = all/state.volume - 1;
        const double energyDrift = t.energy() - first_.energy() - work_;
        const vector momentumDrift = t.momentum - first_.momentum;

        std::string row = fmt::format("{:.12g}", info.time);
        for (double value :
            {
                t.mass, t.wallMass, t.volume, all, state.volume,
                t.momentum.x, t.momentum.y, t.momentum.z,
                t.kinetic, t.internal, t.potential,
                t.centre.x, t.centre.y, t.centre.z,
                massDrift, volumeError,
                momentumDrift.x, momentumDrift.y, momentumDrift.z,
                energyDrift
            })
        {
            row += fmt::format("\t{:.10e}", value);
        }
        if (info.forceVaries)
        {
            row += fmt::format("\t{:.10e}", work_);
        }
        file_->write(row + "\n");
        if (log())
        {
            gpuFsi::info
            (
                "{}: mass drift = {:.3e} volume error = {:.3e} momentum drift"
                " = ({:.3e} {:.3e} {:.3e}) energy drift = {:.3e}",
                name(), massDrift, volumeError,
                momentumDrift.x, momentumDrift.y, momentumDrift.z, energyDrift
            );
        }
    }

private:

    void open(const runInfo& info)
    {
        file_.emplace
        (
            info.casePath, name(), info.startTime, "budgets.dat"
        );
        file_->write
        (
            "# Time\tmass\twallMass\tvolume\ttotalVolume\tdomainVolume"
            "\tmomentum_x\tmomentum_y\tmomentum_z"
            "\tkineticEnergy\tinternalEnergy\tpotentialEnergy"
            "\tcentre_x\tcentre_y\tcentre_z"
            "\tmassDrift\tvolumeError"
            "\tmomentumDrift_x\tmomentumDrift_y\tmomentumDrift_z"
            "\tenergyDrift"
        );
        file_->write(info.forceVaries ? "\tworkOfForce\n" : "\n");
    }

    totals first_;
    double work_ = 0;          // of a force that varies, J
    double power_ = 0;         // at the last row, W
    double before_ = 0;        // its time, s
    std::optional<outputFile> file_;
};

const functionObject::selection::add<budgets> add("budgets");

} // namespace

} // namespace gpuFsi
