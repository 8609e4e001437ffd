// Nearly incompressible vortices: is the pressure free of odd-even noise where
// sound is 10 to 1000 times as fast as the flow?

#include "common/fluids.H"
#include "common/lattice.H"
#include "limits/stepLimits.H"

#include <gtest/gtest.h>

#include <cmath>

using namespace gpuFsi;

namespace
{

constexpr double nu = 0.01, wave = 2*M_PI;
constexpr int side = 32;

domain box()
{
    domain d = periodicBox(side, 2, 1);
    d.lo = {0, 0, 0};
    d.hi = {1, 1, 0};
    return d;
}

//- As the tutorial taylorGreen2D, with less shifting and more dissipation.
//  displacement: after which neighbours are renewed, h
particleSchemes schemesOf(const domain& d, double displacement)
{
    particleSchemes s = defaultSchemes(d);
    s.areaWeights = particleSchemes::weight::moment;
    s.weightExponent = 3;
    s.faces = particleSchemes::face::hermite;
    s.time = particleSchemes::timeScheme::symplecticEuler;
    s.dissipation = 0.2;
    s.displacement = displacement;
    s.shifting = 0.5;
    s.shiftingCap = 20;
    return s;
}

double pressureOf(const vector& x, double t)
{
    return 0.25*std::exp(-4*nu*wave*wave*t)
       *(std::cos(2*wave*x.x) + std::cos(2*wave*x.y));
}

hostState vortices(const domain& d, double c)
{
    hostState s = latticeState(d, 0, 1);
    for (std::size_t i = 0; i < s.fluid.size(); ++i)
    {
        const vector& x = s.fluid.positions[i];
        s.fluid.deltaRho[i] = pressureOf(x, 0)/(c*c);
        s.fluid.U[i] =
        {
            std::sin(wave*x.x)*std::cos(wave*x.y),
            -std::cos(wave*x.x)*std::sin(wave*x.y), 0
        };
    }
    return s;
}

vector nearest(vector d)
{
    d.x -= std::round(d.x);
    d.y -= std::round(d.y);
    return d;
}

//- What a plane and its curvature, fitted to the neighbours within 2.3 h,
//  leave of a particle's own value: all of an odd-even wave, h^4 of a smooth
//  field. Pivoted elimination.
double leftOver(const hostState& s, std::size_t i, double h)
{
    double a[6][7] = {};
    for (std::size_t j = 0; j < s.fluid.size(); ++j)
    {
        const vector e =
            (1/h)*nearest(s.fluid.positions[j] - s.fluid.positions[i]);
        const double u = std::sqrt(dot(e, e));
        if (j == i || u > 2.3)
        {
            continue;
        }
        const double w = (1 - u/2.5)*(1 - u/2.5);
        const double f[6] = {1, e.x, e.y, e.x*e.x, e.x*e.y, e.y*e.y};
        for (int r = 0; r < 6; ++r)
        {
            for (int k = 0; k < 6; ++k)
            {
                a[r][k] += w*f[r]*f[k];
            }
            a[r][6] += w*f[r]*s.fluid.deltaRho[j];
        }
    }
    for (int k = 0; k < 6; ++k)
    {
        for (int r = 0; r < 6; ++r)
        {
            const double m = r == k ? 0 : a[r][k]/a[k][k];
            for (int l = k; l < 7 && r != k; ++l)
            {
                a[r][l] -= m*a[k][l];
            }
        }
    }
    return s.fluid.deltaRho[i] - a[0][6]/a[0][0];
}

struct figures
{
    double noise;       // rms of what is left over, of the exact pressure's rms
    double smooth;      // the same of the exact pressure there
    double pressure;    // relative L2 error
    double velocity;
};

figures measure(hostState s, double c, double t)
{
    const auto rms = [&](const auto& value)
    {
        double sum = 0;
        for (std::size_t i = 0; i < s.fluid.size(); ++i)
        {
            const double v = value(i);
            sum += v*v;
        }
        return std::sqrt(sum/double(s.fluid.size()));
    };
    const double h = 1.0/side, decay = std::exp(-2*nu*wave*wave*t);
    const auto exact = [&](std::size_t i)
    {
        return pressureOf(s.fluid.positions[i], t)/(c*c);
    };
    const double size = rms(exact);
    double mean = 0;
    for (std::size_t i = 0; i < s.fluid.size(); ++i)
    {
        mean += (s.fluid.deltaRho[i] - exact(i))/double(s.fluid.size());
    }
    figures f;
    f.noise = rms([&](std::size_t i) { return leftOver(s, i, h); })/size;
    f.pressure = rms([&](std::size_t i)
    {
        return s.fluid.deltaRho[i] - exact(i) - mean;
    })/size;
    f.velocity = rms([&](std::size_t i)
    {
        const vector& x = s.fluid.positions[i];
        const vector e = s.fluid.U[i] - decay*vector
        {
            std::sin(wave*x.x)*std::cos(wave*x.y),
            -std::cos(wave*x.x)*std::sin(wave*x.y), 0
        };
        return std::sqrt(dot(e, e));
    })/(decay*std::sqrt(0.5));
    for (std::size_t i = 0; i < s.fluid.size(); ++i)
    {
        s.fluid.deltaRho[i] = exact(i);
    }
    f.smooth = rms([&](std::size_t i) { return leftOver(s, i, h); })/size;
    return f;
}

figures run(double c, double displacement)
{
    constexpr double t = 0.1;
    const domain d = box();
    const particleSchemes schemes = schemesOf(d, displacement);
    fluidProperties fluid = publishedFluid(nu);
    fluid.c = c;
    const auto solver = fluidSolver::make
    (
        "cpu", "double", d, fluid, schemes, vortices(d, c)
    );
    const double limit = acousticLimit
    (
        schemes, {2, d.spacing, c, nu}
    );
    const int steps = int(std::ceil(t/(0.5*limit)));
    for (int k = 0; k < steps; ++k)
    {
        solver->step(k*t/steps, t/steps);
        if (solver->maintenanceDue())
        {
            solver->maintain();
        }
    }
    return measure(solver->download(), c, t);
}

} // namespace


//- An odd-even wave is seen whole
TEST(pressureNoise, measureSeesIt)
{
    const domain d = box();
    hostState s = vortices(d, 10);
    for (std::size_t i = 0; i < s.fluid.size(); ++i)
    {
        s.fluid.deltaRho[i] += (i + i/side) % 2 ? 1e-4 : -1e-4;
    }
    const figures f = measure(s, 10, 0);
    const double size = 0.25/100;
    EXPECT_GT(f.noise*size, 0.8e-4);
    EXPECT_LT(f.noise*size, 3e-4);
    EXPECT_LT(f.smooth, 0.01);
}

// Left over of the pressure at t = 0.1, 32^2 (of the exact one 0.0019), U's
// relative L2 error beside it, c/U = 10, 100, 1000:
//     neighbours kept      0.0018 0.0022 0.0069    0.0017 0.015 0.15
//     renewed every 0.1 h  0.038  0.19   1.8       0.0016 0.015 0.14
// What makes noise are neighbours that change: the new weights see the flow
// diverge by some 1e-3 U/h, which sound has to mend, rho c u of pressure.
// Between renewals there is no odd-even wave, at any speed of sound. U's error
// is that of the dissipation, which grows with c.

TEST(pressureNoise, noneWhereNeighboursStay)
{
    for (double c : {10.0, 100.0, 1000.0})
    {
        const figures f = run(c, 10);
        EXPECT_LT(f.noise, c > 500 ? 0.008 : 0.0025) << c;
        EXPECT_LT(f.pressure, c > 500 ? 0.3 : 0.03) << c;
    }
}


TEST(pressureNoise, growsWithSoundWhereTheyChange)
{
    const figures slow = run(10, 0.1);
        EXPECT_LT(slow.noise, 0.06);
    EXPECT_LT(slow.velocity, 0.003);
    const figures fast = run(100, 0.1);
    EXPECT_LT(fast.noise, 0.5);
    EXPECT_LT(fast.velocity, 0.02);
}
