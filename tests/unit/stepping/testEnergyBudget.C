// Energy that the fluid may have, and runs that are stopped for having more.

#include "common/fluids.H"
#include "common/lattice.H"
#include "stepping/energyBudget.H"

#include <gtest/gtest.h>

#include <cstring>

using namespace gpuFsi;

namespace
{

domain box() { return periodicBox(16, 2, 16); }

particleSchemes schemesFor(const domain& d, double dissipation)
{
    particleSchemes s = defaultSchemes(d);
    s.areaWeights = particleSchemes::weight::moment;
    s.time = particleSchemes::timeScheme::RK2;
    s.dissipation = dissipation;
    return s;
}

//- Noise of a twentieth of the speed of sound
hostState noisy(const domain& d)
{
    hostState s = latticeState(d, 0, 1);
    for (std::size_t i = 0; i < s.fluid.size(); ++i)
    {
        s.fluid.U[i] = {0.05*hashed(2*i), 0.05*hashed(2*i + 1), 0};
    }
    return s;
}

//- Steps until a watched run stops; -1: never. what, and the state then
struct ending
{
    int steps = -1;
    std::string what;
    hostState state;
};

ending run
(
    double dt,
    int steps,
    double dissipation,
    const char* precision = "double"
)
{
    const domain d = box();
    fluidProperties fluid = publishedFluid(0);
    fluid.c = 1;
    const auto solver = fluidSolver::make
    (
        "cpu", precision, d, fluid, schemesFor(d, dissipation), noisy(d)
    );
    solver->watchEnergy();
    ending e;
    for (int k = 0; k < steps; ++k)
    {
        solver->step(k*dt, dt);
        try
        {
            if (solver->maintenanceDue())
            {
                solver->maintain();
            }
        }
        catch (const brokenState& broken)
        {
            e.steps = k + 1;
            e.what = broken.what();
            EXPECT_NEAR(broken.time, (k + 1)*dt, 1e-9);
            EXPECT_GT(broken.speed, 0);
            break;
        }
    }
    e.state = solver->download();
    return e;
}

double kinetic(const hostState& s)
{
    double sum = 0;
    for (const vector& u : s.fluid.U)
    {
        sum += 0.5*dot(u, u);
    }
    return sum/double(s.fluid.size());
}

} // namespace


TEST(energyBudget, whatWasGivenIsKept)
{
    energyBudget b(2, 1);
    EXPECT_TRUE(b.add({2, 2, 0}, 0, 0));
    EXPECT_TRUE(b.add({0.1, 0.4, 0}, 10, 1));
    EXPECT_TRUE(b.add({2, 2, 0}, 10, 1));
    EXPECT_DOUBLE_EQ(b.given(), 2);
    EXPECT_NEAR(b.growth(), std::pow(20, 0.1), 1e-12);
    EXPECT_FALSE(b.add({20.1, 6, 0}, 10, 1));
}


//- Nothing at the start, and round-off
TEST(energyBudget, aFluidAtRestMayHum)
{
    energyBudget b(0, 10);
    EXPECT_TRUE(b.add({0, 0, 0}, 0, 0));
    EXPECT_TRUE(b.add({0.5*0.09*0.09, 0.09, 0}, 10, 1));
    EXPECT_FALSE(b.add({0.5*0.11*0.11, 0.11, 0}, 10, 1));
}


//- Free fall under g = 3 for 5 s, looked at every second
TEST(energyBudget, forcesAndWallsGive)
{
    energyBudget b(0, 1e-6);
    for (int look = 1; look <= 5; ++look)
    {
        for (int step = 0; step < 10; ++step)
        {
            b.push(0.3);
        }
        const double u = 3*look;
        EXPECT_TRUE(b.add({0.5*u*u, u, 0}, 10, 1));
        EXPECT_GE(b.given(), 0.5*u*u);
        EXPECT_LE(b.given(), 2.5*u*u + 9*look);
    }
    energyBudget walls(0, 1e-6);
    EXPECT_TRUE(walls.add({1, 1, 4}, 10, 0.25));
    EXPECT_DOUBLE_EQ(walls.given(), 1);
    EXPECT_TRUE(walls.add({1, 1, 2}, 10, 0.25));
    EXPECT_DOUBLE_EQ(walls.given(), 2);
}


TEST(energyWatch, stopsWhileAllIsFinite)
{
    const double start = kinetic(noisy(box()));
    for (const char* precision : {"single", "double"})
    {
        const ending e = run(0.8, 3000, 0, precision);
        ASSERT_GT(e.steps, 0) << precision;
        const double now = kinetic(e.state);
        EXPECT_GT(now, 10*start);
        EXPECT_LT(now, 1000*start);
        EXPECT_NE(e.what.find("the fluid's kinetic energy is"),
            std::string::npos) << e.what;

        // The particle named is the fastest
        const std::size_t at = e.what.find("fluid particle ") + 15;
        const vector u = e.state.fluid.U[std::stoul(e.what.substr(at))];
        for (const vector& v : e.state.fluid.U)
        {
            EXPECT_LE(dot(v, v), (1 + 1e-14)*dot(u, u));
        }
    }
}


TEST(energyWatch, leavesASoundRunAlone)
{
    EXPECT_EQ(run(0.2, 2000, 0.2).steps, -1);
}
