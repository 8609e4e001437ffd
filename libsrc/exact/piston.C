//- Column closed by a wall at s = 0 that oscillates and a fixed wall at its
//  far end, linear viscous acoustics from rest. Wall displacement
//  amplitude (1 - cos(omega t)), so velocity u(t) = U sin(omega t) with
//  U = amplitude omega. With k = n pi/L,
//      v = (1 - s/L) u + sum_n b_n sin(k s)
//      b_n'' + nu k^2 b_n' + c^2 k^2 b_n = -2/(n pi) u''
//      b_n(0) = 0, b_n'(0) = -2/(n pi) u'(0)
//      deltaRho = -rho0 int dv/ds dt
//  The leading powers of 1/n are summed in closed form, the rest by a series.
//  Keys: amplitude (m), omega (rad/s), and those of column.

#include "exact/column.H"
#include "exact/dampedMode.H"
#include "exact/fourierSums.H"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gpuFsi
{

namespace
{

constexpr double pi = 3.14159265358979323846;

class piston
:
    public exactSolution
{
public:

    piston(const dictionary& dict, const fluidConstants& fluid)
    :
        column_(dict, fluid),
        amplitude_(dict.get<double>("amplitude")),
        omega_
        (
            dict.getNumber
            (
                "omega",
                std::numeric_limits<double>::min(),
                std::numeric_limits<double>::max()
            )
        )
    {
        // Modes beyond the last under-damped one decay as the closed tail
        const double border =
            2*column_.c*column_.length/(pi*column_.nu + 1e-300);
        nModes_ = int(std::clamp(8*border, 400.0, 4000.0));
        checkResonance(dict);
    }

    std::vector<double> scalar
    (
        const std::string&,
        const std::vector<vector>& points,
        double t
    ) const override
    {
        // c_n of deltaRho = rho0 (A (1 - cos)/L - sum_n c_n cos(k s))
        const double factor = tailOfDensity(t);
        const double waves = column_.nu > 0
            ? 0 : speed()*omega_/(column_.c*column_.c);
        std::vector<double> series(nModes_ + 1, 0);
        for (int n = 1; n <= nModes_; ++n)
        {
            const mode m(*this, n, t);
            const double rest =
                m.integral - m.scale/(m.k*m.k)
               *(factor + waves*std::cos(column_.c*m.k*t));
            series[n] = m.k*rest;
        }
        const double L = column_.length;
        const double mean = amplitude_*(1 - std::cos(omega_*t))/L;
        const double tau = pi*column_.c*t/L;

        std::vector<double> values(points.size());
        #pragma omp parallel for schedule(static)
        for (std::size_t i = 0; i < points.size(); ++i)
        {
            const double theta = pi*column_.along(points[i])/L;
            double sum = fourierSums::cosine(series, theta);
            sum += 2*L/(pi*pi)
               *(
                    factor*fourierSums::inverseSquare(theta)
                  + waves/2
                   *(
                        fourierSums::inverseSquare(theta - tau)
                      + fourierSums::inverseSquare(theta + tau)
                    )
                );
            values[i] = column_.rho0*(mean - sum);
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
        const double factor = tailOfVelocity(t);
        const double waves = column_.nu > 0 ? 0 : -speed()*omega_/column_.c;
        std::vector<double> series(nModes_ + 1, 0);
        for (int n = 1; n <= nModes_; ++n)
        {
            const mode m(*this, n, t);
            series[n] = m.value - m.scale/m.k
               *(factor/m.k + waves*std::sin(column_.c*m.k*t));
        }
        const double L = column_.length;
        const double wall = speed()*std::sin(omega_*t);
        const double tau = pi*column_.c*t/L;

        std::vector<vector> values(points.size());
        #pragma omp parallel for schedule(static)
        for (std::size_t i = 0; i < points.size(); ++i)
        {
            const double s = column_.along(points[i]);
            const double theta = pi*s/L;
            double v = (1 - s/L)*wall + fourierSums::sine(series, theta);
            v += 2*L*L/(pi*pi*pi)*factor*fourierSums::inverseCube(theta);
            v += L/(pi*pi)*waves
               *(
                    fourierSums::inverseSquare(theta - tau)
                  - fourierSums::inverseSquare(theta + tau)
                );
            values[i] = v*column_.direction;
        }
        return values;
    }

private:

    //- b_n and its time integral
    struct mode
    {
        double k, scale, value, integral;

        mode(const piston& p, int n, double t)
        :
            k(n*pi/p.column_.length),
            scale(2/(n*pi))
        {
            const double c2 = p.column_.c*p.column_.c;
            const double omega = p.omega_;
            const dampedMode m(p.column_.c, p.column_.nu, k);
            const double a = m.w2() - omega*omega;
            const double d = 2*m.gamma()*omega;
            const double F = scale*p.speed()*omega*omega;
            const double P = F*a/(a*a + d*d);
            const double Q = -F*d/(a*a + d*d);
            const double E = -scale*p.speed()*omega - omega*P;
            const double sine = std::sin(omega*t);
            const double cosine = std::cos(omega*t);
            const double K = m.release(t);
            const double S = m.impulse(t);
            value = P*sine + Q*cosine - Q*K + E*S;
            integral = (Q*sine - P*cosine)/omega
              - Q*(S - p.column_.nu/c2*K) - E*K/m.w2();
        }
    };

    double speed() const { return amplitude_*omega_; }

    //- Of modes that are over-damped: their slow decay
    double slowDecay(double t) const
    {
        const double c = column_.c;
        return column_.nu > 0 ? std::exp(-c*c*t/column_.nu) : 0;
    }

    double bottom() const
    {
        const double c2 = column_.c*column_.c;
        const double n = column_.nu*omega_;
        return c2*c2 + n*n;
    }

    //- Limit of b_n n pi k^2/2 for large n
    double tailOfVelocity(double t) const
    {
        const double c2 = column_.c*column_.c;
        const double n = column_.nu*omega_;
        const double slow = slowDecay(t);
        double tail = speed()*omega_*omega_/bottom()
           *(
                c2*std::sin(omega_*t) + n*(slow - std::cos(omega_*t))
            );
        if (column_.nu > 0)
        {
            tail -= speed()*omega_/column_.nu*slow;
        }
        return tail;
    }

    //- The same of its time integral
    double tailOfDensity(double t) const
    {
        const double c2 = column_.c*column_.c;
        const double n = column_.nu*omega_;
        return speed()*omega_/bottom()
           *(
                c2*(slowDecay(t) - std::cos(omega_*t))
              - n*std::sin(omega_*t)
            );
    }

    void checkResonance(const dictionary& dict) const
    {
        const double n = omega_*column_.length/(pi*column_.c);
        const double nearest = std::max(1.0, std::round(n));
        if (column_.nu == 0 && std::abs(n - nearest) < 1e-8*n)
        {
            throw userError
            (
                "omega drives the column at its own frequency "
                + std::to_string(int(nearest)) + " pi c/length and nu is 0:"
                " the exact solution grows without bound",
                dict.where("omega"),
                "Change omega, or give the fluid a viscosity."
            );
        }
    }

    column column_;
    double amplitude_;
    double omega_;
    int nModes_;
};

const exactSolution::selection::add<piston> add("piston");

} // namespace

} // namespace gpuFsi
