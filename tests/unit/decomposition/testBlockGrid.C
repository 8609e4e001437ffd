// Blocks of particles against the geometry, pair by pair.
#include "grids.H"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

using namespace gpuFsi;

namespace
{

double nearest(double d, double length, bool periodic)
{
    return periodic ? d - length*std::round(d/length) : d;
}

//- May the blocks of a direction hold neighbours: the same, or beside?
bool beside(const blockGrid& g, int d, int a, int b)
{
    return a == b || g.beside(d, a, 1) == b || g.beside(d, a, -1) == b;
}

void checkPairs(const domain& d, double reach)
{
    const frame f = frame::of(d);
    const blockGrid g = blockGrid::of(d, f, reach);
    const vector size = d.hi - d.lo;
    std::vector<vector> x;
    for (int i = 0; i < 1500; ++i)
    {
        const auto at = [&](int k, double lo, double length)
        {
            return lo + 0.5*(1 + hashed(3*i + k))*length;
        };
        x.push_back
        ({
            at(0, d.lo.x, size.x), at(1, d.lo.y, size.y),
            d.dimensions == 3 ? at(2, d.lo.z, size.z) : d.lo.z
        });
    }
    x.push_back(d.lo);
    x.push_back(d.hi);

    std::vector<int> blocks;
    for (const vector& p : x)
    {
        const int b = g.blockOf(f, p);
        ASSERT_TRUE(b >= 0 && b < g.count());
        blocks.push_back(b);
        const int at[3] = {b % g.n[0], b/g.n[0] % g.n[1], b/g.n[0]/g.n[1]};
        const vector from = p - g.origin;
        const double low[3] = {from.x/g.size.x, from.y/g.size.y,
            g.n[2] > 1 ? from.z/g.size.z : 0};
        for (int k = 0; k < 3; ++k)
        {
            const double off = nearest
            (
                low[k] - at[k] - 0.5, g.n[k], g.periodic[k]
            );
            EXPECT_LE(std::abs(off), 0.5 + 1e-6);
        }
    }
    int near = 0;
    for (std::size_t i = 0; i < x.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
    {
        const vector e = x[i] - x[j];
        const double dx = nearest(e.x, size.x, d.periodic[0]);
        const double dy = nearest(e.y, size.y, d.periodic[1]);
        const double dz = nearest(e.z, size.z, d.periodic[2]);
        if (dx*dx + dy*dy + dz*dz > reach*reach)
        {
            continue;
        }
        ++near;
        const int a = blocks[i], b = blocks[j];
        EXPECT_TRUE(beside(g, 0, a % g.n[0], b % g.n[0]));
        EXPECT_TRUE(beside(g, 1, a/g.n[0] % g.n[1], b/g.n[0] % g.n[1]));
        EXPECT_TRUE(beside(g, 2, a/g.n[0]/g.n[1], b/g.n[0]/g.n[1]));
    }
    EXPECT_GT(near, 1000);
}

domain box(int dimensions, bool periodic)
{
    domain d = periodicBox(30, dimensions, 2);
    d.hi.x += 0.37;
    d.lo.y -= 1.1;
    d.periodic = {periodic, periodic, periodic && dimensions == 3};
    return d;
}

} // namespace


TEST(blockGrid, neighboursLieInBlocksBesideEachOther)
{
    for (bool periodic : {false, true})
    {
        checkPairs(box(2, periodic), 2.77*box(2, periodic).spacing);
        checkPairs(box(3, periodic), 2.43*box(3, periodic).spacing);
    }
    domain mixed = box(3, false);
    mixed.periodic[1] = true;
    checkPairs(mixed, 4*mixed.spacing);
}


TEST(blockGrid, blocksAreAtLeastASearchRadiusWide)
{
    const domain d = box(3, true);
    for (double reach : {0.1, 0.3, 0.9, 5.0})
    {
        const blockGrid g = blockGrid::of(d, frame::of(d), reach);
        EXPECT_TRUE(g.n[0] == 1 || g.size.x > reach);
        EXPECT_TRUE(g.n[1] == 1 || g.size.y > reach);
        EXPECT_TRUE(g.n[2] == 1 || g.size.z > reach);
    }
}


TEST(blockGrid, particlesOutsideBelongToTheOutermostBlocks)
{
    const domain d = box(2, false);
    const frame f = frame::of(d);
    const blockGrid g = blockGrid::of(d, f, 0.2);
    const double h = d.spacing;
    EXPECT_EQ(g.blockOf(f, d.lo - vector{h, h, 0}), 0);
    EXPECT_EQ(g.blockOf(f, d.hi + vector{h, h, 0}), g.count() - 1);
}
