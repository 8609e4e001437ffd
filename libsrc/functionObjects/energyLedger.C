//- type energyLedger: where the energy of fluid and solids goes, J (2-D: per
//  metre of depth), works and losses since the run's start:
//      kinetic + internal + elastic - (first) =
//          body force + walls + drives + loads
//        + shifting + staggering - losses + residual
//  Every term is measured by itself. The residual is what the fluid's own sums
//  have for the work of all boundaries less what walls and solids have for it
//  (interfaceError), and the solids' own. Its share is of the largest change of
//  any energy or work of boundaries so far. Contact of solids: what penetration
//  stores is elastic, friction a loss, moving walls that solids touch are
//  drives. Also: the solids' surfaces' force
//  on the fluid by the fluid's faces, beside the load on the solids, N, and the
//  momentum of all, kg m/s. Needs `areaWeights moment`. No keys of its own.

#include "base/log.H"
#include "base/sum.H"
#include "functionObjects/functionObject.H"
#include "functionObjects/internalEnergy.H"
#include "functionObjects/outputFile.H"

#include <algorithm>
#include <cmath>
#include <optional>

namespace gpuFsi
{

namespace
{

//- Sum of value(i), a vector, for i < n
template<class Value>
vector vectorSum(std::size_t n, const Value& value)
{
    const auto sum = [&](double vector::*axis)
    {
        return pairwiseSum(0, n, [&](std::size_t i) { return value(i).*axis; });
    };
    return {sum(&vector::x), sum(&vector::y), sum(&vector::z)};
}


struct balance
{
    double fluidKinetic = 0;
    double fluidInternal = 0;
    solidEnergies solid;
    fluidWorks fluid;
    vector momentum{0, 0, 0};
    vector load{0, 0, 0};        // on the solids

    balance() = default;

    balance(const hostState& state, const runInfo& info)
    :
        solid(state.solid.energies),
        fluid(state.works)
    {
        const particleSet& f = state.fluid;
        const auto energy =
            internalEnergy(f.deltaRho, state.rho0, info.pressure);
        fluidKinetic = pairwiseSum(0, f.size(), [&](std::size_t i)
        {
            return f.mass[i]*dot(f.U[i], f.U[i])/2;
        });
        fluidInternal = pairwiseSum(0, f.size(), [&](std::size_t i)
        {
            return f.mass[i]*energy[i];
        });
        const solidSet& s = state.solid;
        momentum = vectorSum
        (
            f.size(), [&](std::size_t i) { return f.mass[i]*f.U[i]; }
        );
        momentum += vectorSum
        (
            s.mass.size(), [&](std::size_t i) { return s.mass[i]*s.U[i]; }
        );
        load = vectorSum
        (
            s.load.size(), [&](std::size_t i) { return s.load[i]; }
        );
    }

    double kept() const
    {
        return fluidKinetic + fluidInternal + solid.kinetic + solid.elastic;
    }

    double body() const { return fluid.body + solid.gravity; }

    //- All boundaries on the fluid, as walls and solids have it
    double atSurfaces() const
    {
        return fluid.walls - solid.fluid - fluid.couplingLag;
    }

    double interfaceError() const { return fluid.boundary - atSurfaces(); }

    //- Put in so far and not lost
    double accounted() const
    {
        return body() + fluid.walls + solid.driven + solid.loads
          + fluid.shifting + fluid.staggering
          - fluid.viscousLoss - fluid.momentumLoss - fluid.densityLoss
          - solid.dissipated - fluid.couplingLag;
    }

    //- Largest change of one energy, or work, since `first`
    double exchanged(const balance& first) const
    {
        double most = 0;
        for (double change :
            {
                fluidKinetic - first.fluidKinetic,
                fluidInternal - first.fluidInternal,
                solid.kinetic - first.solid.kinetic,
                solid.elastic - first.solid.elastic,
                body() - first.body(),
                fluid.walls - first.fluid.walls,
                solid.fluid - first.solid.fluid,
                solid.driven - first.solid.driven,
                solid.loads - first.solid.loads
            })
        {
            most = std::max(most, std::abs(change));
        }
        return most;
    }
};


class energyLedger
:
    public functionObject
{
public:

    using functionObject::functionObject;

    bool needsLedger() const override { return true; }

    void start(const hostState& state, const runInfo& info) override
    {
        first_ = balance(state, info);
    }

    void execute(const hostState& state, const runInfo& info) override
    {
        if (!file_)
        {
            open(info);
        }
        const balance b(state, info);
        exchanged_ = std::max(exchanged_, b.exchanged(first_));
        const double residual = b.kept() - first_.kept()
          - (b.accounted() - first_.accounted());
        const double share =
            exchanged_ > 0 ? std::abs(residual)/exchanged_ : 0;
        write(b, info.time, residual, share);
        if (log())
        {
            gpuFsi::info
            (
                "{}: kept = {:.4e} lost = {:.4e} residual = {:.2e}, {:.2f}% of "
                "the largest energy exchanged", name(), b.kept(),
                b.fluid.viscousLoss + b.fluid.momentumLoss
              + b.fluid.densityLoss + b.fluid.couplingLag
              + b.solid.dissipated,
                residual, 100*share
            );
        }
    }

private:

    void write(const balance& b, double time, double residual, double share)
    {
        const fluidWorks& f = b.fluid;
        std::string row = fmt::format("{:.12g}", time);
        for (double value :
            {
                b.fluidKinetic, b.fluidInternal, b.solid.kinetic,
                b.solid.elastic, f.viscousLoss, f.momentumLoss, f.densityLoss,
                b.solid.dissipated, f.couplingLag, f.shifting, f.staggering, b.body(),
                f.walls, b.solid.driven, b.solid.loads,
                residual, exchanged_, share,
                f.boundary, b.atSurfaces(), b.interfaceError(),
                f.faceForce.x, f.faceForce.y, f.faceForce.z,
                b.load.x, b.load.y, b.load.z,
                b.momentum.x, b.momentum.y, b.momentum.z
            })
        {
            row += fmt::format("\t{:.10e}", value);
        }
        file_->write(row + "\n");
    }

    void open(const runInfo& info)
    {
        file_.emplace
        (
            info.casePath, name(), info.startTime, "energyLedger.dat"
        );
        file_->write
        (
            "# Time\tfluidKinetic\tfluidInternal\tsolidKinetic\tsolidElastic"
            "\tviscousLoss\tmomentumLoss\tdensityLoss\tsolidLoss"
            "\tcouplingLag\tshifting\tstaggering\tworkOfBodyForce\tworkOfWalls"
            "\tworkOfDrives\tworkOfLoads"
            "\tresidual\texchanged\tshare"
            "\tboundariesByFluid\tboundariesBySurfaces\tinterfaceError"
            "\tfaceForce_x\tfaceForce_y\tfaceForce_z"
            "\tload_x\tload_y\tload_z"
            "\tmomentum_x\tmomentum_y\tmomentum_z\n"
        );
    }

    balance first_;
    double exchanged_ = 0;
    std::optional<outputFile> file_;
};

const functionObject::selection::add<energyLedger> add("energyLedger");

} // namespace

} // namespace gpuFsi
