// The limits of sound and viscosity against what the solver does: noise in a
// small periodic box grows beyond the limit and does not below.
//
// Measured by bisection, 2-D, 12 x 12 particles, noise of 1e-8, 4000 steps,
// beside the limit (the first three columns in units of h/c, the last h^2/nu):
// see the table in `schemes`.

#include "common/fluids.H"
#include "common/lattice.H"
#include "limits/stepLimits.H"

#include <gtest/gtest.h>

using namespace gpuFsi;

namespace
{

using timeScheme = particleSchemes::timeScheme;

struct scene
{
    const char* name;
    bool moment;
    int exponent;
    double a;           // laplacianFactor; 0: linear faces
    timeScheme time;
    double beta;
    double c;           // m/s
    double nu;          // m^2/s; h is 1 m
};

particleSchemes schemesOf(const scene& s, const domain& d)
{
    particleSchemes p = defaultSchemes(d);
    p.areaWeights = s.moment
      ? particleSchemes::weight::moment : particleSchemes::weight::radial;
    p.weightExponent = s.exponent;
    p.faces = s.a > 0
      ? particleSchemes::face::hermite : particleSchemes::face::linear;
    p.laplacianFactor = s.a > 0 ? s.a : 1;
    p.time = s.time;
    p.dissipation = s.beta;
    return p;
}

constexpr double noise = 1e-8, loud = 1e-4;

hostState noisyState(const domain& d, double c, double displace)
{
    hostState s = latticeState(d, 0, 1, displace);
    for (std::size_t i = 0; i < s.fluid.size(); ++i)
    {
        s.fluid.deltaRho[i] = noise*hashed(5*i + 1000003);
        s.fluid.U[i] =
        {
            c*noise*hashed(5*i + 1000004), c*noise*hashed(5*i + 1000005), 0
        };
    }
    return s;
}

//- Greatest speed after so many steps; stops where it is great
double speedAfter(fluidSolver& solver, double dt, int steps)
{
    double speed = 0;
    for (int k = 0; k < steps && speed < loud; ++k)
    {
        solver.step(k*dt, dt);
        speed = k % 100 == 99 ? solver.monitor().maxSpeed : speed;
    }
    return speed;
}

//- Does the noise grow e-fold in 1000 steps, or faster?
bool grows(const scene& s, double dt, double displace = 0)
{
    const domain d = periodicBox(16, 2, 16);
    const particleSchemes schemes = schemesOf(s, d);
    fluidProperties fluid = publishedFluid(s.nu);
    fluid.c = s.c > 0 ? s.c : 1e-6;
    const auto solver = fluidSolver::make
    (
        "cpu", "double", d, fluid, schemes,
        noisyState(d, s.c > 0 ? s.c : 1, displace)
    );
    constexpr int steps = 3000;
    try
    {
        const double before = speedAfter(*solver, dt, steps);
        return before > loud
         || speedAfter(*solver, dt, steps) > std::exp(growth*steps)*before;
    }
    catch (const brokenState&)
    {
        return true;
    }
}

double measured(const scene& s, double high, double displace = 0)
{
    double low = 0;
    for (int k = 0; k < 7; ++k)
    {
        const double middle = 0.5*(low + high);
        (grows(s, middle, displace) ? high : low) = middle;
    }
    return 0.5*(low + high);
}

double limitOf(const scene& s)
{
    const domain d = periodicBox(16, 2, 16);
    const flowScales scales{2, 1, s.c, s.nu};
    const particleSchemes schemes = schemesOf(s, d);
    return s.c > 0
      ? acousticLimit(schemes, scales) : viscousLimit(schemes, scales);
}

const std::vector<scene> schemes
{
    {"radial viscous", false, 1, 0, timeScheme::Euler, 0, 0, 1},
    {"radial published", false, 1, 0, timeScheme::Euler, 0, 1, 0.2},
    {"moment viscous", true, 1, 0, timeScheme::RK2, 0, 0, 1},
    {"steep viscous", true, 3, 0, timeScheme::symplecticEuler, 0, 0, 1},
    {"Hermite viscous", true, 1, 4.0/3, timeScheme::RK2, 0, 0, 1},
    {"Euler", true, 1, 0, timeScheme::Euler, 0, 1, 0.1},
    {"symplectic", true, 1, 0, timeScheme::symplecticEuler, 0, 1, 0},
    {"symplectic damped", true, 1, 0, timeScheme::symplecticEuler, 0.2, 1, 0},
    {"symplectic Hermite", true, 3, 1, timeScheme::symplecticEuler, 0.2, 1, 0},
    {"the same, viscous", true, 3, 1, timeScheme::symplecticEuler, 0.1, 1,
        0.1},
    {"RK2", true, 1, 0, timeScheme::RK2, 0, 1, 0},
    {"RK2 Hermite damped", true, 1, 1, timeScheme::RK2, 0.2, 1, 0.01},
};

} // namespace


TEST(lattice, scan)
{
    for (const scene& s : schemes)
    {
        const double limit = limitOf(s);
        std::printf("%-20s limit %.4f measured %.4f displaced %.4f\n", s.name,
            limit, measured(s, 2*limit), measured(s, 2*limit, 0.2));
    }
}
TEST(lattice, debug)
{
    for (int q : {5, 10, 8})
    for (double dt : {limitOf(schemes[q])*1.05, limitOf(schemes[q])*1.15,limitOf(schemes[q])*1.3})
    {
    const scene& s = schemes[q];
    const domain d = periodicBox(16, 2, 16);
    const particleSchemes schemes = schemesOf(s, d);
    fluidProperties fluid = publishedFluid(s.nu);
    fluid.c = 1;
    const auto solver = fluidSolver::make("cpu", "double", d, fluid, schemes, noisyState(d, 1, 0));
    std::printf("%s dt %g theory %g:", s.name, dt, logAmplification(schemes, 2, {dt, s.nu*dt}));
    double last = solver->monitor().maxSpeed;
    for (int k = 1; k <= 4000; ++k)
    {
        solver->step(k*dt, dt);
        if (k % 500 == 0) { double v = solver->monitor().maxSpeed; std::printf(" %.2g (%.5f)", v, std::log(v/last)/500); last = v; if (v>1e-3) break;}
    }
    std::printf("\n");
    }
}
