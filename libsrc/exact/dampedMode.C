#include "exact/dampedMode.H"

#include <cmath>

namespace gpuFsi
{

double dampedMode::impulse(double t) const
{
    const double square = w2_ - gamma_*gamma_;
    const double phase2 = square*t*t;
    if (std::abs(phase2) < 1e-3)
    {
        // sin(x)/x = sinh(x)/x near the border between the branches
        return t*std::exp(-gamma_*t)
            *(1 - phase2/6*(1 - phase2/20*(1 - phase2/42)));
    }
    if (square > 0)
    {
        const double omega = std::sqrt(square);
        return std::exp(-gamma_*t)*std::sin(omega*t)/omega;
    }
    const double kappa = std::sqrt(-square);
    const double fast = gamma_ + kappa;
    const double slow = w2_/fast;
    return std::exp(-slow*t)*-std::expm1(-2*kappa*t)/(2*kappa);
}


double dampedMode::release(double t) const
{
    const double square = w2_ - gamma_*gamma_;
    const double phase2 = square*t*t;
    if (std::abs(phase2) < 1e-3)
    {
        const double cosine =
            1 - phase2/2*(1 - phase2/12*(1 - phase2/30));
        return std::exp(-gamma_*t)*cosine + gamma_*impulse(t);
    }
    if (square > 0)
    {
        const double cosine = std::cos(std::sqrt(square)*t);
        return std::exp(-gamma_*t)*cosine + gamma_*impulse(t);
    }
    const double kappa = std::sqrt(-square);
    const double fast = gamma_ + kappa;
    const double slow = w2_/fast;
    return (fast*std::exp(-slow*t) - slow*std::exp(-fast*t))/(2*kappa);
}

} // namespace gpuFsi
