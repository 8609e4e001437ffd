#include "exact/exactSolution.H"

#include <gtest/gtest.h>

#include <cmath>

using namespace gpuFsi;

namespace
{

//- M = 2: u_p = 1.5 c, shock at 2 c t
struct shock
{
    double c = 1.5, nu, time = 3;
    dictionary dict = dictionary::fromString
    (
        "speed 2.25; origin (0 1 0); direction (0 2 0);"
    );
    std::unique_ptr<exactSolution> solution;

    explicit shock(double viscosity)
    :
        nu(viscosity)
    {
        fluidConstants fluid;
        fluid.rho0 = 2;
        fluid.c = c;
        fluid.nu = nu;
        solution = exactSolution::make("pistonShock", dict, fluid);
    }

    //- At the distance s from where the wall began
    double rho(double s, double t) const
    {
        return 2 + solution->scalar("deltaRho", {{0, 1 + s, 0}}, t)[0];
    }

    double U(double s, double t) const
    {
        return solution->vectors("U", {{0, 1 + s, 0}}, t)[0].y;
    }
};

} // namespace


TEST(pistonShock, jumpsAsHugoniotSays)
{
    for (const double nu : {0.0, 0.01})
    {
        const shock s(nu);
        EXPECT_NEAR(s.rho(7, s.time), 8, 1e-9);
        EXPECT_NEAR(s.U(7, s.time), 2.25, 1e-9);
        EXPECT_NEAR(s.rho(11, s.time), 2, 1e-9);
        EXPECT_NEAR(s.U(11, s.time), 0, 1e-9);
    }
}


TEST(pistonShock, holdsTheMassThatTheWallSwept)
{
    const shock s(0.3);
    const double wall = 2.25*s.time;
    constexpr int n = 20000;
    const double h = (30 - wall)/n;
    double excess = 0;
    for (int i = 0; i < n; ++i)
    {
        excess += (s.rho(wall + (i + 0.5)*h, s.time) - 2)*h;
    }
    EXPECT_NEAR(excess, 2*2.25*s.time, 1e-4);
}


//- Continuity and momentum by central differences
TEST(pistonShock, solvesTheEquations)
{
    const shock s(0.3);
    constexpr double e = 1e-4;
    for (const double at : {8.0, 8.8, 9.0, 9.1, 9.5, 10.0})
    {
        const auto dt = [&](auto f)
        {
            return (f(at, s.time + e) - f(at, s.time - e))/(2*e);
        };
        const auto ds = [&](auto f)
        {
            return (f(at + e, s.time) - f(at - e, s.time))/(2*e);
        };
        const auto rho = [&](double x, double t) { return s.rho(x, t); };
        const auto U = [&](double x, double t) { return s.U(x, t); };
        const double u = U(at, s.time), r = rho(at, s.time);
        EXPECT_NEAR(dt(rho) + u*ds(rho) + r*ds(U), 0, 2e-4);
        const double curvature =
            (U(at + e, s.time) - 2*u + U(at - e, s.time))/(e*e);
        EXPECT_NEAR
        (
            r*(dt(U) + u*ds(U)) + s.c*s.c*ds(rho) - 2*s.nu*curvature, 0, 2e-3
        );
    }
}
