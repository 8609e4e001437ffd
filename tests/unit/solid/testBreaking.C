// Bonds that break: both ends alike, for good, without a force from nowhere.

#include "blocks.H"
#include "common/sameBytes.H"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

using namespace gpuFsi;

namespace
{

const char* const schemes[] =
{
    "stepping explicit; subSteps 12;", "stepping implicit; subSteps 4;"
};

//- A free bar of nx cells, torn at both halves with the speed 0.3
struct torn
{
    solidMesh mesh;
    solidProperties properties;
    springNetwork net;
    solidState state;

    torn(int D, const std::string& stepping)
    :
        mesh(block(D, 8, 2, 2, 0.125)),
        properties
        (
            material(mesh, "E 1; nu 0.4; breakStrain 0.1;", {}, stepping)
        ),
        net(springNetwork::of(mesh, properties))
    {
        for (const vector& x : mesh.points)
        {
            state.U.push_back({x.x > 0.49 ? 0.3 : -0.3, 0, 0});
        }
    }

    std::unique_ptr<elasticSolver> solver() const
    {
        return elasticSolver::make("cpu", mesh, properties, state);
    }
};

bool symmetric(const springNetwork& net, const std::vector<bondMask>& broken)
{
    const auto begin = net.bondTo.begin();
    for (int i = 0; i < net.n; ++i)
    {
        for (int b = net.bondBegin[i]; b < net.bondBegin[i + 1]; ++b)
        {
            const int j = net.bondTo[b];
            const int back = int
            (
                std::lower_bound
                (
                    begin + net.bondBegin[j], begin + net.bondBegin[j + 1], i
                ) - begin
            );
            if
            (
                isBroken(net, broken, i, b) != isBroken(net, broken, j, back)
            )
            {
                return false;
            }
        }
    }
    return true;
}

//- Particles that hang together with particle 0
int reached(const springNetwork& net, const std::vector<bondMask>& broken)
{
    std::vector<char> seen(net.n, 0);
    std::vector<int> list{0};
    seen[0] = 1;
    for (std::size_t k = 0; k < list.size(); ++k)
    {
        const int i = list[k];
        for (int b = net.bondBegin[i]; b < net.bondBegin[i + 1]; ++b)
        {
            const int j = net.bondTo[b];
            if (!isBroken(net, broken, i, b) && !seen[j])
            {
                seen[j] = 1;
                list.push_back(j);
            }
        }
    }
    return int(list.size());
}

} // namespace


TEST(breaking, tornBarKeepsMomentumAndTheLedgerCloses)
{
    for (const int D : {2, 3})
    {
        for (const char* scheme : schemes)
        {
            const torn t(D, scheme);
            const auto solver = t.solver();
            const vector start = [&]
            {
                vector sum{};
                for (int i = 0; i < t.net.n; ++i)
                {
                    sum += t.net.mass[i]*t.state.U[i];
                }
                return sum;
            }();
            const double kinetic = solver->energies().kinetic;
            march(*solver, 40, 0.05);
            const hostSolid s = solver->download();
            vector momentum{};
            for (int i = 0; i < t.net.n; ++i)
            {
                momentum += t.net.mass[i]*s.U[i];
            }
            const vector change = momentum - start;
            EXPECT_LT(std::sqrt(dot(change, change)), 1e-10);
            EXPECT_TRUE(symmetric(t.net, s.broken));
            const int half = reached(t.net, s.broken);
            EXPECT_GT(half, t.net.n/4);
            EXPECT_LT(half, 3*t.net.n/4);
            EXPECT_GT(s.positions[8].x - s.positions[0].x, 1.2);
            for (const double v : s.vonMises)
            {
                EXPECT_LT(v, 1);
            }

            const solidEnergies e = solver->energies();
            EXPECT_EQ(e.brokenBonds, countBroken(s.broken));
            EXPECT_GT(e.brokenBonds, 0);
            EXPECT_GT(e.dissipated, 0);
            const double balance = e.kinetic + e.elastic + e.dissipated;
            RecordProperty
            (
                fmt::format("{}D{}", D, scheme[9]),
                fmt::format
                (
                    "{} broken, dissipated {:.3g}, balance {:.5f}",
                    e.brokenBonds, e.dissipated/kinetic, balance/kinetic
                )
            );
            EXPECT_NEAR(balance/kinetic, 1, 0.01);
        }
    }
}


TEST(breaking, restartGoesOnToTheSameBytes)
{
    for (const char* scheme : schemes)
    {
        const torn t(3, scheme);
        const auto whole = t.solver();
        std::unique_ptr<elasticSolver> parted;
        for (int k = 0; k < 10; ++k)
        {
            if (k == 5)
            {
                const hostSolid s = whole->download();
                EXPECT_GT(countBroken(s.broken), 0);
                parted = elasticSolver::make
                (
                    "cpu", t.mesh, t.properties,
                    {s.positions, s.U, s.accelerations, s.load, s.broken}
                );
            }
            whole->advance(0.05*k, 0.05);
            if (parted)
            {
                parted->advance(0.05*k, 0.05);
            }
        }
        const hostSolid a = whole->download(), b = parted->download();
        EXPECT_TRUE(sameBytes(a.positions, b.positions));
        EXPECT_TRUE(sameBytes(a.U, b.U));
        EXPECT_TRUE(sameBytes(a.broken, b.broken));
    }
}


TEST(breaking, forGoodAndOnlyPastTheStrain)
{
    const solidMesh mesh = block(2, 1, 1, 0, 1);
    const solidProperties p = material
    (
        mesh,
        "E 1; nu 0.4; breakStrain 0.1; parts {"
        " left { type fixed; }"
        " right { type oscillation; amplitude (0.2 0 0); omega 1; } }",
        {}, "stepping explicit;"
    );
    const auto solver = elasticSolver::make("cpu", mesh, p);
    // Edges along x pass 0.1 at sin t = 0.5; diagonals reach 0.1045
    solver->advance(0, 0.52);
    EXPECT_EQ(solver->energies().brokenBonds, 0);
    solver->advance(0.52, 0.01);
    EXPECT_EQ(solver->energies().brokenBonds, 2);
    solver->advance(0.53, 1.03);
    EXPECT_EQ(solver->energies().brokenBonds, 4);
    solver->advance(1.56, 1.6);
    const solidEnergies e = solver->energies();
    EXPECT_EQ(e.brokenBonds, 4);
    // The edges along y are left, the cell is torn: nothing pulls
    EXPECT_LT(e.elastic, 1e-6);
}


TEST(breaking, masksOfAnotherMeshAreRefused)
{
    const torn t(2, "");
    solidState s;
    s.broken.assign(3, 0);
    EXPECT_THROW
    (
        elasticSolver::make("cpu", t.mesh, t.properties, s), userError
    );
}
