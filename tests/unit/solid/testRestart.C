// A run that starts again goes on to the same bytes.

#include "blocks.H"

#include <gtest/gtest.h>

#include <cstring>

using namespace gpuFsi;

namespace
{

template<class T>
bool sameBytes(const std::vector<T>& a, const std::vector<T>& b)
{
    return a.size() == b.size()
     && std::memcmp(a.data(), b.data(), a.size()*sizeof(T)) == 0;
}

bool same(const hostSolid& a, const hostSolid& b)
{
    return sameBytes(a.positions, b.positions) && sameBytes(a.U, b.U)
     && sameBytes(a.accelerations, b.accelerations)
     && sameBytes(a.load, b.load);
}

solidState stateOf(const hostSolid& s)
{
    solidState state;
    state.positions = s.positions;
    state.U = s.U;
    state.accelerations = s.accelerations;
    state.load = s.load;
    return state;
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

} // namespace


TEST(solidRestart, tenStepsAreFiveAndFive)
{
    for (const char* stepping : {"stepping explicit;", "stepping implicit;"})
    {
        EXPECT_TRUE(tenAreFiveAndFive(2, stepping));
        EXPECT_TRUE(tenAreFiveAndFive(3, stepping));
    }
}
