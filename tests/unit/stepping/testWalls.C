#include "common/column.H"
#include "common/fluids.H"

#include <gtest/gtest.h>

#include <cmath>

using namespace gpuFsi;

namespace
{

std::unique_ptr<wallMotion> motion(const std::string& text)
{
    return wallMotion::make(dictionary::fromString(text, "wall"));
}

} // namespace

TEST(wallMotion, derivativesFollowThePosition)
{
    const vector x{0.3, -0.2, 0.5};
    for (const char* text :
        {
            "type translation; velocity (1 2 3);",
            "type oscillation; amplitude (0.1 0 0.2); omega 3; phase 0.4;",
            "type rotation; origin (1 0 0); axis (1 1 0); omega 2;"
        })
    {
        const auto m = motion(text);
        const double t = 0.7, dt = 1e-5;
        const vector before = m->at(t - dt).position(x);
        const vector now = m->at(t).position(x);
        const vector after = m->at(t + dt).position(x);
        const vector u = m->at(t).velocityAt(x) - (0.5/dt)*(after - before);
        const vector a = m->at(t).accelerationAt(x)
          - (1/dt/dt)*(after - 2.0*now + before);
        EXPECT_LT(std::sqrt(dot(u, u)), 1e-8) << text;
        EXPECT_LT(std::sqrt(dot(a, a)), 1e-4) << text;
        const vector start = m->at(0).position(x) - x;
        EXPECT_LT(std::sqrt(dot(start, start)), 1e-15) << text;
    }
}

TEST(wallMotion, aSlidingWallStaysInItsPlace)
{
    const auto m = motion("type sliding; velocity (1 0 -2);");
    const vector x{0.3, -0.2, 0.5};
    for (double t : {0.0, 0.7})
    {
        EXPECT_EQ(m->at(t).position(x).x, x.x);
        EXPECT_EQ(m->at(t).position(x).z, x.z);
        EXPECT_EQ(m->at(t).velocityAt(x).x, 1);
        EXPECT_EQ(m->at(t).velocityAt(x).z, -2);
        EXPECT_EQ(m->at(t).accelerationAt(x).x, 0);
    }
}

TEST(wallMotion, unknownWordListsTheValidOnes)
{
    try
    {
        motion("type oscillating;");
        FAIL();
    }
    catch (const userError& e)
    {
        const std::string text = e.what();
        EXPECT_NE(text.find("oscillation"), std::string::npos);
        EXPECT_NE(text.find("rotation"), std::string::npos);
    }
    EXPECT_EQ(motion("type fixed;"), nullptr);
}

TEST(walls, followTheirMotionAndCarryItsVelocity)
{
    const domain d = columnDomain(16, 4, 1);
    fluidProperties fluid = publishedFluid(0.02);
    fluid.motions.resize(2);
    fluid.motions[0] =
        motion("type oscillation; amplitude (0.01 0 0); omega 2; phase 0;");
    const auto solver = fluidSolver::make
    (
        "cpu", "double", d, fluid, defaultSchemes(d), columnState(d)
    );
    const double dt = 0.005;
    for (int k = 0; k < 60; ++k)
    {
        solver->step(k*dt, dt);
        solver->maintain();
    }
    const double t = 60*dt;
    const hostState s = solver->download();
    for (std::size_t i = 0; i < s.walls.size(); ++i)
    {
        const bool moves = s.patch[i] == 0;
        EXPECT_NEAR(s.walls.positions[i].x,
            moves ? 0.01*std::sin(2*t) : 1, 1e-12);
        EXPECT_NEAR(s.walls.U[i].x, moves ? 0.02*std::cos(2*t) : 0, 1e-12);
    }

    // The piston has compressed the fluid beside it
    double near = 0;
    for (std::size_t i = 0; i < s.fluid.size(); ++i)
    {
        near = std::max(near, s.fluid.deltaRho[i]);
    }
    EXPECT_GT(near, 0.01);
}

TEST(walls, restUnderGravityKeepsTheHydrostaticProfile)
{
    // rho = exp(g x/c^2): wall densities by the hydrostatic gradient
    const domain d = columnDomain(32, 4, 1);
    fluidProperties fluid = publishedFluid(0.1);
    fluid.c = 10;
    fluid.g = vector{-1, 0, 0};
    fluid.motions.resize(2);
    hostState s = columnState(d);
    const auto exact = [](const vector& x)
    {
        return std::expm1(-(x.x - 0.5)/100);
    };
    for (particleSet* set : {&s.fluid, &s.walls})
    {
        for (std::size_t i = 0; i < set->size(); ++i)
        {
            set->deltaRho[i] = exact(set->positions[i]);
        }
    }
    const auto solver = fluidSolver::make
    (
        "cpu", "double", d, fluid, defaultSchemes(d), s
    );
    const double dt = 2e-4;
    for (int k = 0; k < 5000; ++k)
    {
        solver->step(k*dt, dt);
        if (solver->maintenanceDue())
        {
            solver->maintain();
        }
    }
    const hostState end = solver->download();
    double worst = 0;
    for (std::size_t i = 0; i < end.fluid.size(); ++i)
    {
        worst = std::max(worst, std::abs
        (
            end.fluid.deltaRho[i] - exact(end.fluid.positions[i])
        ));
    }
    EXPECT_LT(worst, 0.02*0.01);    // of the range of rho
}
