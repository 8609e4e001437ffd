#include "fixture.H"

#include "seeding/seeding.H"
#include "surface/surfaceRegion.H"

using namespace gpuFsi;

namespace
{

const regionSelection::add<surfaceRegion> addSurface("surface");

const double pi = std::acos(-1.0);

seededParticles seed(const lattice& l, const std::string& entries)
{
    const dictionary dict = dictionary::fromString(entries);
    regionList regions;
    for (const std::string& name : dict.keys())
    {
        regions.push_back
        (
            makeRegion
            ({
                name, dict.subDict(name), testFolder(), l.dimensions(), l.h()
            })
        );
    }
    return seedFluid(l, regions);
}

double totalArea(const seededParticles& s)
{
    double area = 0;
    for (const wallParticle& w : s.walls)
    {
        area += w.area;
    }
    return area;
}

} // namespace

TEST(region, singlePrecisionBoxFillsItsBounds)
{
    // 0.3 is not a number of single precision: the faces miss the bounds
    for (const double half : {0.3, 0.7})
    {
        writeShape(testFolder()/"box.stl", makeBox(2*half, 3), true);
        const double h = half/8;
        const lattice l
        (
            3, h, {-half, -half, -half}, {half, half, half}, {}
        );
        const seededParticles s =
            seed(l, "w { type surface; file \"box.stl\"; }");
        EXPECT_EQ(s.bulk.size(), 4096u);
        EXPECT_EQ(s.walls.size(), 6*256u);
        EXPECT_NEAR(totalArea(s), 24*half*half, 1e-9);
        EXPECT_TRUE(s.exactVolume);
        EXPECT_NEAR(s.volume, 8*half*half*half, 1e-6);
        EXPECT_EQ(s.openEnds, (std::array<std::size_t, 6>{}));
    }
}


TEST(region, agreesWithTheShape)
{
    writeShape(testFolder()/"c.stl", makeCylinder(1, 2, 400), true);
    const lattice l(3, 0.1, {-1, -1, -1}, {1, 1, 1}, {});
    const seededParticles mesh =
        seed(l, "w { type surface; file \"c.stl\"; }");
    const seededParticles shape = seed(l,
        "w { type cylinder; point1 (0 -1 0); point2 (0 1 0); radius 1; }");
    EXPECT_EQ(mesh.bulk.size(), shape.bulk.size());
    EXPECT_NEAR(double(mesh.walls.size()), double(shape.walls.size()),
        0.01*shape.walls.size());
    EXPECT_NEAR(totalArea(mesh), 6*pi, 0.01*6*pi);
}


TEST(region, obstacleInABox)
{
    // In millimetres, and the fluid around it
    writeShape(testFolder()/"ball.obj", makeSphere(300, 200), true);
    const lattice l(3, 0.05, {-1, -1, -1}, {1, 1, 1}, {});
    const seededParticles s = seed(l,
        "tank { type box; min (-1 -1 -1); max (1 1 1); }"
        "ball { type surface; file \"ball.obj\"; scale 0.001;"
        " side outside; }");
    EXPECT_NEAR(s.volume, 8 - 4*pi/3*0.027, 0.002);
    EXPECT_NEAR(totalArea(s), 24 + 4*pi*0.09, 0.02);
    for (const wallParticle& w : s.walls)
    {
        if (w.patch == 1)
        {
            EXPECT_GT(dot(w.normal, w.position), 0.299);
        }
    }
}


TEST(region, sectionInTwoDimensions)
{
    writeShape(testFolder()/"ball.stl", makeSphere(0.9, 300), true);
    const double h = 0.05;
    const lattice l(2, h, {-1, -1, 0}, {1, 1, 0}, {});
    const seededParticles s =
        seed(l, "w { type surface; file \"ball.stl\"; }");
    EXPECT_NEAR(s.volume, pi*0.81, 0.01);
    EXPECT_NEAR(totalArea(s), 2*pi*0.9, 0.02*2*pi*0.9);
    for (const wallParticle& w : s.walls)
    {
        EXPECT_EQ(w.position.z, 0);
        EXPECT_EQ(w.normal.z, 0);
        EXPECT_NEAR(magnitude(w.normal), 1, 1e-12);
    }
}


TEST(region, cavityCountsAsOutside)
{
    triangleSurface s = plain(makeBox(2, 2));
    const shapeSurface inner = makeBox(1, 2);
    shapeSurface both{s.points, s.triangles};
    for (const auto& t : inner.triangles)
    {
        const int shift = int(s.points.size());
        both.triangles.push_back({t[0] + shift, t[2] + shift, t[1] + shift});
    }
    both.points.insert
    (
        both.points.end(), inner.points.begin(), inner.points.end()
    );
    writeShape(testFolder()/"hollow.ply", both, true);
    const lattice l(3, 0.1, {-1, -1, -1}, {1, 1, 1}, {});
    const seededParticles hollow =
        seed(l, "w { type surface; file \"hollow.ply\"; }");
    EXPECT_EQ(hollow.bulk.size(), 7000u);
    EXPECT_NEAR(hollow.volume, 7, 1e-12);
    EXPECT_NEAR(totalArea(hollow), 30, 1e-9);
}
