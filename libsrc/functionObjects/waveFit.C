//- type waveFit: frequency and decay of a standing wave. The amplitude of a
//  field's shape,
//      a(t) = sum V s q/sum V s^2 over the fluid,  V = m/rho,
//  is fitted, over all times so far, by
//      exp(-decay t) (A cos(omega t) + B sin(omega t)).
//  Keys: field, shape "expression", omega and decay (expected: the fit starts
//  from these). Annotated: etc/caseDicts/annotated/functions.

#include "base/log.H"
#include "base/sum.H"
#include "dictionary/expression.H"
#include "functionObjects/dampedFit.H"
#include "functionObjects/fields.H"
#include "functionObjects/functionObject.H"
#include "functionObjects/outputFile.H"

#include <fmt/format.h>

#include <limits>
#include <optional>

namespace gpuFsi
{

namespace
{

class waveFit
:
    public functionObject
{
public:

    waveFit
    (
        const std::string& name,
        const dictionary& dict,
        const runInfo& info
    )
    :
        functionObject(name, dict, info),
        field_(fields::readName(dict, "field")),
        shape_(dict.get<std::string>("shape"), dict.where("shape")),
        fit_
        (
            dict.getNumber
            (
                "omega",
                std::numeric_limits<double>::min(),
                std::numeric_limits<double>::max()
            ),
            dict.getOrDefault<double>("decay", 0)
        )
    {
        if (fields::nComponents(field_) != 1)
        {
            throw userError
            (
                "waveFit needs a field of numbers, not " + field_,
                dict.where("field"),
                "Take deltaRho, rho or p."
            );
        }
    }

    void execute(const hostState& state, const runInfo& info) override
    {
        const double amplitude = project(state, info);
        fit_.add(info.time, amplitude);
        if (!file_)
        {
            file_.emplace
            (
                info.casePath, name(), info.startTime, "waveFit.dat"
            );
            file_->write("# Time\tamplitude\tomega\tdecay\tresidual\n");
        }
        file_->write
        (
            fmt::format
            (
                "{:.12g}\t{:.8e}\t{:.8e}\t{:.8e}\t{:.3e}\n",
                info.time, amplitude, fit_.omega(), fit_.decay(),
                fit_.residual()
            )
        );
        if (log())
        {
            gpuFsi::info
            (
                "{}: amplitude = {:.4e} omega = {:.6g} decay = {:.4g}",
                name(), amplitude, fit_.omega(), fit_.decay()
            );
        }
    }

private:

    double project(const hostState& state, const runInfo& info) const
    {
        const particleSet& fluid = state.fluid;
        const auto value = fields::values(field_, fluid, state, info);
        const double rest = fields::restValue(field_, info);
        const auto shape = shape_.at(fluid.positions, 0);
        const auto weight = [&](std::size_t i)
        {
            return shape[i]*fluid.mass[i]/(state.rho0 + fluid.deltaRho[i]);
        };
        return pairwiseSum(0, fluid.size(), [&](std::size_t i)
        {
            return weight(i)*(value[i] - rest);
        })/pairwiseSum(0, fluid.size(), [&](std::size_t i)
        {
            return weight(i)*shape[i];
        });
    }

    std::string field_;
    expression shape_;
    dampedFit fit_;
    std::optional<outputFile> file_;
};

const functionObject::selection::add<waveFit> add("waveFit");

} // namespace

} // namespace gpuFsi
