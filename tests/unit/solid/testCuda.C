// The cuda backend against the cpu's.

#include "common/needsGpu.H"
#include "contactScene.H"

using namespace gpuFsi;

namespace
{

struct scene
{
    solidMesh mesh;
    std::string entries;
    vector g{};
    solidState state;
};

scene driven(int D)
{
    scene s;
    s.mesh = block(D, 8, 2, 2, 0.125, 0.1);
    s.entries =
        "E 10; nu 0.35; dashpot 0.002; friction 0.1; viscous 0.1; parts {"
        " left { type rotation; origin (0 0 0); axis (0 0 1); omega 0.5; }"
        " right { type pressure; pressure 0.05; ramp 0.5; } }";
    s.g = {0.1, -0.1, 0};
    return s;
}

scene torn(int D)
{
    scene s;
    s.mesh = block(D, 8, 2, 2, 0.125);
    s.entries = "E 1; nu 0.4; breakStrain 0.1; parts {"
        " right { type slide; normal (0 1 0); } }";
    for (const vector& x : s.mesh.points)
    {
        s.state.U.push_back({x.x > 0.49 ? 0.3 : -0.3, 0, 0});
    }
    return s;
}

hostSolid after(const scene& s, const char* backend, const std::string& more)
{
    const auto solver = elasticSolver::make
    (
        backend, s.mesh, material(s.mesh, s.entries, s.g, more), s.state
    );
    march(*solver, 20, 0.05);
    return solver->download();
}

void compare(const scene& s, const std::string& more, double within)
{
    const hostSolid a = after(s, "cpu", more), b = after(s, "cuda", more);
    for (std::size_t i = 0; i < s.mesh.size(); ++i)
    {
        const vector x = a.positions[i] - b.positions[i];
        const vector v = a.U[i] - b.U[i];
        EXPECT_LT(std::sqrt(dot(x, x)), within);
        EXPECT_LT(std::sqrt(dot(v, v)), 10*within);
    }
    EXPECT_EQ(a.broken, b.broken);
}

//- Two blocks that meet with friction over a wall that moves
std::vector<vector> afterContact(int D, const char* backend, double& lost)
{
    solidMesh mesh;
    addBlock(mesh, block(D, 6, 6, 4, 0.2, 0.05), {-1.25, 0, 0}, "one");
    addBlock
    (
        mesh, block(D, 6, 6, 4, 0.18, 0.05), {0.05, 0.3, D == 2 ? 0 : 0.1},
        "two"
    );
    const auto motion = wallMotion::make(dictionary::fromString
    (
        "type oscillation; amplitude (0.05 0.1 0); omega 2;"
    ));
    contactWalls walls;
    addWall(walls, D, {0, -0.02, 0}, {0, 1, 0}, {-1, 0, 0}, 0.15, 14);
    walls.motions[0] = motion.get();
    const auto solver = elasticSolver::make
    (
        backend, mesh,
        propertiesOf
        (
            mesh, "one { rho 1; E 1; nu 0.3; } two { rho 2; E 3; }"
            " contact { friction 0.3; damping 0.1; }", {0, -0.1, 0}
        ),
        moving(mesh, {{0.2, 0, 0}, {-0.2, 0, 0}}), walls
    );
    march(*solver, 60, 0.02);
    lost = solver->energies().contactLoss;
    return solver->download().positions;
}

class cudaSolid
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


TEST_F(cudaSolid, explicitSteps)
{
    for (const int D : {2, 3})
    {
        compare(driven(D), "stepping explicit;", 1e-12);
    }
}


TEST_F(cudaSolid, implicitSteps)
{
    for (const int D : {2, 3})
    {
        compare(driven(D), "stepping implicit; tolerance 1e-10;", 1e-9);
    }
}


TEST_F(cudaSolid, brokenBonds)
{
    for (const int D : {2, 3})
    {
        compare(torn(D), "stepping explicit; subSteps 4;", 1e-12);
        compare
        (
            torn(D), "stepping implicit; subSteps 4; tolerance 1e-10;", 1e-9
        );
    }
}


TEST_F(cudaSolid, contact)
{
    for (const int D : {2, 3})
    {
        double lostA = 0, lostB = 0;
        const std::vector<vector> a = afterContact(D, "cpu", lostA);
        const std::vector<vector> b = afterContact(D, "cuda", lostB);
        for (std::size_t i = 0; i < a.size(); ++i)
        {
            const vector d = a[i] - b[i];
            EXPECT_LT(std::sqrt(dot(d, d)), 1e-11);
        }
        EXPECT_GT(lostA, 0);
        EXPECT_NEAR(lostB/lostA, 1, 1e-9);
    }
}


//- More particles than one block of threads adds up
TEST_F(cudaSolid, aLargeSolid)
{
    scene s = driven(2);
    s.mesh = block(2, 120, 90, 0, 0.01);
    compare(s, "stepping implicit; tolerance 1e-10;", 1e-9);
}
