#include "common/lattice.H"
#include "neighbours/packOffers.H"

#include <gtest/gtest.h>

using namespace gpuFsi;

//- Largest cosine over all directions, in floating point
template<int D>
static int bruteForce(const offset& d, double& lead)
{
    int best = -1, index = 0;
    double bestCosine = -2, second = -2;
    for (int z = D == 3 ? -1 : 0; z <= (D == 3 ? 1 : 0); ++z)
    for (int y = -1; y <= 1; ++y)
    for (int x = -1; x <= 1; ++x)
    {
        if (x == 0 && y == 0 && z == 0)
        {
            continue;
        }
        const double c = (x*d.x + y*d.y + z*d.z)/std::sqrt(x*x + y*y + z*z);
        if (c > bestCosine)
        {
            second = bestCosine;
            bestCosine = c;
            best = index;
        }
        else
        {
            second = std::max(second, c);
        }
        ++index;
    }
    lead = bestCosine - second;
    return best;
}

template<int D>
static void compare()
{
    int compared = 0;
    for (int i = 0; i < 100000; ++i)
    {
        const offset d
        {
            int(16384*hashed(3*i)), int(16384*hashed(3*i + 1)),
            D == 3 ? int(16384*hashed(3*i + 2)) : 0
        };
        if (d.squared() == 0 || std::sqrt(double(d.squared())) > 16384)
        {
            continue;
        }
        double lead;
        const int expected = bruteForce<D>(d, lead);
        if (lead > 1e-9)
        {
            ASSERT_EQ(directionOf<D>(d), expected)
                << d.x << ' ' << d.y << ' ' << d.z;
            ++compared;
        }
    }
    EXPECT_GT(compared, 30000);
}

TEST(direction, agreesWithLargestCosine3D)
{
    compare<3>();
}

TEST(direction, agreesWithLargestCosine2D)
{
    compare<2>();
}

TEST(direction, latticeOffsetsHaveTheirOwnDirection)
{
    std::vector<int> seen(26, 0);
    for (int z = -1; z <= 1; ++z)
    for (int y = -1; y <= 1; ++y)
    for (int x = -1; x <= 1; ++x)
    {
        if (x || y || z)
        {
            ++seen[directionOf<3>({1000*x, 1000*y, 1000*z})];
        }
    }
    EXPECT_EQ(seen, std::vector<int>(26, 1));
}


//- Eight at a time: the same, ties and all
template<int D>
static void comparePacks()
{
    using V = pack<int, 8>;
    for (int i = 0; i < 20000; ++i)
    {
        // Small ones tie often
        const int size = i % 2 ? 16384 : 3;
        V x, y, z{};
        for (int l = 0; l < 8; ++l)
        {
            const std::uint64_t k = 24*std::uint64_t(i) + 3*l;
            x[l] = int(std::lround(0.57*size*hashed(k)));
            y[l] = int(std::lround(0.57*size*hashed(k + 1)));
            z[l] = D == 3 ? int(std::lround(0.57*size*hashed(k + 2))) : 0;
        }
        const V k = directionsOf<D>(x, y, z);
        for (int l = 0; l < 8; ++l)
        {
            const offset d{x[l], y[l], z[l]};
            if (d.squared() > 0)
            {
                ASSERT_EQ(k[l], directionOf<D>(d))
                    << d.x << ' ' << d.y << ' ' << d.z;
            }
            ASSERT_GE(k[l], 0);
            ASSERT_LT(k[l], nDirections<D>);
        }
    }
}

TEST(direction, packsAgree)
{
    comparePacks<2>();
    comparePacks<3>();
}
