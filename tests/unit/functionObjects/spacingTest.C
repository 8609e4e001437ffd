#include "lattice.H"

#include "functionObjects/nearestDistance.H"

using namespace gpuFsi;

namespace
{

domain unitBox(int dimensions, bool x, bool y, bool z)
{
    domain d;
    d.dimensions = dimensions;
    d.spacing = 0.1;
    d.lo = {0, 0, 0};
    d.hi = {1, 1, dimensions == 3 ? 1.0 : 0.0};
    d.periodic = {x, y, z};
    d.volume = 1;
    return d;
}

//- All pairs, all 27 images
double bruteForce(const hostState& state, const domain& d, std::size_t i)
{
    std::vector<vector> all = state.fluid.positions;
    all.insert
    (
        all.end(), state.walls.positions.begin(), state.walls.positions.end()
    );
    double least = 1e300;
    for (std::size_t j = 0; j < all.size(); ++j)
    {
        for (int image = 0; image < 27; ++image)
        {
            const vector shift
            {
                d.periodic[0]*(image%3 - 1.0),
                d.periodic[1]*(image/3%3 - 1.0),
                d.periodic[2]*(image/9 - 1.0)
            };
            const vector e =
                all[j] + shift - state.fluid.positions[i];
            if (dot(e, e) > 0 || j != i)
            {
                least = std::min(least, dot(e, e));
            }
        }
    }
    return std::sqrt(least)/state.h;
}

} // namespace


TEST(spacing, equalsBruteForceInTwoAndThreeDimensions)
{
    for (int D : {2, 3})
    {
        for (int periodic = 0; periodic < (D == 3 ? 8 : 4); ++periodic)
        {
            const domain d = unitBox
            (
                D, periodic & 1, periodic & 2, periodic & 4
            );
            // Coarse and fine: voids of many cells, clumps, and walls
            for (int n : {2, 7})
            {
                hostState state = lattice(n, D, 0.49);
                state.h = 0.1;
                state.walls.positions = {{0.01, 0.02, 0}, {0.5, 0.99, 0}};
                const auto nearest = nearestDistance(state, d);
                ASSERT_EQ(nearest.size(), state.fluid.size());
                for (std::size_t i = 0; i < nearest.size(); ++i)
                {
                    EXPECT_NEAR(nearest[i], bruteForce(state, d, i), 1e-12)
                        << D << " " << periodic << " " << n << " " << i;
                }
            }
        }
    }
}


TEST(spacing, ofASingleParticle)
{
    hostState state = lattice(1, 3, 0);
    state.h = 0.1;
    EXPECT_NEAR
    (
        nearestDistance(state, unitBox(3, false, true, false))[0], 10, 1e-12
    );
    EXPECT_TRUE
    (
        std::isinf(nearestDistance(state, unitBox(3, false, false, false))[0])
    );
}


TEST(spacing, writesARowATime)
{
    testRun run;
    unitBox(3, true, true, true).write(run.info.casePath);
    hostState state = lattice(10, 3, 0);
    const dictionary dict =
        dictionary::fromString("functions { s { type spacing; } }");
    functionObjectList list(dict, run.info);
    list.start(state, run.info);

    // One particle of the thousand moves to 0.4 h from its neighbour
    state.fluid.positions[0].x += 0.06;
    run.step(1);
    list.execute(state, run.info);
    EXPECT_TRUE(dict.unread().empty());

    const auto rows = run.rows("s/0/spacing.dat");
    ASSERT_EQ(rows.size(), 2u);
    const std::vector<double> first{0, 1, 1, 1};
    const std::vector<double> second{0.1, 0.4, 0.9988, 1};
    for (int i = 0; i < 4; ++i)
    {
        EXPECT_NEAR(rows[0][i], first[i], 1e-8) << i;
        EXPECT_NEAR(rows[1][i], second[i], 1e-8) << i;
    }
}
