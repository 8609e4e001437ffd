//- Isothermal fluid at rest: rho = rho0 exp(g.(x - origin)/c^2)
//  Keys: origin (where rho is rho0), g, rho0, c.

#include "exact/exactSolution.H"

#include <cmath>
#include <limits>

namespace gpuFsi
{

namespace
{

constexpr double huge = std::numeric_limits<double>::max();
constexpr double tiny = std::numeric_limits<double>::min();

class hydrostatic
:
    public exactSolution
{
public:

    hydrostatic(const dictionary& dict, const fluidConstants& fluid)
    :
        rho0_(dict.getNumberOrDefault("rho0", fluid.rho0, tiny, huge)),
        c_(dict.getNumberOrDefault("c", fluid.c, tiny, huge)),
        g_(fluid.steadyForce(dict)),
        origin_(dict.getOrDefault<vector>("origin", {0, 0, 0}))
    {}

    std::vector<double> scalar
    (
        const std::string&,
        const std::vector<vector>& points,
        double
    ) const override
    {
        std::vector<double> values;
        for (const vector& p : points)
        {
            const double exponent = dot(g_, p - origin_)/(c_*c_);
            values.push_back(rho0_*std::expm1(exponent));
        }
        return values;
    }

    std::vector<vector> vectors
    (
        const std::string&,
        const std::vector<vector>& points,
        double
    ) const override
    {
        return std::vector<vector>(points.size(), vector{0, 0, 0});
    }

private:

    double rho0_, c_;
    vector g_, origin_;
};

const exactSolution::selection::add<hydrostatic> add("hydrostatic");

} // namespace

} // namespace gpuFsi
