// The cuda backend against the cpu's.

#include "blocks.H"
#include "common/needsGpu.H"

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


//- More particles than one block of threads adds up
TEST_F(cudaSolid, aLargeSolid)
{
    scene s = driven(2);
    s.mesh = block(2, 120, 90, 0, 0.01);
    compare(s, "stepping implicit; tolerance 1e-10;", 1e-9);
}
