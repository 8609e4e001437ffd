#include "functionObjects/dampedFit.H"

#include <cmath>
#include <limits>
#include <utility>

namespace gpuFsi
{

namespace
{

//- Normal equations of N unknowns, solved with pivoting; 0 where singular
template<int N>
struct normalEquations
{
    double m[N][N + 1]{};

    void add(const std::array<double, N>& row, double value)
    {
        for (int i = 0; i < N; ++i)
        {
            for (int j = 0; j < N; ++j)
            {
                m[i][j] += row[i]*row[j];
            }
            m[i][N] += row[i]*value;
        }
    }

    void damp(double factor)
    {
        for (int i = 0; i < N; ++i)
        {
            m[i][i] *= 1 + factor;
        }
    }

    std::array<double, N> solve()
    {
        std::array<double, N> x{};
        for (int k = 0; k < N; ++k)
        {
            int pivot = k;
            for (int i = k + 1; i < N; ++i)
            {
                pivot = std::abs(m[i][k]) > std::abs(m[pivot][k]) ? i : pivot;
            }
            std::swap(m[k], m[pivot]);
            if (m[k][k] == 0)
            {
                return {};
            }
            for (int i = k + 1; i < N; ++i)
            {
                const double factor = m[i][k]/m[k][k];
                for (int j = k; j <= N; ++j)
                {
                    m[i][j] -= factor*m[k][j];
                }
            }
        }
        for (int k = N - 1; k >= 0; --k)
        {
            x[k] = m[k][N];
            for (int j = k + 1; j < N; ++j)
            {
                x[k] -= m[k][j]*x[j];
            }
            x[k] /= m[k][k];
        }
        return x;
    }
};


struct basis
{
    double c, s;

    basis(double t, double omega, double decay)
    :
        c(std::exp(-decay*t)*std::cos(omega*t)),
        s(std::exp(-decay*t)*std::sin(omega*t))
    {}
};

} // namespace


void dampedFit::add(double t, double value)
{
    if (t_.empty())
    {
        start_ = t;
    }
    t_.push_back(t - start_);
    value_.push_back(value);
    if (longEnough())
    {
        improve();
    }
}


double dampedFit::omega() const
{
    return longEnough() ? omega_ : std::numeric_limits<double>::quiet_NaN();
}


double dampedFit::decay() const
{
    return longEnough() ? decay_ : std::numeric_limits<double>::quiet_NaN();
}


double dampedFit::residual() const
{
    double size = 0;
    for (double v : value_)
    {
        size += v*v;
    }
    return longEnough()
        ? std::sqrt(misfit_/size)
        : std::numeric_limits<double>::quiet_NaN();
}


bool dampedFit::longEnough() const
{
    return t_.size() > 5 && t_.back()*omega_ >= std::acos(-1.0);
}


double dampedFit::misfit(const parameters& p) const
{
    double sum = 0;
    for (std::size_t i = 0; i < t_.size(); ++i)
    {
        const basis b(t_[i], p[1], p[0]);
        const double rest = value_[i] - p[2]*b.c - p[3]*b.s;
        sum += rest*rest;
    }
    return sum;
}


dampedFit::parameters dampedFit::linearPart(double omega, double decay) const
{
    normalEquations<2> equations;
    for (std::size_t i = 0; i < t_.size(); ++i)
    {
        const basis b(t_[i], omega, decay);
        equations.add({b.c, b.s}, value_[i]);
    }
    const auto x = equations.solve();
    return {decay, omega, x[0], x[1]};
}


//- Levenberg-Marquardt
void dampedFit::improve()
{
    parameters p = linearPart(omega_, decay_);
    misfit_ = misfit(p);
    double damping = 1e-3;
    for (int n = 0; n < 50 && damping < 1e8; ++n)
    {
        normalEquations<4> equations;
        for (std::size_t i = 0; i < t_.size(); ++i)
        {
            const basis b(t_[i], p[1], p[0]);
            const double now = p[2]*b.c + p[3]*b.s;
            equations.add
            (
                {-t_[i]*now, t_[i]*(p[3]*b.c - p[2]*b.s), b.c, b.s},
                value_[i] - now
            );
        }
        equations.damp(damping);
        parameters next = equations.solve();
        bool converged = true;
        for (int k = 0; k < 4; ++k)
        {
            converged =
                converged && std::abs(next[k]) <= 1e-12*std::abs(p[k] + omega_);
            next[k] += p[k];
        }
        const double left = misfit(next);
        if (left < misfit_)
        {
            p = next;
            misfit_ = left;
            damping /= 10;
        }
        else
        {
            damping *= 10;
        }
        if (converged)
        {
            break;
        }
    }
    decay_ = p[0];
    omega_ = p[1];
}

} // namespace gpuFsi
