//- Two-dimensional Taylor-Green vortex, incompressible and periodic:
//      U = speed exp(-2 nu k^2 t) (sin kx cos ky, -cos kx sin ky, 0)
//      deltaRho = rho0 speed^2/(4 c^2) exp(-4 nu k^2 t) (cos 2kx + cos 2ky)
//  with k = 2 pi/length and x, y measured from origin. deltaRho is that of the
//  incompressible pressure.
//  Keys: length (m, 1), speed (m/s, 1), origin, rho0, c, nu.

#include "exact/periodicFlow.H"

#include <cmath>

namespace gpuFsi
{

namespace
{

class taylorGreen
:
    public exactSolution
{
public:

    taylorGreen(const dictionary& dict, const fluidConstants& fluid)
    :
        flow_(dict, fluid),
        speed_(dict.getOrDefault<double>("speed", 1))
    {}

    std::vector<double> scalar
    (
        const std::string&,
        const std::vector<vector>& points,
        double t
    ) const override
    {
        const double decay = std::exp(-4*flow_.rate()*t);
        const double size =
            flow_.rho0*speed_*speed_*decay/(4*flow_.c*flow_.c);
        std::vector<double> values;
        for (const vector& p : points)
        {
            const vector a = flow_.phase(p);
            values.push_back(size*(std::cos(2*a.x) + std::cos(2*a.y)));
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
        const double now = speed_*std::exp(-2*flow_.rate()*t);
        std::vector<vector> values;
        for (const vector& p : points)
        {
            const vector a = flow_.phase(p);
            values.push_back
            ({
                now*std::sin(a.x)*std::cos(a.y),
                -now*std::cos(a.x)*std::sin(a.y),
                0
            });
        }
        return values;
    }

private:

    periodicFlow flow_;
    double speed_;
};

const exactSolution::selection::add<taylorGreen> add("taylorGreen");

} // namespace

} // namespace gpuFsi
