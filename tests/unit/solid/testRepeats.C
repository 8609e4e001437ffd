// Steps of a solid whose launches a GPU takes as one graph: which they are, and
// that the bytes of results do not depend on it.

#include "common/needsGpu.H"
#include "common/sameBytes.H"
#include "contactScene.H"

using namespace gpuFsi;

namespace
{

constexpr double dt = 0.05;

const std::string held = "E 10; nu 0.35; dashpot 0.002; parts {"
    " left { type fixed; } right { type pressure; pressure 0.05; } }";

struct scene
{
    solidMesh mesh;
    solidProperties properties;
    solidState state;

    scene
    (
        int D,
        const std::string& entries,
        const std::string& more = "stepping explicit;"
    )
    :
        mesh(block(D, 8, 2, 2, 0.125, 0.1)),
        properties(material(mesh, entries, {0.1, -0.1, 0}, more))
    {}

    std::unique_ptr<elasticSolver> solver
    (
        const char* backend,
        bool captured = true
    ) const
    {
        solidProperties p = properties;
        p.captured = captured;
        return elasticSolver::make(backend, mesh, p, state);
    }
};

//- Pulled apart along x
scene torn(int D)
{
    scene s(D, "E 1; nu 0.4; breakStrain 0.1;");
    for (const vector& x : s.mesh.points)
    {
        s.state.U.push_back({x.x > 0.49 ? 0.3 : -0.3, 0, 0});
    }
    return s;
}

scene ramped(int D)
{
    return scene
    (
        D, "E 10; nu 0.35; parts { right { type pressure; pressure 0.05;"
        " ramp 0.5; } }"
    );
}

scene driven(int D)
{
    return scene
    (
        D, "E 10; nu 0.35; parts { left { type rotation; origin (0 0 0);"
        " axis (0 0 1); omega 0.5; } }"
    );
}

void expectSame(const hostSolid& a, const hostSolid& b)
{
    EXPECT_TRUE(sameBytes(a.positions, b.positions));
    EXPECT_TRUE(sameBytes(a.U, b.U));
    EXPECT_TRUE(sameBytes(a.accelerations, b.accelerations));
    EXPECT_TRUE(sameBytes(a.broken, b.broken));
}

void expectSame(const elasticSolver& a, const elasticSolver& b)
{
    expectSame(a.download(), b.download());
    EXPECT_EQ(a.energies().gravity, b.energies().gravity);
    EXPECT_EQ(a.energies().dissipated, b.energies().dissipated);
    EXPECT_EQ(a.energies().loads, b.energies().loads);
}

//- n steps with and without graphs; returns how many went as one
long replaysOf(const scene& s, int n)
{
    const auto one = s.solver("cuda"), loops = s.solver("cuda", false);
    march(*one, n, dt);
    march(*loops, n, dt);
    EXPECT_EQ(loops->replays(), 0);
    expectSame(*one, *loops);
    return one->replays();
}

class cudaRepeats
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


TEST(repeats, explicitStepsUnderSteadyLoads)
{
    EXPECT_TRUE(scene(2, held).solver("cpu")->repeats(0, dt));
    EXPECT_TRUE(torn(3).solver("cpu")->repeats(0, dt));
    EXPECT_FALSE(scene(2, held).solver("cpu", false)->repeats(0, dt));
}


TEST(repeats, notImplicitSteps)
{
    const scene s(2, held, "stepping implicit;");
    EXPECT_FALSE(s.solver("cpu")->repeats(0, dt));
}


TEST(repeats, notWhilePartsMove)
{
    EXPECT_FALSE(driven(2).solver("cpu")->repeats(0, dt));
}


TEST(repeats, notWhileALoadGrows)
{
    const auto solver = ramped(2).solver("cpu");
    EXPECT_FALSE(solver->repeats(0, dt));
    march(*solver, 9, dt);
    EXPECT_FALSE(solver->repeats(0.45, dt));
    solver->advance(0.45, 2*dt);
    EXPECT_TRUE(solver->repeats(0.55, dt));
}


TEST(repeats, notWhereSolidsMayTouch)
{
    solidMesh mesh;
    addBlock(mesh, block(2, 4, 4, 0, 0.2), {0, 0, 0}, "one");
    addBlock(mesh, block(2, 4, 4, 0, 0.2), {1, 0, 0}, "two");
    const auto solver = elasticSolver::make
    (
        "cpu", mesh,
        propertiesOf
        (
            mesh, "one { rho 1; E 1; nu 0.3; } two { rho 2; E 3; } contact {}",
            {}
        )
    );
    EXPECT_FALSE(solver->repeats(0, dt));
}


TEST(repeats, onTheCpuNoneIsCounted)
{
    const auto solver = scene(2, held).solver("cpu");
    march(*solver, 10, dt);
    EXPECT_EQ(solver->replays(), 0);
}


TEST_F(cudaRepeats, keepTheBytes)
{
    for (const int D : {2, 3})
    {
        EXPECT_EQ(replaysOf(scene(D, held), 20), 17);
        EXPECT_EQ
        (
            replaysOf(scene(D, held, "stepping explicit; subSteps 7;"), 20), 17
        );
        EXPECT_EQ(replaysOf(torn(D), 20), 17);
    }
}


TEST_F(cudaRepeats, beginOnceALoadHasGrown)
{
    const long replays = replaysOf(ramped(2), 30);
    EXPECT_GT(replays, 10);
    EXPECT_LT(replays, 18);
}


TEST_F(cudaRepeats, fallBackWherePartsMoveOrStepsAreImplicit)
{
    EXPECT_EQ(replaysOf(driven(2), 20), 0);
    EXPECT_EQ(replaysOf(scene(2, held, "stepping implicit;"), 10), 0);
}


TEST_F(cudaRepeats, areCapturedAnewForAnotherTimeStep)
{
    const scene s(3, held);
    const auto one = s.solver("cuda"), loops = s.solver("cuda", false);
    double t = 0;
    for (const double step : {dt, dt/3, dt, dt/7, dt})
    {
        for (int k = 0; k < 8; ++k, t += step)
        {
            one->advance(t, step);
            loops->advance(t, step);
        }
        expectSame(*one, *loops);
    }
    // Three runs as they are for each of three; that of dt was kept
    EXPECT_EQ(one->replays(), 5*8 - 3*3);
}


TEST_F(cudaRepeats, goOnAfterARestart)
{
    const scene s(3, held);
    const auto whole = s.solver("cuda");
    march(*whole, 10, dt);
    scene later = s;
    later.state = stateOf(whole->download());
    const auto again = later.solver("cuda");
    for (int k = 10; k < 20; ++k)
    {
        whole->advance(k*dt, dt);
        again->advance(k*dt, dt);
    }
    EXPECT_GT(again->replays(), 0);
    expectSame(whole->download(), again->download());
}
