//- type solidEnergy: the ledger of the solids, J (2-D: per metre of depth),
//  works since the run's start:
//      kinetic + elastic - (first) =
//          gravity + loads + drives + fluid - dissipated + residual
//  elastic includes `contact`, what penetration stores; dissipated includes
//  `contactLoss`, by friction and dashpots of contact; drives include moving
//  walls that solids touch. And, where there is fluid, its kinetic and internal
//  energy and the sum of all that the coupled system keeps. No keys of its own.

#include "base/log.H"
#include "base/sum.H"
#include "functionObjects/functionObject.H"
#include "functionObjects/internalEnergy.H"
#include "functionObjects/outputFile.H"
#include "functionObjects/solidNames.H"

#include <optional>

namespace gpuFsi
{

namespace
{

class solidEnergy
:
    public functionObject
{
public:

    solidEnergy
    (
        const std::string& name,
        const dictionary& dict,
        const runInfo& info
    )
    :
        functionObject(name, dict, info),
        where_(dict.where("type"))
    {}

    void start(const hostState& state, const runInfo&) override
    {
        solidsOf({}, where_, name(), state);
        first_ = kept(state) - works(state);
    }

    void execute(const hostState& state, const runInfo& info) override
    {
        if (!file_)
        {
            file_.emplace
            (
                info.casePath, name(), info.startTime, "solidEnergy.dat"
            );
            file_->write
            (
                "# Time\tkinetic\telastic\tdissipated\tworkOfGravity"
                "\tworkOfLoads\tworkOfDrives\tworkOfFluid\tresidual"
                "\tfluidKinetic\tfluidInternal\tcoupledTotal"
                "\tcontact\tcontactLoss\n"
            );
        }
        const solidEnergies& s = state.solid.energies;
        const double residual = kept(state) - works(state) - first_;
        const double kinetic = fluidKinetic(state);
        const double internal = fluidInternal(state, info);
        const double total = s.kinetic + s.elastic + s.dissipated
          - s.gravity - s.loads - s.driven
          + kinetic + internal;
        std::string row = fmt::format("{:.12g}", info.time);
        for (double value :
            {
                s.kinetic, s.elastic, s.dissipated, s.gravity,
                s.loads, s.driven, s.fluid, residual,
                kinetic, internal, total, s.contact, s.contactLoss
            })
        {
            row += fmt::format("\t{:.10e}", value);
        }
        file_->write(row + "\n");
        if (log())
        {
            gpuFsi::info
            (
                "{}: kinetic = {:.4e} elastic = {:.4e} residual = {:.2e}",
                name(), s.kinetic, s.elastic, residual
            );
        }
    }

private:

    //- In the solids at present
    static double kept(const hostState& state)
    {
        const solidEnergies& s = state.solid.energies;
        return s.kinetic + s.elastic;
    }

    //- Put into the solids so far
    static double works(const hostState& state)
    {
        const solidEnergies& s = state.solid.energies;
        return s.gravity + s.loads + s.driven
          + s.fluid - s.dissipated;
    }

    static double fluidKinetic(const hostState& state)
    {
        const particleSet& f = state.fluid;
        return pairwiseSum(0, f.size(), [&](std::size_t i)
        {
            return f.mass[i]*dot(f.U[i], f.U[i])/2;
        });
    }

    static double fluidInternal(const hostState& state, const runInfo& info)
    {
        const particleSet& f = state.fluid;
        const auto energy =
            internalEnergy(f.deltaRho, state.rho0, info.pressure);
        return pairwiseSum(0, f.size(), [&](std::size_t i)
        {
            return f.mass[i]*energy[i];
        });
    }

    sourceSpan where_;
    double first_ = 0;
    std::optional<outputFile> file_;
};

const functionObject::selection::add<solidEnergy> add("solidEnergy");

} // namespace

} // namespace gpuFsi
