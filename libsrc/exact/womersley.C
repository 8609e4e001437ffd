//- Fluid between two plates at rest, driven along them from t = 0 by the body
//  force g cos(omega t + phase): the steady swing (Womersley 1955, between
//  plates) and the Fourier series of the start-up (incompressible).
//  Keys: those of column, g (m/s^2; only its part along the plates drives),
//  omega (rad/s), phase (rad, default 0).

#include "exact/column.H"
#include "exact/fourierSums.H"
#include "exact/velocitySolution.H"

#include <complex>
#include <limits>

namespace gpuFsi
{

namespace
{

class womersley
:
    public velocitySolution
{
public:

    womersley(const dictionary& dict, const fluidConstants& fluid)
    :
        column_(dict, fluid),
        force_(dict.get<vector>("g")),
        omega_
        (
            dict.getNumber
            (
                "omega",
                std::numeric_limits<double>::min(),
                std::numeric_limits<double>::max()
            )
        ),
        phase_(dict.getOrDefault<double>("phase", 0))
    {
        force_ = force_ - dot(force_, column_.direction)*column_.direction;
        if (!(column_.nu > 0))
        {
            throw userError
            (
                "womersley needs a viscosity",
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
        std::vector<vector> values;
        for (const vector& p : points)
        {
            const double s = column_.along(p)/column_.length;
            const double u = t > 0 ? swing(s, t) - startUp(s, t) : 0;
            values.push_back(u*force_);
        }
        return values;
    }

private:

    using complex = std::complex<double>;

    //- Of a force of 1 m/s^2; s in lengths
    double swing(double s, double t) const
    {
        const complex k =
            column_.length*std::sqrt(complex(0, omega_)/column_.nu);
        const complex still =
            (std::exp(-k*s) + std::exp(-k*(1 - s)))/(1.0 + std::exp(-k));
        const complex turn = std::exp(complex(0, omega_*t + phase_));
        return std::real(turn/complex(0, omega_)*(1.0 - still));
    }

    //- The swing's own start, which the fluid at rest does not have, dies out
    double startUp(double s, double t) const
    {
        using fourierSums::pi;
        const double rate =
            pi*pi*column_.nu/(column_.length*column_.length);
        const complex turn = std::exp(complex(0, phase_));
        double sum = 0;
        for (int n = 1; n*n*rate*t < 40; n += 2)
        {
            sum += 4/(n*pi)*std::real(turn/complex(n*n*rate, omega_))
                *std::sin(n*pi*s)*std::exp(-n*n*rate*t);
        }
        return sum;
    }

    column column_;
    vector force_;
    double omega_, phase_;
};

const exactSolution::selection::add<womersley> add("womersley");

} // namespace

} // namespace gpuFsi
