//- Fluid between two plates at rest, driven along them by a body force from
//  t = 0: the Fourier series of the start-up (incompressible).
//  Keys: those of column, g (m/s^2; only its part along the plates drives).

#include "exact/column.H"
#include "exact/fourierSums.H"
#include "exact/velocitySolution.H"

namespace gpuFsi
{

namespace
{

class poiseuille
:
    public velocitySolution
{
public:

    poiseuille(const dictionary& dict, const fluidConstants& fluid)
    :
        column_(dict, fluid),
        force_(fluid.steadyForce(dict))
    {
        force_ = force_ - dot(force_, column_.direction)*column_.direction;
        if (!(column_.nu > 0))
        {
            throw userError
            (
                "poiseuille needs a viscosity",
                dict.where(),
                "Set mu or nu in constant/fluidProperties, or nu here."
            );
        }
    }

    std::vector<vector> vectors
    (
        const std::string&,
        const std::vector<vector>& points,
        double t
    ) const override
    {
        const double scale = column_.length*column_.length/column_.nu;
        std::vector<vector> values;
        for (const vector& p : points)
        {
            const double s = column_.along(p)/column_.length;
            values.push_back(scale*profile(s, t/scale)*force_);
        }
        return values;
    }

private:

    //- s in lengths, t in length^2/nu
    static double profile(double s, double t)
    {
        using fourierSums::pi;
        if (t <= 0)
        {
            return 0;
        }
        double sum = 0.5*s*(1 - s);
        for (int n = 1; n*n*pi*pi*t < 40; n += 2)
        {
            sum -= 4/std::pow(n*pi, 3)*std::sin(n*pi*s)
                *std::exp(-n*n*pi*pi*t);
        }
        return sum;
    }

    column column_;
    vector force_;
};

const exactSolution::selection::add<poiseuille> add("poiseuille");

} // namespace

} // namespace gpuFsi
