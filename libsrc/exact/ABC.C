//- Arnold-Beltrami-Childress flow, incompressible and periodic; decays as a
//  whole, for its vorticity is k U:
//      U = exp(-nu k^2 t)
//          (A sin kz + C cos ky, B sin kx + A cos kz, C sin ky + B cos kx)
//      deltaRho = rho0/(2 c^2) (A^2 + B^2 + C^2 - U^2), U^2 decaying too
//  with k = 2 pi/length and x, y, z measured from origin. deltaRho is that of
//  the incompressible pressure.
//  Keys: A, B, C (m/s, 1/sqrt(3) each), length (m, 1), origin, rho0, c, nu.

#include "exact/periodicFlow.H"

#include <cmath>

namespace gpuFsi
{

namespace
{

class ABC
:
    public exactSolution
{
public:

    ABC(const dictionary& dict, const fluidConstants& fluid)
    :
        flow_(dict, fluid),
        A_(dict.getOrDefault<double>("A", 1/std::sqrt(3.0))),
        B_(dict.getOrDefault<double>("B", 1/std::sqrt(3.0))),
        C_(dict.getOrDefault<double>("C", 1/std::sqrt(3.0)))
    {}

    std::vector<double> scalar
    (
        const std::string& field,
        const std::vector<vector>& points,
        double t
    ) const override
    {
        const double decay = std::exp(-2*flow_.rate()*t);
        const double mean = (A_*A_ + B_*B_ + C_*C_)*decay;
        const double size = flow_.rho0/(2*flow_.c*flow_.c);
        std::vector<double> values;
        for (const vector& U : vectors(field, points, t))
        {
            values.push_back(size*(mean - dot(U, U)));
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
        const double decay = std::exp(-flow_.rate()*t);
        std::vector<vector> values;
        for (const vector& p : points)
        {
            const vector a = flow_.phase(p);
            values.push_back
            (
                decay*vector
                {
                    A_*std::sin(a.z) + C_*std::cos(a.y),
                    B_*std::sin(a.x) + A_*std::cos(a.z),
                    C_*std::sin(a.y) + B_*std::cos(a.x)
                }
            );
        }
        return values;
    }

private:

    periodicFlow flow_;
    double A_, B_, C_;
};

const exactSolution::selection::add<ABC> add("ABC");

} // namespace

} // namespace gpuFsi
