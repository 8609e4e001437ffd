#include "common/fluids.H"
#include "common/lattice.H"

#include <gtest/gtest.h>

#include <cstring>
#include <omp.h>

using namespace gpuFsi;

namespace
{

hostState run(const char* precision, int threads, int steps, double displace)
{
    const domain d = periodicBox(14, 3, 15);
    const fluidProperties fluid = publishedFluid();
    const int before = omp_get_max_threads();
    omp_set_num_threads(threads);
    const auto solver = fluidSolver::make
    (
        "cpu", precision, d, fluid, defaultSchemes(d),
        latticeState(d, 0.1, 5, displace)
    );
    for (int k = 0; k < steps; ++k)
    {
        solver->step(0.02*k, 0.02);
        if (solver->maintenanceDue())
        {
            solver->maintain();
        }
    }
    omp_set_num_threads(before);
    return solver->download();
}

bool sameBytes(const particleSet& a, const particleSet& b)
{
    const auto same = [](const auto& u, const auto& v)
    {
        return u.size() == v.size()
          && std::memcmp(u.data(), v.data(), u.size()*sizeof(u[0])) == 0;
    };
    return same(a.positions, b.positions) && same(a.U, b.U)
      && same(a.deltaRho, b.deltaRho);
}

} // namespace

TEST(solver, sameBytesOnAnyThreadCount)
{
    for (const char* precision : {"single", "double"})
    {
        const hostState a = run(precision, 1, 40, 0.2);
        EXPECT_TRUE(sameBytes(a.fluid, run(precision, 2, 40, 0.2).fluid));
        EXPECT_TRUE(sameBytes(a.fluid, run(precision, 5, 40, 0.2).fluid));
    }
}

TEST(solver, singleFollowsDouble)
{
    const hostState a = run("single", 2, 60, 0);
    const hostState b = run("double", 2, 60, 0);
    double worst = 0;
    for (std::size_t i = 0; i < a.fluid.size(); ++i)
    {
        worst = std::max
        (
            worst, std::abs(a.fluid.deltaRho[i] - b.fluid.deltaRho[i])
        );
    }
    EXPECT_LT(worst, 1e-5*0.1);
}

TEST(solver, aUniformStateStaysAsItIs)
{
    const domain d = periodicBox(10, 3, 1);
    const fluidProperties fluid = publishedFluid();
    for (const char* precision : {"single", "double"})
    {
        const auto solver = fluidSolver::make
        (
            "cpu", precision, d, fluid, defaultSchemes(d),
            latticeState(d, 0, 1, 0.3)
        );
        const hostState before = solver->download();
        for (int k = 0; k < 50; ++k)
        {
            solver->step(0, 1e-3);
        }
        solver->maintain();
        EXPECT_TRUE(sameBytes(before.fluid, solver->download().fluid));
    }
}

TEST(solver, momentumOfALatticeIsKept)
{
    const hostState s = run("double", 2, 30, 0);
    double momentum = 0, size = 0;
    for (std::size_t i = 0; i < s.fluid.size(); ++i)
    {
        momentum += s.fluid.U[i].x;
        size += std::abs(s.fluid.U[i].x);
    }
    EXPECT_LT(std::abs(momentum), 1e-10*size);
}

TEST(solver, breakdownNamesStepAndParticle)
{
    const domain d = periodicBox(8, 3, 1);
    const fluidProperties fluid = publishedFluid();
    const auto solver = fluidSolver::make
    (
        "cpu", "double", d, fluid, defaultSchemes(d),
        latticeState(d, 0.1, 0.02)
    );
    // 50 times the viscous limit: the density turns negative within steps
    const double dt = 50*0.5*d.spacing*d.spacing;
    int steps = 0;
    try
    {
        for (; steps < 200; ++steps)
        {
            solver->step(steps*dt, dt);
            if (steps % 7 == 6)
            {
                solver->maintain();
            }
        }
        FAIL() << "no breakdown";
    }
    catch (const brokenState& e)
    {
        const std::string text = e.what();
        EXPECT_NE(text.find("fluid particle"), std::string::npos) << text;
        const int broke = int(std::lround(e.time/dt));
        EXPECT_GE(broke, steps - 6);
        EXPECT_LE(broke, steps + 1);

        // The state kept is that of the step named: one more value is broken
        const hostState s = solver->download();
        bool bad = false;
        for (std::size_t i = 0; i < s.fluid.size(); ++i)
        {
            const vector& u = s.fluid.U[i];
            bad = bad || !std::isfinite(u.x + u.y + u.z)
              || !(1 + s.fluid.deltaRho[i] > 0);
        }
        EXPECT_TRUE(bad);
    }
}

TEST(solver, aStrayParticleIsNamed)
{
    domain d = periodicBox(8, 3, 1);
    d.periodic = {false, true, true};
    const fluidProperties fluid = publishedFluid(0);
    hostState s = latticeState(d, 0, 1);
    for (vector& u : s.fluid.U)
    {
        u.x = 1;
    }
    const auto solver = fluidSolver::make
    (
        "cpu", "double", d, fluid, defaultSchemes(d), s
    );
    try
    {
        for (int k = 0; k < 100; ++k)
        {
            solver->step(0, 0.005);
            solver->maintain();
        }
        FAIL() << "nobody missed it";
    }
    catch (const userError& e)
    {
        for (const char* part : {"has left the domain", "it is at ("})
        {
            EXPECT_NE(std::string(e.what()).find(part), std::string::npos)
                << e.what();
        }
    }
}

TEST(solver, aShortPeriodIsRefused)
{
    domain d = periodicBox(8, 3, 1);
    d.hi.z = d.lo.z + 2*d.spacing;
    const fluidProperties fluid = publishedFluid();
    EXPECT_THROW
    (
        fluidSolver::make
        (
            "cpu", "double", d, fluid, defaultSchemes(d), latticeState(d, 0, 1)
        ),
        userError
    );
}
