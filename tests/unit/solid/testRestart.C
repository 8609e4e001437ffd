// A run that starts again goes on to the same bytes.

#include "common/sameBytes.H"
#include "contactScene.H"

#include <gtest/gtest.h>

using namespace gpuFsi;

namespace
{

bool same(const hostSolid& a, const hostSolid& b)
{
    return sameBytes(a.positions, b.positions) && sameBytes(a.U, b.U)
     && sameBytes(a.accelerations, b.accelerations)
     && sameBytes(a.load, b.load);
}

//- Gravity, dashpots, a load, a driven part; ten steps, or five and five
bool tenAreFiveAndFive(int D, const std::string& stepping)
{
    const solidMesh mesh = block(D, 6, 2, 2, 0.2, 0.1);
    const solidProperties p = material
    (
        mesh,
        "E 10; nu 0.4; dashpot 0.01; friction 0.1; viscous 0.2; parts {"
        " left { type oscillation; amplitude (0 0.1 0); omega 3; }"
        " right { type pressure; pressure 0.5; ramp 0.7; } }",
        {0, -1, 0}, stepping
    );
    solidState first;
    first.load.assign(mesh.size(), vector{0.001, 0, 0});
    const auto whole = elasticSolver::make("cpu", mesh, p, first);
    auto parted = elasticSolver::make("cpu", mesh, p, first);
    const double dt = 0.1;
    for (int k = 0; k < 10; ++k)
    {
        if (k == 5)
        {
            parted = elasticSolver::make
            (
                "cpu", mesh, p, stateOf(parted->download())
            );
        }
        whole->advance(k*dt, dt);
        parted->advance(k*dt, dt);
        if (whole->omegaMax() != parted->omegaMax())
        {
            return false;
        }
    }
    const hostSolid a = whole->download();
    return same(a, parted->download()) && a.positions[3].y != mesh.points[3].y;
}

//- Two blocks that meet with friction over a wall that moves
struct contactRun
{
    solidMesh mesh;
    std::unique_ptr<wallMotion> motion;
    contactWalls walls;
    solidProperties properties;

    explicit contactRun(int D)
    {
        addBlock(mesh, block(D, 6, 6, 4, 0.2, 0.05), {-1.25, 0, 0}, "one");
        addBlock
        (
            mesh, block(D, 6, 6, 4, 0.18, 0.05), {0.05, 0.3, D == 2 ? 0 : 0.1},
            "two"
        );
        motion = wallMotion::make(dictionary::fromString
        (
            "type oscillation; amplitude (0.05 0.1 0); omega 2;"
        ));
        addWall(walls, D, {0, -0.02, 0}, {0, 1, 0}, {-1, 0, 0}, 0.15, 14);
        walls.motions[0] = motion.get();
        properties = propertiesOf
        (
            mesh, "one { rho 1; E 1; nu 0.3; } two { rho 2; E 3; }"
            " contact { friction 0.3; damping 0.1; }", {0, -0.1, 0}
        );
    }

    std::unique_ptr<elasticSolver> start(const solidState& s, double time)
    {
        walls.time = time;
        return elasticSolver::make("cpu", mesh, properties, s, walls);
    }
};

} // namespace


TEST(solidRestart, inTheMiddleOfAContact)
{
    for (const int D : {2, 3})
    {
        contactRun run(D);
        const auto whole =
            run.start(moving(run.mesh, {{0.2, 0, 0}, {-0.2, 0, 0}}), 0);
        march(*whole, 30, 0.02);
        const hostSolid half = whole->download();
        EXPECT_GT(whole->energies().contact, 0);
        const auto parted = run.start(stateOf(half), 30*0.02);
        EXPECT_EQ(parted->energies().contact, whole->energies().contact);
        for (int k = 30; k < 60; ++k)
        {
            whole->advance(0.02*k, 0.02);
            parted->advance(0.02*k, 0.02);
        }
        EXPECT_TRUE(same(whole->download(), parted->download()));
    }
}


TEST(solidRestart, tenStepsAreFiveAndFive)
{
    for (const char* stepping : {"stepping explicit;", "stepping implicit;"})
    {
        EXPECT_TRUE(tenAreFiveAndFive(2, stepping));
        EXPECT_TRUE(tenAreFiveAndFive(3, stepping));
    }
}
