// Fluid and solid on a GPU, the solids' part of a step as one graph or loop by
// loop: the same bytes.

#include "barColumn.H"
#include "common/needsGpu.H"
#include "common/sameBytes.H"

using namespace gpuFsi;

namespace
{

constexpr double dt = 0.01;

barColumn sceneOf(const std::string& material = "E 2; nu 0.3;")
{
    barColumn s(material);
    s.fluid = publishedFluid(0.01);
    s.fluid.g = vector{0.2, -0.1, 0};
    s.solids.properties.g = s.fluid.g;
    for (std::size_t i = 0; i < s.state.fluid.size(); ++i)
    {
        const vector& x = s.state.fluid.positions[i];
        s.state.fluid.U[i] = {0.1*x.x, 0.02*std::sin(6*x.x), 0};
    }
    return s;
}

std::unique_ptr<fluidSolver> solverOf
(
    barColumn& s,
    const char* precision,
    bool captured
)
{
    s.solids.properties.captured = captured;
    return s.solver("cuda", precision);
}

//- Steps [first, last) with what they look at now and then
void march(fluidSolver& solver, int first, int last, double step = dt)
{
    for (int k = first; k < last; ++k)
    {
        solver.step(k*step, step);
        if (solver.maintenanceDue())
        {
            solver.maintain();
        }
    }
}

void expectSame(const hostState& a, const hostState& b)
{
    EXPECT_TRUE(sameBytes(a.fluid.positions, b.fluid.positions));
    EXPECT_TRUE(sameBytes(a.fluid.U, b.fluid.U));
    EXPECT_TRUE(sameBytes(a.fluid.deltaRho, b.fluid.deltaRho));
    EXPECT_TRUE(sameBytes(a.walls.deltaRho, b.walls.deltaRho));
    EXPECT_TRUE(sameBytes(a.walls.U, b.walls.U));
    EXPECT_TRUE(sameBytes(a.normals, b.normals));
    EXPECT_TRUE(sameBytes(a.solid.positions, b.solid.positions));
    EXPECT_TRUE(sameBytes(a.solid.U, b.solid.U));
    EXPECT_TRUE(sameBytes(a.solid.accelerations, b.solid.accelerations));
    EXPECT_TRUE(sameBytes(a.solid.load, b.solid.load));
}

//- 80 steps either way; returns how many went as one
long replaysOf(barColumn& s, const char* precision = "double")
{
    const auto one = solverOf(s, precision, true);
    const auto loops = solverOf(s, precision, false);
    march(*one, 0, 80);
    march(*loops, 0, 80);
    EXPECT_EQ(loops->nReplays(), 0);
    expectSame(one->download(), loops->download());
    return one->nReplays();
}

class cudaCoupledRepeats
:
    public testing::Test
{
public:

    void SetUp() override
    {
        NEEDS_GPU;
    }
};

} // namespace


//- Levels of state change places, so two graphs; refreshes may capture anew
TEST_F(cudaCoupledRepeats, keepTheBytes)
{
    using scheme = particleSchemes::timeScheme;
    for (const char* precision : {"single", "double"})
    {
        for (const auto time : {scheme::Euler, scheme::symplecticEuler,
            scheme::RK2})
        {
            barColumn s = sceneOf();
            s.schemes.time = time;
            s.schemes.dissipation = time == scheme::RK2 ? 0.2 : 0;
            EXPECT_GT(replaysOf(s, precision), 50);
        }
    }
}


TEST_F(cudaCoupledRepeats, keepTheBytesOfThePublishedScheme)
{
    barColumn s = sceneOf();
    s.schemes.areaWeights = particleSchemes::weight::radial;
    s.schemes.time = particleSchemes::timeScheme::Euler;
    EXPECT_GT(replaysOf(s), 50);
}


TEST_F(cudaCoupledRepeats, keepTheBytesOfReactionAndBreakingBonds)
{
    barColumn s = sceneOf("E 2; nu 0.3; breakStrain 0.002;");
    s.schemes.shifting = 0.5;
    s.solids.coupling.force = couplingProperties::law::reaction;
    EXPECT_GT(replaysOf(s), 50);
}


TEST_F(cudaCoupledRepeats, keepALedger)
{
    barColumn s = sceneOf();
    const auto one = solverOf(s, "double", true);
    const auto loops = solverOf(s, "double", false);
    for (fluidSolver* solver : {one.get(), loops.get()})
    {
        march(*solver, 0, 20);
        solver->keepLedger();
        march(*solver, 20, 40);
    }
    EXPECT_GT(one->nReplays(), 20);
    expectSame(one->download(), loops->download());
    EXPECT_EQ
    (
        one->download().works.couplingLag, loops->download().works.couplingLag
    );
}


TEST_F(cudaCoupledRepeats, keepTheBytesWhereAWallMoves)
{
    barColumn s = sceneOf();
    s.fluid.motions.resize(2);
    s.fluid.motions[0] = wallMotion::make(dictionary::fromString
    (
        "type oscillation; amplitude (0.01 0 0); omega 3; phase 0;", "left"
    ));
    EXPECT_GT(replaysOf(s), 50);
}


TEST_F(cudaCoupledRepeats, fallBackWhereAPartMoves)
{
    barColumn s = sceneOf();
    s.solids.properties = material
    (
        s.solids.mesh, "E 2; nu 0.3; parts { right { type oscillation;"
        " amplitude (0.01 0 0); omega 3; } }"
    );
    EXPECT_EQ(replaysOf(s), 0);
}


TEST_F(cudaCoupledRepeats, areCapturedAnewForAnotherTimeStep)
{
    barColumn s = sceneOf();
    const auto one = solverOf(s, "double", true);
    const auto loops = solverOf(s, "double", false);
    for (fluidSolver* solver : {one.get(), loops.get()})
    {
        march(*solver, 0, 30);
        march(*solver, 60, 90, dt/2);
    }
    EXPECT_GT(one->nReplays(), 30);
    expectSame(one->download(), loops->download());
}


//- As a write does: neighbours anew, then what the files hold
TEST_F(cudaCoupledRepeats, goOnAfterARestart)
{
    barColumn s = sceneOf();
    const auto whole = solverOf(s, "double", true);
    march(*whole, 0, 30);
    whole->refreshNeighbours();
    s.state = whole->download();
    s.state.time = 30*dt;
    const auto again = solverOf(s, "double", true);
    march(*whole, 30, 60);
    march(*again, 30, 60);
    EXPECT_GT(again->nReplays(), 10);
    expectSame(whole->download(), again->download());
}
