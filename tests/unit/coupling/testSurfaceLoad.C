// What fluid and solid do to each other.

#include "barColumn.H"

#include <gtest/gtest.h>

using namespace gpuFsi;

namespace
{

vector sumOf(const std::vector<vector>& values)
{
    vector sum{0, 0, 0};
    for (const vector& v : values)
    {
        sum += v;
    }
    return sum;
}

void compress(barColumn& s, double deltaRho)
{
    for (double& r : s.state.fluid.deltaRho)
    {
        r = deltaRho;
    }
    for (double& r : s.state.walls.deltaRho)
    {
        r = deltaRho;
    }
}

} // namespace


//- In the first step neither density nor surface has moved
TEST(surfaceLoad, isPressureTimesArea)
{
    barColumn s;
    compress(s, 0.01);
    const auto solver = s.solver();
    solver->step(0, 1e-9);
    const hostState after = solver->download();
    const vector force = sumOf(after.solid.load);
    const double area = s.across*s.space.spacing;
    EXPECT_NEAR(force.x, 0.01/3*area, 1e-9);
    EXPECT_NEAR(force.y, 0, 1e-12);
    EXPECT_NEAR(force.x - sumOf(after.solid.pressureForce).x, 0, 1e-12);
}


TEST(surfaceLoad, referencePressureLoadsNothing)
{
    barColumn s;
    compress(s, 0.01);
    s.solids.coupling.referencePressure = 1.01/3;
    const auto solver = s.solver();
    solver->step(0, 1e-9);
    EXPECT_NEAR(sumOf(solver->download().solid.pressureForce).x, 0, 1e-9);
}


//- The piston problem's other half: a bar under the pressure of a resting
//  column shortens, and what it gains the fluid has lost
TEST(surfaceLoad, energyIsHandedOver)
{
    barColumn s;
    compress(s, 0.01);
    const auto solver = s.solver();
    const double dt = 0.002;
    for (int k = 0; k < 200; ++k)
    {
        solver->step(k*dt, dt);
        if (solver->maintenanceDue())
        {
            solver->maintain();
        }
    }
    const hostState after = solver->download();
    const solidEnergies& e = after.solid.energies;
    const double gained = e.kinetic + e.elastic;
    EXPECT_GT(gained, 0);
    EXPECT_NEAR(gained, e.fluid, 0.01*gained);
    EXPECT_GT(after.solid.positions[0].x, 1);
}


TEST(surfaceLoad, reactionNeedsAreaWeights)
{
    barColumn s;
    s.schemes = defaultSchemes(s.space);
    s.solids.coupling.force = couplingProperties::law::reaction;
    EXPECT_THROW(s.solver(), userError);
}


//- Without elastic solids nothing of them is kept
TEST(surfaceLoad, aSceneWithoutSolidsPaysNothing)
{
    barColumn s;
    const auto with = s.solver();
    const auto without = fluidSolver::make
    (
        "cpu", "double", s.space, s.fluid, s.schemes, s.state, nullptr
    );
    EXPECT_GT(with->bytes(), without->bytes());
    EXPECT_EQ(without->describeSolids(1e-3), "");
    EXPECT_NE(without->terms().find("left out"), std::string::npos);
    const double perParticle = double(without->bytes())
       /(s.state.fluid.size() + s.state.walls.size());
    EXPECT_LT(perParticle, 200);
}


//- Nor what ties solids to fluid, where no wall is theirs: they step as alone
TEST(surfaceLoad, aSolidThatNoFluidMeetsPaysNothing)
{
    barColumn s;
    s.solids.properties.g = vector{0.1, 0, 0};
    const auto wet = s.solver();
    s.state.wallNode.assign(s.state.walls.size(), -1);
    const auto dry = s.solver();
    EXPECT_GE(wet->bytes(), dry->bytes() + 88*s.solids.mesh.size());

    const auto alone =
        elasticSolver::make("cpu", s.solids.mesh, s.solids.properties);
    for (int k = 0; k < 20; ++k)
    {
        dry->step(0.01*k, 0.01);
        alone->advance(0.01*k, 0.01);
    }
    const hostState a = dry->download();
    const hostSolid b = alone->download();
    EXPECT_GT(b.positions[0].x, 1.001);
    for (std::size_t i = 0; i < s.solids.mesh.size(); ++i)
    {
        EXPECT_EQ(a.solid.positions[i].x, b.positions[i].x);
        EXPECT_EQ(a.solid.U[i].x, b.U[i].x);
        EXPECT_EQ(a.solid.accelerations[i].x, b.accelerations[i].x);
        EXPECT_EQ(a.solid.pressureForce[i].x, 0);
    }
}
