//- Steady shock in an isothermal, viscous fluid ahead of a wall that has moved
//  at the speed u_p into it since t = 0. With the Mach number M = w1/c:
//      rho2/rho1 = M^2,  u_p = c (M - 1/M),  w1 w2 = c^2
//  w is the speed relative to the shock, w1 ahead, w2 behind, rho w constant.
//  The momentum of the steady wave, mu w' = rho1 w1 (w1 - w)(w - w2)/w with w'
//  along s, integrates to its profile
//      s = nu/w1 (w2 ln(w - w2) - w1 ln(w1 - w))/(w1 - w2) + const
//  (the isothermal case of R. Becker, Stosswelle und Detonation, Z. Phys. 8
//  (1922)). Its place is that at which a jump would hold the same mass: as the
//  wall has swept rho1 u_p t, it is at w1 t from where the wall began, whatever
//  the start was like. Valid once the shock is several widths off the wall.
//  Keys: speed (u_p, m/s), origin ((0 0 0)), direction ((1 0 0)), rho0, c, nu.

#include "exact/column.H"

#include <cmath>
#include <limits>

namespace gpuFsi
{

namespace
{

//- Root of a function that grows through zero between lo and hi
template<class Function>
double root(double lo, double hi, const Function& f)
{
    for (int i = 0; i < 200; ++i)
    {
        const double mid = 0.5*(lo + hi);
        (f(mid) < 0 ? lo : hi) = mid;
    }
    return 0.5*(lo + hi);
}


class pistonShock
:
    public exactSolution
{
public:

    pistonShock(const dictionary& dict, const fluidConstants& fluid)
    :
        place_(dict, fluid, true),
        speed_
        (
            dict.getNumber
            (
                "speed",
                std::numeric_limits<double>::min(),
                std::numeric_limits<double>::max()
            )
        )
    {
        const double c = place_.c;
        const double half = speed_/(2*c);
        w1_ = c*(half + std::sqrt(half*half + 1));
        w2_ = c*c/w1_;
        // Excess of mass ahead of the mark = lack of it behind
        const double mark = root(-700, 700, [&](double z)
        {
            return std::log(1 + std::exp(-z))/w1_
             < std::log(1 + std::exp(z))/w2_ ? 1 : -1;
        });
        shift_ = place(mark);
    }

    //- deltaRho
    std::vector<double> scalar
    (
        const std::string&,
        const std::vector<vector>& points,
        double t
    ) const override
    {
        std::vector<double> values;
        for (const vector& p : points)
        {
            const double w = relative(place_.along(p) - w1_*t);
            values.push_back(place_.rho0*(w1_ - w)/w);
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
        std::vector<vector> values;
        for (const vector& p : points)
        {
            const double w = relative(place_.along(p) - w1_*t);
            values.push_back((w1_ - w)*place_.direction);
        }
        return values;
    }

private:

    //- Along s, in lengths nu/w1, where (w - w2)/(w1 - w) = exp(z)
    double place(double z) const
    {
        // ln of (w - w2) and (w1 - w), over w1 - w2
        const double behind = -std::log1p(std::exp(-z));
        const double ahead = -std::log1p(std::exp(z));
        return (w2_*behind - w1_*ahead)/(w1_ - w2_);
    }

    //- w at the distance s from the shock
    double relative(double s) const
    {
        if (place_.nu == 0)
        {
            return s > 0 ? w1_ : s < 0 ? w2_ : std::sqrt(w1_*w2_);
        }
        const double wanted = s*w1_/place_.nu + shift_;
        const double z = root(-700, 700, [&](double at)
        {
            return place(at) - wanted;
        });
        return w2_ + (w1_ - w2_)/(1 + std::exp(-z));
    }

    column place_;
    double speed_, w1_, w2_, shift_;
};

const exactSolution::selection::add<pistonShock> add("pistonShock");

} // namespace

} // namespace gpuFsi
