#include "exact/acousticPulse.H"

#include "exact/dampedMode.H"
#include "exact/gaussLegendre.H"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gpuFsi
{

namespace
{

const exactSolution::selection::add<acousticPulse> add("acousticPulse");

constexpr double huge = std::numeric_limits<double>::max();
constexpr double tiny = std::numeric_limits<double>::min();

//- The radial function of a wave number, f, and df/dr, d2f/dr2:
//  3-D sin(x)/x, 2-D J0(x), x = k r
struct radialWave
{
    double f, f1, f2;
};

radialWave waveOf(int dimensions, double k, double r)
{
    const double x = k*r;
    if (dimensions == 2)
    {
        const double j0 = ::j0(x);
        const double j1 = ::j1(x);
        const double j1ByX = x < 1e-8 ? 0.5 : j1/x;
        return {j0, -k*j1, -k*k*(j0 - j1ByX)};
    }
    if (x < 0.05)
    {
        const double s = x*x;
        return
        {
            1 - s/6*(1 - s/20*(1 - s/42)),
            -k*x/3*(1 - s/10*(1 - s/28*(1 - s/54))),
            -k*k/3*(1 - 3*s/10*(1 - 5*s/84*(1 - 7*s/270)))
        };
    }
    const double f = std::sin(x)/x;
    const double g = (std::cos(x) - f)/x;
    return {f, k*g, k*k*(-f - 2*g/x)};
}

} // namespace


acousticPulse::acousticPulse
(
    const dictionary& dict,
    const fluidConstants& fluid
)
:
    amplitude_(dict.getOrDefault<double>("amplitude", 0.01)),
    width_(dict.getNumberOrDefault("width", 5, tiny, huge)),
    rho0_(dict.getNumberOrDefault("rho0", fluid.rho0, tiny, huge)),
    c_(dict.getNumberOrDefault("c", fluid.c, tiny, huge)),
    nu_(dict.getNumberOrDefault("nu", fluid.nu, 0, huge)),
    centre_(dict.getOrDefault<vector>("centre", {0, 0, 0})),
    dimensions_(fluid.dimensions)
{}


double acousticPulse::distance(const vector& p) const
{
    vector d = p - centre_;
    if (dimensions_ == 2)
    {
        d.z = 0;
    }
    return std::sqrt(dot(d, d));
}


std::vector<acousticPulse::sample> acousticPulse::quadrature
(
    radial what,
    const std::vector<double>& radii,
    double t
) const
{
    const double pi = std::acos(-1.0);

    // exp(-width k^2/4) is below 1e-18 beyond kMax; a panel of Gauss points
    // spans half a wave of the fastest phase k (r + c t)
    const double kMax = std::sqrt(4*42/width_);
    const double reach = radii.empty()
        ? 0 : *std::max_element(radii.begin(), radii.end());
    const double phase = kMax*(reach + c_*t + std::sqrt(width_ + 4*nu_*t));
    const auto nodes = gaussLegendre(0, kMax, 4 + int(phase/pi));

    // Weight of each wave in the sum: 4 pi k^2 or 2 pi k over (2 pi)^D, the
    // transform of the pulse, and the mode's own time
    struct wave
    {
        double k, amplitude;
    };
    std::vector<wave> waves;
    for (const auto& node : nodes)
    {
        const double k = node.x;
        const dampedMode mode(c_, nu_, k);
        double a = node.weight*amplitude_*std::exp(-width_*k*k/4);
        a *= dimensions_ == 2
            ? k*width_/2
            : k*k*width_*std::sqrt(pi*width_)/(2*pi);
        // Mass: U = grad phi, phi_k = rho_k'/(rho0 k^2)
        a *= what == radial::deltaRho
            ? mode.release(t) : -c_*c_*mode.impulse(t)/rho0_;
        waves.push_back({k, a});
    }

    std::vector<sample> samples(radii.size());
    #pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < radii.size(); ++i)
    {
        sample s{0, 0};
        for (const wave& w : waves)
        {
            const radialWave f = waveOf(dimensions_, w.k, radii[i]);
            const bool density = what == radial::deltaRho;
            s.value += w.amplitude*(density ? f.f : f.f1);
            s.slope += w.amplitude*(density ? f.f1 : f.f2);
        }
        samples[i] = s;
    }
    return samples;
}


std::vector<double> acousticPulse::interpolated
(
    radial what,
    const std::vector<double>& radii,
    double t
) const
{
    if (radii.empty())
    {
        return {};
    }
    // Fourth derivative of the pulse is 12/width^2 at most: this spacing
    // keeps the interpolation error below 2e-11 of the amplitude
    const double step = std::sqrt(width_)/200;
    const double reach = *std::max_element(radii.begin(), radii.end());
    const std::size_t n = std::size_t(reach/step) + 2;
    if (n > 2*radii.size())
    {
        const auto samples = quadrature(what, radii, t);
        std::vector<double> values;
        for (const sample& s : samples)
        {
            values.push_back(s.value);
        }
        return values;
    }
    std::vector<double> grid(n);
    for (std::size_t i = 0; i < n; ++i)
    {
        grid[i] = i*step;
    }
    const auto table = quadrature(what, grid, t);

    std::vector<double> values(radii.size());
    #pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < radii.size(); ++i)
    {
        const std::size_t cell = std::size_t(radii[i]/step);
        const double s = radii[i]/step - cell;
        const sample& a = table[cell];
        const sample& b = table[cell + 1];
        values[i] =
            (1 + 2*s)*(1 - s)*(1 - s)*a.value + s*s*(3 - 2*s)*b.value
          + step*s*(1 - s)*((1 - s)*a.slope - s*b.slope);
    }
    return values;
}


std::vector<double> acousticPulse::scalar
(
    const std::string&,
    const std::vector<vector>& points,
    double t
) const
{
    std::vector<double> radii;
    for (const vector& p : points)
    {
        radii.push_back(distance(p));
    }
    return interpolated(radial::deltaRho, radii, t);
}


std::vector<vector> acousticPulse::vectors
(
    const std::string&,
    const std::vector<vector>& points,
    double t
) const
{
    std::vector<double> radii;
    for (const vector& p : points)
    {
        radii.push_back(distance(p));
    }
    const auto speed = interpolated(radial::velocity, radii, t);
    std::vector<vector> values(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        const double factor = radii[i] > 0 ? speed[i]/radii[i] : 0;
        values[i] = factor*(points[i] - centre_);
        if (dimensions_ == 2)
        {
            values[i].z = 0;
        }
    }
    return values;
}

} // namespace gpuFsi
