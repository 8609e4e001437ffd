// The stepping with the published operators against equations (1)-(9) written
// out plainly in double precision.

#include "common/fluids.H"
#include "common/lattice.H"
#include "plainLattice.H"

#include <gtest/gtest.h>

using namespace gpuFsi;

namespace
{

double isothermal(double rho)
{
    return rho/3;
}

double tait7(double rho)
{
    return (std::pow(rho, 7) - 1)/3/7;
}

double tait14(double rho)
{
    return (std::pow(rho, 1.4) - 1)/3/1.4;
}

void compare
(
    int D,
    double (*pressure)(double),
    double gamma,
    double mu,
    const char* precision,
    double tolerance,
    bool midpoint = false
)
{
    const int n = D == 3 ? 12 : 24;
    const domain d = periodicBox(n, D, 15);
    hostState s = latticeState(d, 0.01, 5);
    for (std::size_t i = 0; i < s.fluid.size(); ++i)
    {
        const vector& x = s.fluid.positions[i];
        s.fluid.U[i] = {0.01*std::sin(2*M_PI*x.y/15), 0, 0};
    }
    plainLattice plain{n, D, 15, s.fluid.positions, s.fluid.U, {}};
    for (double delta : s.fluid.deltaRho)
    {
        plain.rho.push_back(1 + delta);
    }

    fluidProperties fluid = publishedFluid(mu);
    fluid.g = vector{0, D == 3 ? 0.003 : 0.001, 0};
    if (gamma > 0)
    {
        fluid.eos = fluidProperties::state::Tait;
        fluid.gamma = gamma;
    }
    particleSchemes schemes = defaultSchemes(d);
    schemes.time = midpoint ? particleSchemes::timeScheme::RK2
      : particleSchemes::timeScheme::Euler;
    const auto solver =
        fluidSolver::make("cpu", precision, d, fluid, schemes, s);
    const double dt = 0.05;
    for (int k = 0; k < 20; ++k)
    {
        solver->step(k*dt, dt);
        plain.step(midpoint, dt, mu, pressure, fluid.g.at(0));
    }
    solver->maintain();
    const hostState result = solver->download();
    double worst = 0;
    for (std::size_t i = 0; i < plain.rho.size(); ++i)
    {
        const vector u = result.fluid.U[i] - plain.v[i];
        worst = std::max
        ({
            worst, std::abs(1 + result.fluid.deltaRho[i] - plain.rho[i]),
            std::abs(u.x), std::abs(u.y), std::abs(u.z),
            std::abs(plain.wrapped(result.fluid.positions[i].x - plain.x[i].x)),
            std::abs(plain.wrapped(result.fluid.positions[i].y - plain.x[i].y))
        });
    }
    EXPECT_LT(worst, tolerance);
}

} // namespace

TEST(radialEuler, isTheEquationsIn3D)
{
    compare(3, isothermal, 0, 1, "double", 1e-12);
    compare(3, isothermal, 0, 0, "double", 1e-12);
    compare(3, isothermal, 0, 1, "single", 2e-7);
}

TEST(radialEuler, isTheEquationsIn2D)
{
    compare(2, isothermal, 0, 1, "double", 1e-12);
    compare(2, isothermal, 0, 1, "single", 2e-7);
}

TEST(radialEuler, TaitWithBothExponents)
{
    compare(3, tait7, 7, 1, "double", 1e-12);
    compare(2, tait14, 1.4, 0.5, "double", 1e-12);
}

TEST(radialRK2, isTheEquations)
{
    compare(3, isothermal, 0, 1, "double", 1e-12, true);
    compare(3, isothermal, 0, 0, "double", 1e-12, true);
    compare(2, isothermal, 0, 1, "double", 1e-12, true);
    compare(2, isothermal, 0, 1, "single", 2e-7, true);
    compare(3, tait7, 7, 1, "double", 1e-12, true);
    compare(2, tait14, 1.4, 0.5, "double", 1e-12, true);
}
