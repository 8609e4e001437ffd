// With h fixed, differences between runs with dt, dt/2 and dt/4 tell the order
// in time; where dt goes to 0, the schemes agree.

#include "common/column.H"
#include "common/fluids.H"
#include "common/lattice.H"

#include <gtest/gtest.h>

#include <cmath>

using namespace gpuFsi;

namespace
{

using schemes = particleSchemes;

struct scene
{
    domain space;
    fluidProperties fluid;
    hostState state;
    double endTime;
    int steps;          // of the coarsest run
};

//- Displaced particles, Tait: nothing is linear
scene stirred(int dimensions)
{
    scene s{};
    s.space = periodicBox(dimensions == 3 ? 8 : 16, dimensions, 1);
    s.state = latticeState(s.space, 0.1, 0.05, 0.1);
    for (std::size_t i = 0; i < s.state.fluid.size(); ++i)
    {
        const vector& x = s.state.fluid.positions[i];
        s.state.fluid.U[i] = {0.1*std::sin(2*M_PI*x.y), 0.05, 0};
    }
    s.fluid = publishedFluid(0.05);
    s.fluid.eos = fluidProperties::state::Tait;
    s.fluid.gamma = 7;
    s.endTime = 0.16;
    s.steps = 16;
    return s;
}

//- A wall that moves, and one that does not
scene piston()
{
    scene s{};
    s.space = columnDomain(16, 4, 1);
    s.state = columnState(s.space);
    s.fluid = publishedFluid(0.05);
    s.fluid.motions.resize(2);
    s.fluid.motions[0] = wallMotion::make(dictionary::fromString
    (
        "type oscillation; amplitude (0.002 0 0); omega 3; phase 0.4;", "wall"
    ));
    s.endTime = 0.64;
    s.steps = 32;
    return s;
}

//- The neighbours of the begin serve to the end
hostState march
(
    const scene& s,
    schemes::weight weights,
    schemes::timeScheme time,
    int refined
)
{
    schemes p = defaultSchemes(s.space);
    p.areaWeights = weights;
    p.time = time;
    const auto solver =
        fluidSolver::make("cpu", "double", s.space, s.fluid, p, s.state);
    const int n = s.steps*refined;
    const double dt = s.endTime/n;
    for (int k = 0; k < n; ++k)
    {
        solver->step(k*dt, dt);
    }
    return solver->download();
}

//- Root of the sum of squares, of all that a particle has
double distance(const scene& s, const hostState& a, const hostState& b)
{
    const vector width = s.space.hi - s.space.lo;
    double sum = 0;
    for (std::size_t i = 0; i < a.fluid.size(); ++i)
    {
        vector x = a.fluid.positions[i] - b.fluid.positions[i];
        x.x = std::remainder(x.x, width.x);
        x.y = std::remainder(x.y, width.y);
        x.z = width.z > 0 ? std::remainder(x.z, width.z) : x.z;
        const vector u = a.fluid.U[i] - b.fluid.U[i];
        const double rho = a.fluid.deltaRho[i] - b.fluid.deltaRho[i];
        sum += dot(x, x) + dot(u, u) + rho*rho;
    }
    return std::sqrt(sum);
}

double order
(
    const scene& s,
    schemes::weight weights,
    schemes::timeScheme time
)
{
    const hostState a = march(s, weights, time, 1);
    const hostState b = march(s, weights, time, 2);
    const hostState c = march(s, weights, time, 4);
    return std::log2(distance(s, a, b)/distance(s, b, c));
}

} // namespace


TEST(timeOrder, ofRadial)
{
    for (const scene& s : {stirred(2), stirred(3), piston()})
    {
        using time = schemes::timeScheme;
        EXPECT_NEAR(order(s, schemes::weight::radial, time::RK2), 2, 0.1);
        EXPECT_NEAR(order(s, schemes::weight::radial, time::Euler), 1, 0.1);
    }
}


TEST(timeOrder, ofMoment)
{
    for (const scene& s : {stirred(2), stirred(3), piston()})
    {
        using time = schemes::timeScheme;
        EXPECT_NEAR(order(s, schemes::weight::moment, time::RK2), 2, 0.1);
        EXPECT_NEAR(order(s, schemes::weight::moment, time::Euler), 1, 0.1);
    }
}


//- Euler, extrapolated to dt = 0, is where RK2 goes: radial's rates are the same
TEST(timeOrder, radialSchemesMeet)
{
    using time = schemes::timeScheme;
    for (const scene& s : {stirred(2), stirred(3), piston()})
    {
        const auto radial = schemes::weight::radial;
        const hostState coarse = march(s, radial, time::Euler, 8);
        hostState fine = march(s, radial, time::Euler, 16);
        const double apart = distance(s, fine, coarse);
        const vector width = s.space.hi - s.space.lo;
        for (std::size_t i = 0; i < fine.fluid.size(); ++i)
        {
            vector x = fine.fluid.positions[i] - coarse.fluid.positions[i];
            x.x = std::remainder(x.x, width.x);
            x.y = std::remainder(x.y, width.y);
            fine.fluid.positions[i] += x;
            fine.fluid.U[i] += fine.fluid.U[i] - coarse.fluid.U[i];
            fine.fluid.deltaRho[i] +=
                fine.fluid.deltaRho[i] - coarse.fluid.deltaRho[i];
        }
        const hostState second = march(s, radial, time::RK2, 16);
        EXPECT_LT(distance(s, fine, second), 0.02*apart);
    }
}
