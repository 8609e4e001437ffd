#include "solidFixture.H"

using namespace gpuFsi;

namespace
{

const double pi = std::acos(-1.0);

lattice space(int dimensions, double h)
{
    return {dimensions, h, {-1, -1, -1}, {1, 1, 1}, {}};
}

double farthest(const solidMesh& m, const std::function<double(vector)>& phi)
{
    double most = 0;
    for (const auto& face : outerFaces(m))
    {
        for (const int node : face)
        {
            most = std::max(most, std::abs(phi(m.points[node])));
        }
    }
    return most;
}

struct errors
{
    double volume, area;
};

errors errorsOf(const std::string& shape, double h, double V, double A)
{
    const seededSolids s = makeSolids("s { " + shape + " }", space(3, h));
    expectSound(s.mesh, h*h*h);
    EXPECT_EQ(s.reports[0].nOff, 0u);
    EXPECT_EQ(s.reports[0].nDropped, 0u);
    return {s.reports[0].volume/V - 1, s.reports[0].area/A - 1};
}

} // namespace

TEST(solids, boxIn2D)
{
    const seededSolids s = makeSolids
    (
        "beam { type box; min (0 0 -9); max (0.35 0.02 9); spacing 0.0025; }",
        space(2, 0.005)
    );
    const solidReport& r = s.reports[0];
    EXPECT_EQ(r.nNodes, 141u*9);
    EXPECT_EQ(r.nCells, 140u*8);
    EXPECT_EQ(r.nSurface, 2u*(140 + 8));
    EXPECT_NEAR(r.volume, 0.007, 1e-16);
    EXPECT_NEAR(r.area, 0.74, 1e-14);
    EXPECT_NEAR(r.cellVolumes.first, 6.25e-6, 1e-17);
    EXPECT_NEAR(r.cellVolumes.second, 6.25e-6, 1e-17);
    EXPECT_EQ(s.mesh.points.front().x, 0);
    EXPECT_EQ(s.mesh.points.back().x, 0.35);
    EXPECT_EQ(s.mesh.points.back().y, 0.02);
    expectSound(s.mesh, 6.25e-6);
}

TEST(solids, boxIn3DWithSpacingFitted)
{
    const seededSolids s = makeSolids
    (
        "b { type box; min (0 0 0); max (0.5 0.21 0.09); }", space(3, 0.1)
    );
    EXPECT_EQ(s.reports[0].nNodes, 6u*3*2);
    EXPECT_EQ(s.reports[0].nCells, 5u*2);
    EXPECT_NEAR(s.reports[0].volume, 0.5*0.21*0.09, 1e-15);
    EXPECT_NEAR(s.reports[0].edges.first, 0.09, 1e-15);
    EXPECT_NEAR(s.reports[0].edges.second, 0.105, 1e-15);
}

TEST(solids, boxIsCutByTheBounds)
{
    const seededSolids s = makeSolids
    (
        "b { type box; min (0.5 0 0); max (3 0.5 0.5); }", space(3, 0.25)
    );
    EXPECT_NEAR(s.reports[0].volume, 0.125, 1e-15);
    EXPECT_FALSE(s.reports[0].shapeVolume);
}

TEST(solids, sphereConverges)
{
    const std::string shape = "type sphere; centre (0.1 0 0); radius 0.8;";
    const double V = 4*pi/3*0.512, A = 4*pi*0.64;
    const errors coarse = errorsOf(shape, 0.16, V, A);
    const errors fine = errorsOf(shape, 0.08, V, A);
    EXPECT_LT(std::abs(fine.volume), 0.01);
    EXPECT_GT(coarse.volume/fine.volume, 3.4);
    EXPECT_GT(coarse.area/fine.area, 3.0);
}

TEST(solids, cylinderConverges)
{
    const std::string shape =
        "type cylinder; point1 (0 -0.6 0); point2 (0 0.6 0); radius 0.8;";
    const double V = pi*0.64*1.2, A = 2*pi*0.64 + 2*pi*0.8*1.2;
    const errors coarse = errorsOf(shape, 0.16, V, A);
    const errors fine = errorsOf(shape, 0.08, V, A);
    EXPECT_LT(std::abs(fine.volume), 0.005);
    EXPECT_GT(coarse.volume/fine.volume, 3.2);
    EXPECT_GT(coarse.area/fine.area, 2.5);
}

TEST(solids, surfaceNodesLieOnTheSurface)
{
    const seededSolids ball = makeSolids
    (
        "s { type sphere; centre (0.1 0 0); radius 0.8; }", space(3, 0.1)
    );
    EXPECT_LT(farthest(ball.mesh, [](vector p)
    {
        return magnitude(p - vector{0.1, 0, 0}) - 0.8;
    }), 1e-10);
    const seededSolids rod = makeSolids
    (
        "s { type cylinder; point1 (0 0 -0.5); point2 (0 0 0.5);"
        " radius 0.8; }",
        space(3, 0.1)
    );
    EXPECT_LT(farthest(rod.mesh, [](vector p)
    {
        return std::max(std::hypot(p.x, p.y) - 0.8, std::abs(p.z) - 0.5);
    }), 1e-10);
}

TEST(solids, thinTubeOfTwoCells)
{
    const seededSolids s = makeSolids
    (
        "ring { type levelSet; expression \"abs(r - 0.5) - 0.05\"; }",
        space(2, 0.05)
    );
    EXPECT_EQ(s.reports[0].nOff, 0u);
    EXPECT_NEAR(s.reports[0].volume, pi*0.1, 1e-3);
    EXPECT_NEAR(s.reports[0].area, 2*pi, 0.01);
    EXPECT_LT(farthest(s.mesh, [](vector p)
    {
        return std::abs(std::hypot(p.x, p.y) - 0.5) - 0.05;
    }), 1e-10);
    expectSound(s.mesh, 0.0025);
}

TEST(solids, thinDisc)
{
    // One cell thick: its side is farther than its ends from many nodes
    const seededSolids s = makeSolids
    (
        "plate { type cylinder; point1 (0 0 0); point2 (0 0 0.03);"
        " radius 0.2; }",
        space(3, 0.05)
    );
    EXPECT_EQ(s.reports[0].nOff, 0u);
    EXPECT_NEAR(s.reports[0].volume/(pi*0.04*0.03), 1, 0.03);
    EXPECT_LT(farthest(s.mesh, [](vector p)
    {
        return std::max
        (
            std::hypot(p.x, p.y) - 0.2, std::abs(p.z - 0.015) - 0.015
        );
    }), 1e-10);
    expectSound(s.mesh, 0.05*0.05*0.03);
}

TEST(solids, goesAroundPeriodicBounds)
{
    const lattice l(3, 0.1, {-1, -1, 0}, {1, 1, 1}, {false, false, true});
    for (const char* ends : {"0 1", "-1 2"})
    {
        const std::string text = ends;
        const std::string first = text.substr(0, text.find(' '));
        const std::string last = text.substr(text.find(' ') + 1);
        const seededSolids s = makeSolids
        (
            "rod { type cylinder; point1 (0 0 " + first + "); point2 (0 0 "
          + last + "); radius 0.5; }",
            l
        );
        EXPECT_NEAR(s.reports[0].volume, pi/4, 0.005);
        EXPECT_NEAR(s.reports[0].area, pi, 0.005);    // no end faces
        EXPECT_EQ(s.mesh.size() % 10, 0u);
        expectSound(s.mesh, 1e-3);
        for (const vector& p : s.mesh.points)
        {
            EXPECT_TRUE(p.z >= 0 && p.z < 1);
        }
    }
    const seededSolids slab =
        makeSolids("s { type box; min (-1 -0.2 -9); max (1 0.2 9); }", l);
    EXPECT_EQ(slab.reports[0].nNodes, 21u*5*10);
    EXPECT_EQ(slab.reports[0].nCells, 20u*4*10);
    EXPECT_NEAR(slab.reports[0].volume, 0.8, 1e-13);
}

TEST(solids, partsAndVelocity)
{
    const seededSolids s = makeSolids
    (
        "b { type box; min (0 0 0); max (1 0.4 0.4); U (1 \"2*x\" 0); parts {"
        " clamp { type box; min (-1 -1 -1); max (1e-6 1 1); }"
        " skin { surface yes; type plane; point (0.75 0 0); normal (1 0 0); }"
        " tip { type box; min (0.99 -1 -1); max (2 1 1); } } }",
        space(3, 0.1)
    );
    const auto& parts = s.reports[0].parts;
    ASSERT_EQ(parts.size(), 3u);
    EXPECT_EQ(parts[0].second, 25u);
    EXPECT_EQ(parts[1].second, 2u*16);    // less those of the tip
    EXPECT_EQ(parts[2].second, 25u);
    for (std::size_t i = 0; i < s.mesh.size(); ++i)
    {
        EXPECT_NEAR(s.U[i].y, 2*s.mesh.points[i].x, 1e-15);
        EXPECT_EQ(s.mesh.part[i] == 0, s.mesh.points[i].x == 0);
    }
}

TEST(solids, refused)
{
    const lattice l = space(3, 0.1);
    const auto expect = [&](const char* solids, const char* message)
    {
        const std::string text = refusal(solids, l);
        EXPECT_NE(text.find(message), std::string::npos) << text;
    };
    const std::string one = "a { type box; min (0 0 0); max (0.5 0.5 0.5); ";
    expect((one + "spacing -1; }").c_str(), "is not a positive number");
    expect((one + "spacing 2; }").c_str(), "is too large");
    expect((one + "side inside; }").c_str(), "has a side");
    expect((one + "U (1 2); }").c_str(), "U has 2 values");
    expect((one + "parts { p { type box; min (2 2 2); max (3 3 3); } } }")
        .c_str(), "has no node");
    expect("a { type plane; point (0 0 0); normal (0 0 1); }",
        "encloses nothing");
    expect("a { type box; min (5 5 5); max (6 6 6); }", "outside the bounds");
    expect((one + "} b { type sphere; centre (0.5 0.5 0.5); radius 0.3; }")
        .c_str(), "Solids a and b overlap");
    EXPECT_EQ
    (
        refusal(one + "} b { type box; min (0.5 0 0); max (0.8 0.5 0.5); }", l),
        ""
    );
}
