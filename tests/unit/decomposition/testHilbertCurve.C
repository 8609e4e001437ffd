#include "decomposition/hilbertCurve.H"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

using namespace gpuFsi;

namespace
{

//- Steps of the path that are longer than from a block to one beside it;
//  fails where a block is left out, met twice, or beyond a corner
int longSteps(int nx, int ny, int nz)
{
    const int n[3] = {nx, ny, nz};
    const std::vector<int> path = hilbertCurve(n);
    std::vector<int> sorted(path);
    std::sort(sorted.begin(), sorted.end());
    EXPECT_EQ(sorted.size(), std::size_t(nx)*ny*nz);
    for (std::size_t i = 0; i < sorted.size(); ++i)
    {
        EXPECT_EQ(sorted[i], int(i)) << nx << ' ' << ny << ' ' << nz;
    }
    int longer = 0;
    for (std::size_t i = 1; i < path.size(); ++i)
    {
        const int a = path[i - 1], b = path[i];
        const int dx = std::abs(a % nx - b % nx);
        const int dy = std::abs(a/nx % ny - b/nx % ny);
        const int dz = std::abs(a/nx/ny - b/nx/ny);
        EXPECT_LE(std::max({dx, dy, dz}), 1)
            << nx << ' ' << ny << ' ' << nz << " at " << i;
        longer += dx + dy + dz > 1;
    }
    return longer;
}

} // namespace


TEST(hilbertCurve, evenSizesStepBySides)
{
    for (int n : {2, 4, 8, 16})
    {
        EXPECT_EQ(longSteps(n, n, 1), 0) << n;
        EXPECT_EQ(longSteps(n, n, n), 0) << n;
    }
    EXPECT_EQ(longSteps(64, 12, 1), 0);
    EXPECT_EQ(longSteps(6, 30, 10), 0);
}


TEST(hilbertCurve, anySize)
{
    for (int z = 1; z <= 9; ++z)
    for (int y = 1; y <= 9; ++y)
    for (int x = 1; x <= 9; ++x)
    {
        EXPECT_LE(longSteps(x, y, z), 1 + x*y*z/20)
            << x << ' ' << y << ' ' << z;
    }
    EXPECT_LE(longSteps(101, 7, 3), 50);
}
