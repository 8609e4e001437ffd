// Who is beside whom, and the order in which a rank stores its particles.

#include "theRanks.H"

#include "base/error.H"
#include "decomposition/blockOwners.H"
#include "device/scan.H"
#include "grids.H"
#include "parallel/brickSort.H"

#include <gtest/gtest.h>

#include <array>
#include <set>

using namespace gpuFsi;

//- By brute force: blocks whose numbers differ by 1 at most along each axis
TEST(blockOwners, knowsWhomEachBlockIsBeside)
{
    for (const bool periodic : {false, true})
    {
        const blockGrid g = gridOf(6, 5, 4, periodic);
        std::vector<int> owner(g.count());
        for (int b = 0; b < g.count(); ++b)
        {
            owner[b] = int(2.5*(1 + hashed(b/3)));
        }
        for (int rank = 0; rank < 5; ++rank)
        {
            const blockOwners o(g, owner, rank);
            std::set<int> all;
            for (int b = 0; b < g.count(); ++b)
            {
                std::set<int> beside;
                for (int c = 0; owner[b] == rank && c < g.count(); ++c)
                {
                    bool near = owner[c] != rank;
                    for (int d = 0, x = b, y = c; d < 3; ++d)
                    {
                        const int n = g.n[d];
                        const int gap = std::abs(x % n - y % n);
                        near &= gap <= 1 || (periodic && gap == n - 1);
                        x /= n;
                        y /= n;
                    }
                    if (near)
                    {
                        beside.insert(owner[c]);
                        all.insert(owner[c]);
                    }
                }
                std::set<int> told;
                for (std::size_t p = 0; p < o.neighbours.size(); ++p)
                {
                    if (o.beside[b] >> p & 1)
                    {
                        told.insert(o.neighbours[p]);
                    }
                }
                EXPECT_EQ(told, beside);
            }
            EXPECT_EQ(o.neighbours, std::vector<int>(all.begin(), all.end()));
        }
    }
}


TEST(blockOwners, refusesTooManyNeighbours)
{
    const blockGrid g = gridOf(70, 3, 1);
    std::vector<int> owner(g.count(), 0);
    for (int x = 0; x < 70; ++x)
    {
        owner[g.index(x, 2, 0)] = 1 + x;
    }
    EXPECT_THROW(blockOwners(g, owner, 0), userError);
    EXPECT_EQ(blockOwners(g, owner, 10).neighbours.size(), 3u);
}


TEST(blockGrid, cellsCoverTheSameDomain)
{
    const blockGrid g = gridOf(6, 5, 4);
    const blockGrid c = g.cells(0.25, 3);
    EXPECT_EQ(c.n[0], 24);
    EXPECT_EQ(c.n[1], 20);
    EXPECT_EQ(c.n[2], 16);
    EXPECT_DOUBLE_EQ(c.n[0]*c.size.x, 6);
    EXPECT_EQ(gridOf(6, 5, 1).cells(0.25, 2).n[2], 1);
}


//- Cell number k of the order, by its definition: rows of 8 along x, then the
//  rows of a brick and the bricks along Morton's curve, lowest digits first
static std::array<int, 3> cellOfOrder(int k, int D)
{
    std::array<int, 3> c{k % 8, 0, 0};
    k /= 8;
    for (int digit = 0; digit < 3; ++digit)
    {
        for (int axis = 1; axis < D; ++axis)
        {
            c[axis] += k % 2 << digit;
            k /= 2;
        }
    }
    for (int digit = 3; k > 0; ++digit)
    {
        for (int axis = 0; axis < D; ++axis)
        {
            c[axis] += k % 2 << digit;
            k /= 2;
        }
    }
    return c;
}


//- Particles in the midst of all cells, in reverse, sorted
template<int D>
static void expectBricks(int n)
{
    const int all = D == 3 ? n*n*n : n*n;
    const blockGrid cells = gridOf(n, n, D == 3 ? n : 1, true);
    std::vector<placeRho<double>> place(all);
    std::vector<int> index(all);
    for (int i = 0; i < all; ++i)
    {
        const double width = std::ldexp(1.0, 64)/n;
        const auto at = [&](int c)
        {
            return coordinateOf<double>(std::uint64_t((c + 0.5)*width));
        };
        place[i].x = at(i % n);
        place[i].y = at(i/n % n);
        place[i].z = at(i/(n*n));
        index[i] = all - 1 - i;
    }
    particlePool<double> pool{};
    pool.place = place.data();
    pool.nOwn = all;
    sortBricks<cpuBackend, double, D>(pool, cells, index.data(), all);
    for (int k = 0; k < all; ++k)
    {
        const auto c = cellOfOrder(k, D);
        EXPECT_EQ(index[k], c[0] + n*(c[1] + n*c[2])) << D << "-D " << k;
    }
}


TEST(brickKeys, followTheCurve)
{
    expectBricks<2>(64);
    expectBricks<3>(32);
}


TEST(sortByKey, keepsTheOrderOfEqualKeys)
{
    std::vector<std::uint64_t> keys{3, 1, 3, 1, 2, 1};
    std::vector<int> values{0, 1, 2, 3, 4, 5};
    sortByKey<cpuBackend>(keys.data(), values.data(), values.size());
    EXPECT_EQ(values, (std::vector<int>{1, 3, 5, 4, 0, 2}));
}


TEST(ownPasses, flaggedOnesAreCollectedInOrder)
{
    const std::vector<int> flags{1, 0, 0, 1, 1, 0, 1, 0};
    Buffer<int, cpuBackend> at(flags);
    sumBefore(at);
    std::vector<int> index(4, -1), moved(4, -1);
    const std::vector<int> from{10, 11, 12, 13, 14, 15, 16};
    const collectFlagged collect{at.data(), 100, index.data()};
    const moveFlagged move{at.data(), from.data(), moved.data()};
    for (int k = 0; k < 7; ++k)
    {
        collect(k);
        move(k);
    }
    EXPECT_EQ(index, (std::vector<int>{100, 103, 104, 106}));
    EXPECT_EQ(moved, (std::vector<int>{10, 13, 14, 16}));
}
