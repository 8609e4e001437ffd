#include "fixture.H"

#include "seeding/solidSeeding.H"
#include "surface/surfaceDistance.H"
#include "surface/surfaceRegion.H"

using namespace gpuFsi;

namespace
{

const double pi = std::acos(-1.0);

seededSolids seed
(
    const shapeSurface& shape,
    int dimensions,
    double h
)
{
    writeShape(testFolder()/"solid.stl", shape, true);
    const dictionary dict = dictionary::fromString
    (
        "s { type surface; file \"solid.stl\"; }"
    );
    const lattice l(dimensions, h, {-1, -1, -1}, {1, 1, 1}, {});
    return seedSolids(readSolids(dict, testFolder(), dimensions, h), l);
}

} // namespace

TEST(surfaceSolids, nearestIsThatOfAllTriangles)
{
    const triangleSurface s = bumpySphere(1, 24);
    const surfaceDistance distance(s, 3);
    for (int i = 0; i < 200; ++i)
    {
        const vector p
        {
            1.3*std::sin(1.0*i), 1.3*std::sin(2.7*i), 1.3*std::sin(5.1*i)
        };
        const auto on = distance.nearest(p);
        ASSERT_TRUE(on);
        double least = INFINITY;
        for (std::size_t t = 0; t < s.triangles.size(); ++t)
        {
            const vector& a = s.corner(t, 0);
            const vector n = (1/magnitude(s.normal(t)))*s.normal(t);
            // Corners bound the distance above, planes below
            least = std::min(least, magnitude(p - a));
            if (magnitude(on->normal - n) < 1e-12)
            {
                EXPECT_LE(std::abs(dot(p - a, n)),
                    magnitude(p - on->position) + 1e-12);
            }
        }
        EXPECT_LE(magnitude(p - on->position), least + 1e-12);
    }
}

TEST(surfaceSolids, boxIsExact)
{
    const seededSolids s = seed(makeBox(1, 3), 3, 0.125);
    EXPECT_EQ(s.reports[0].nNodes, 9u*9*9);
    EXPECT_EQ(s.reports[0].nCells, 8u*8*8);
    EXPECT_NEAR(s.reports[0].volume, 1, 1e-12);
    EXPECT_NEAR(s.reports[0].area, 6, 1e-12);
}

TEST(surfaceSolids, torusConverges)
{
    double error[2];
    for (int i = 0; i < 2; ++i)
    {
        const double h = i ? 0.04 : 0.08;
        const seededSolids s = seed(makeTorus(0.6, 0.3, 160), 3, h);
        const solidReport& r = s.reports[0];
        EXPECT_EQ(r.nOff, 0u);
        EXPECT_LT(r.nDropped, 0.02*r.nCells);
        EXPECT_GE(r.cellVolumes.first, 0.15*h*h*h);
        error[i] = 1 - r.volume/ *r.shapeVolume;
    }
    EXPECT_LT(std::abs(error[1]), 0.01);
    EXPECT_GT(error[0]/error[1], 3);
}

TEST(surfaceSolids, sectionIn2D)
{
    // The plane z = 0 cuts a disc out of a sphere
    const seededSolids s = seed(makeSphere(0.8, 128), 2, 0.05);
    EXPECT_EQ(s.reports[0].nOff, 0u);
    EXPECT_NEAR(s.reports[0].volume, pi*0.64, 0.01);
    EXPECT_NEAR(s.reports[0].area, 2*pi*0.8, 0.02);
    for (const vector& p : s.mesh.points)
    {
        EXPECT_EQ(p.z, 0);
    }
}
