#include "exact/radialFlow.H"

#include <algorithm>
#include <cmath>

namespace gpuFsi
{

radialFlow::radialFlow(const constants& what, double t, int pointsAWidth)
:
    what_(what),
    dr_(std::sqrt(what.width)/pointsAWidth)
{
    // The wave's front, and tails that fall to exp(-36)
    const double reach =
        what.c*t + 6*std::sqrt(what.width + 4*what.nu*t);
    const std::size_t n = std::size_t(reach/dr_) + 8;
    for (std::size_t i = 0; i < n; ++i)
    {
        const double r = (i + 0.5)*dr_;
        now_.s.push_back
        (
            std::log1p(what.amplitude*std::exp(-r*r/what.width))
        );
    }
    now_.u.assign(n, 0);

    // Stable: nu (1.73/dr)^2 dt < 2.78; of waves a tenth of a point a step
    double dt = 0.1*dr_/what.c;
    if (what.nu > 0)
    {
        dt = std::min(dt, 0.4*dr_*dr_/what.nu);
    }
    const long steps = long(std::ceil(t/dt));
    for (long i = 0; i < steps; ++i)
    {
        step(t/steps);
    }
}


radialFlow::field radialFlow::derivative(const field& f, int parity) const
{
    constexpr double w[4] = {4.0/5, -1.0/5, 4.0/105, -1.0/280};
    const long n = long(f.size());
    field d(f.size());
    for (long i = 0; i < n; ++i)
    {
        double sum = 0;
        for (int k = 1; k <= 4; ++k)
        {
            sum += w[k - 1]
               *(value(f, parity, i + k) - value(f, parity, i - k));
        }
        d[i] = sum/dr_;
    }
    return d;
}


radialFlow::state radialFlow::rate(const state& q) const
{
    const std::size_t n = q.s.size();
    const field sr = derivative(q.s, 1);
    const field ur = derivative(q.u, -1);
    field divergence(n);
    for (std::size_t i = 0; i < n; ++i)
    {
        const double r = (i + 0.5)*dr_;
        divergence[i] = ur[i] + (what_.dimensions - 1)*q.u[i]/r;
    }
    // A flow without rotation: lap v = grad div v
    const field laplacian = derivative(divergence, 1);
    state rate{field(n), field(n)};
    for (std::size_t i = 0; i < n; ++i)
    {
        rate.s[i] = -q.u[i]*sr[i] - divergence[i];
        rate.u[i] = -q.u[i]*ur[i] - what_.c*what_.c*sr[i]
          + what_.nu*std::exp(-q.s[i])*laplacian[i];
    }
    return rate;
}


void radialFlow::step(double dt)
{
    const state begin = now_;
    state sum = now_;
    const std::size_t n = now_.s.size();
    constexpr double ahead[4] = {0.5, 0.5, 1, 0};
    constexpr double weight[4] = {1.0/6, 1.0/3, 1.0/3, 1.0/6};
    for (int stage = 0; stage < 4; ++stage)
    {
        const state k = rate(now_);
        for (std::size_t i = 0; i < n; ++i)
        {
            sum.s[i] += dt*weight[stage]*k.s[i];
            sum.u[i] += dt*weight[stage]*k.u[i];
            now_.s[i] = begin.s[i] + dt*ahead[stage]*k.s[i];
            now_.u[i] = begin.u[i] + dt*ahead[stage]*k.u[i];
        }
    }
    now_ = sum;
}


double radialFlow::at(const field& f, int parity, double r) const
{
    // Lagrange's polynomial through eight points, at x = r/dr - 1/2
    const double x = r/dr_ - 0.5;
    const long first = long(std::floor(x)) - 3;
    double sum = 0;
    for (int j = 0; j < 8; ++j)
    {
        double weight = 1;
        for (int k = 0; k < 8; ++k)
        {
            weight *= k == j ? 1 : (x - first - k)/(j - k);
        }
        sum += weight*value(f, parity, first + j);
    }
    return sum;
}


double radialFlow::density(double r) const
{
    return std::expm1(at(now_.s, 1, r));
}


double radialFlow::speed(double r) const
{
    return at(now_.u, -1, r);
}

} // namespace gpuFsi
