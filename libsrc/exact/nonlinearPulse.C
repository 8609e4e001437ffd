//- exact nonlinearPulse: the pulse of acousticPulse (same keys), but of the
//  full isothermal equations, solved along the radius. To be compared with where
//  errors come down to the linear solution's own (at the published amplitude of
//  0.01: 3e-4 of the pulse).

#include "exact/exactSolution.H"
#include "exact/radialFlow.H"

#include <cmath>
#include <limits>

namespace gpuFsi
{

namespace
{

constexpr double huge = std::numeric_limits<double>::max();
constexpr double tiny = std::numeric_limits<double>::min();

class nonlinearPulse
:
    public exactSolution
{
public:

    nonlinearPulse(const dictionary& dict, const fluidConstants& fluid)
    :
        rho0_(dict.getNumberOrDefault("rho0", fluid.rho0, tiny, huge)),
        centre_(dict.getOrDefault<vector>("centre", {0, 0, 0}))
    {
        what_.dimensions = fluid.dimensions;
        what_.c = dict.getNumberOrDefault("c", fluid.c, tiny, huge);
        what_.nu = dict.getNumberOrDefault("nu", fluid.nu, 0, huge);
        what_.amplitude = dict.getOrDefault<double>("amplitude", 0.01)/rho0_;
        what_.width = dict.getNumberOrDefault("width", 5, tiny, huge);
        if (!(what_.amplitude > -1))
        {
            throw userError
            (
                "amplitude would make the density negative",
                dict.where("amplitude"), "Give one above -rho0."
            );
        }
    }

    std::vector<double> scalar
    (
        const std::string&,
        const std::vector<vector>& points,
        double t
    ) const override
    {
        const radialFlow flow(what_, t);
        std::vector<double> values(points.size());
        #pragma omp parallel for schedule(static)
        for (std::size_t i = 0; i < points.size(); ++i)
        {
            values[i] = rho0_*flow.density(distance(points[i]));
        }
        return values;
    }

    std::vector<vector> vectors
    (
        const std::string&,
        const std::vector<vector>& points,
        double t
    ) const override
    {
        const radialFlow flow(what_, t);
        std::vector<vector> values(points.size());
        #pragma omp parallel for schedule(static)
        for (std::size_t i = 0; i < points.size(); ++i)
        {
            const double r = distance(points[i]);
            const double factor = r > 0 ? flow.speed(r)/r : 0;
            values[i] = factor*fromCentre(points[i]);
        }
        return values;
    }

private:

    vector fromCentre(const vector& p) const
    {
        vector d = p - centre_;
        d.z = what_.dimensions == 2 ? 0 : d.z;
        return d;
    }

    double distance(const vector& p) const
    {
        const vector d = fromCentre(p);
        return std::sqrt(dot(d, d));
    }

    double rho0_;
    vector centre_;
    radialFlow::constants what_;
};

const exactSolution::selection::add<nonlinearPulse> add("nonlinearPulse");

} // namespace

} // namespace gpuFsi
