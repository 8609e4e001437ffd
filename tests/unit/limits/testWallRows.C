// The limit of viscosity beside walls against what the solver does: noise in a
// column between walls grows beyond the limit and does not below.

#include "common/column.H"
#include "common/fluids.H"
#include "common/lattice.H"
#include "limits/stepLimits.H"
#include "limits/wallRows.H"

#include <gtest/gtest.h>

using namespace gpuFsi;

namespace
{

using timeScheme = particleSchemes::timeScheme;

//- a: laplacianFactor; 0: linear faces
particleSchemes schemesOf
(
    const domain& d,
    int exponent,
    double a,
    timeScheme time
)
{
    particleSchemes s = defaultSchemes(d);
    s.areaWeights = particleSchemes::weight::moment;
    s.weightExponent = exponent;
    s.time = time;
    if (a > 0)
    {
        s.faces = particleSchemes::face::hermite;
        s.laplacianFactor = a;
    }
    return s;
}

//- Does noise grow by more than slowGrowth a step? nu and h are 1
bool grows(const particleSchemes& schemes, const domain& d, double dt)
{
    constexpr int steps = 3000;
    fluidProperties fluid = publishedFluid(1);
    fluid.c = 1e-6;
    hostState s = columnState(d);
    for (std::size_t i = 0; i < s.fluid.size(); ++i)
    {
        s.fluid.U[i] = {1e-9*hashed(2*i), 1e-9*hashed(2*i + 1), 0};
    }
    const auto solver =
        fluidSolver::make("cpu", "double", d, fluid, schemes, s);
    EXPECT_NEAR(solver->wallGap(), 0.5, 1e-6);
    double first = 0, speed = 0;
    try
    {
        for (int k = 0; k < steps && speed < 1e-4; ++k)
        {
            solver->step(k*dt, dt);
            if (k % 100 == 99)
            {
                speed = solver->monitor().maxSpeed;
                first = k == 999 ? speed : first;
            }
        }
    }
    catch (const brokenState&)
    {
        return true;
    }
    return speed >= 1e-4 || speed > first*std::exp(slowGrowth*2000);
}

} // namespace


// Measured beside the limit, nu dt/h^2, walls half a spacing away:
//     moment            0.361 0.361
//     weightExponent 3  0.320 0.320
//     hermite, a = 4/3  0.271 0.271
TEST(wallRows, limitIsThatMeasured)
{
    const domain d = columnDomain(12, 8, 12);
    struct scene
    {
        int exponent;
        double a;
        timeScheme time;
    };
    for (const scene& s : std::vector<scene>
    {
        {1, 0, timeScheme::RK2},
        {3, 0, timeScheme::symplecticEuler},
        {1, 4.0/3, timeScheme::RK2},
        {3, 4.0/3, timeScheme::Euler},
    })
    {
        SCOPED_TRACE(std::to_string(s.exponent) + ' ' + std::to_string(s.a));
        const particleSchemes schemes =
            schemesOf(d, s.exponent, s.a, s.time);
        const double limit = viscousLimit(schemes, {2, 1, 0, 1, 0.5});
        const double free = viscousLimit(schemes, {2, 1, 0, 1});
        EXPECT_LT(limit, 0.9*free);
        EXPECT_FALSE(grows(schemes, d, 0.97*limit)) << limit;
        EXPECT_TRUE(grows(schemes, d, 1.03*limit)) << limit;
    }
}


//- As between no walls
TEST(wallRows, aWholeSpacingAwayWallsDoNothing)
{
    const domain d = columnDomain(12, 8, 12);
    for (int dimensions : {2, 3})
    {
        const particleSchemes s = schemesOf(d, 1, 0, timeScheme::Euler);
        EXPECT_NEAR(wallRowsRate(s, dimensions, 1), 4, 0.02);
    }
}
