#include "fixture.H"

#include "surface/checkSurface.H"
#include "surface/readSurface.H"

#include <limits>

using namespace gpuFsi;

namespace
{

std::string check(const triangleSurface& s)
{
    return messageOf([&] { checkSurface(s, "test.stl"); });
}

triangleSurface joined(triangleSurface a, const triangleSurface& b)
{
    const int shift = int(a.points.size());
    a.points.insert(a.points.end(), b.points.begin(), b.points.end());
    for (const auto& t : b.triangles)
    {
        a.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
    }
    return a;
}

triangleSurface flipped(triangleSurface s)
{
    for (auto& t : s.triangles)
    {
        std::swap(t[1], t[2]);
    }
    return s;
}

triangleSurface moved(triangleSurface s, const vector& by)
{
    for (vector& p : s.points)
    {
        p += by;
    }
    return s;
}

} // namespace

TEST(check, wholeShapesPass)
{
    EXPECT_EQ(check(plain(makeBox(2, 3))), "");
    EXPECT_EQ(check(plain(makeSphere(1, 20))), "");
    EXPECT_EQ(check(plain(makeCylinder(1, 2, 20))), "");
    EXPECT_EQ(check(plain(makeTorus(1, 0.3, 20))), "");
    EXPECT_EQ(check(bumpySphere(1, 40)), "");
    EXPECT_NEAR(plain(makeBox(2, 3)).volume(), 8, 1e-12);
}


TEST(check, holesAreCountedAndPlaced)
{
    triangleSurface s = plain(makeBox(2, 1));
    s.triangles.pop_back();
    const std::string text = check(s);
    expectIn("3 open edges", text);
    expectIn("edge (", text);
    expectIn("Close the holes", text);
}


TEST(check, threeTrianglesAtAnEdge)
{
    triangleSurface s = plain(makeBox(2, 1));
    s.points.push_back({5, 5, 5});
    s.triangles.push_back({s.triangles[0][0], s.triangles[0][1], 8});
    expectIn("1 non-manifold edges", check(s));
}


TEST(check, oneTriangleTurned)
{
    triangleSurface s = plain(makeBox(2, 1));
    std::swap(s.triangles[4][0], s.triangles[4][1]);
    expectIn("3 edges whose two triangles face opposite ways", check(s));
}


TEST(check, insideOut)
{
    const std::string text = check(flipped(plain(makeBox(2, 1))));
    expectIn("1 parts are inside out", text);
    expectIn("volume -8", text);
}


TEST(check, cavityFacesInwards)
{
    const triangleSurface outer = plain(makeBox(2, 1));
    const triangleSurface inner = plain(makeBox(1, 1));
    EXPECT_EQ(check(joined(outer, flipped(inner))), "");
    expectIn("cavity", check(joined(outer, inner)));
    EXPECT_EQ(check(joined(outer, moved(inner, {5, 0, 0}))), "");
}


TEST(check, overlappingParts)
{
    const triangleSurface a = plain(makeBox(2, 1));
    const std::string text = check(joined(a, moved(a, {0.5, 0.4, 0.3})));
    expectIn("pairs of triangles cut each other", text);
    expectIn("boolean union", text);
}


TEST(read, allFormatsGiveTheSame)
{
    const shapeSurface shape = makeTorus(1, 0.25, 16);
    for (const char* name : {"a.stl", "b.stl", "c.obj", "d.ply", "e.off"})
    {
        SCOPED_TRACE(name);
        const auto file = testFolder()/name;
        writeShape(file, shape, name[0] == 'b');
        readReport report;
        const triangleSurface s = readSurface(file, 0.5, {}, report);
        EXPECT_EQ(s.triangles.size(), shape.triangles.size());
        EXPECT_EQ(s.points.size(), shape.points.size());
        EXPECT_EQ(report.nDegenerate, 0u);
        EXPECT_NEAR(s.volume(), plain(shape).volume()/8, 1e-6);
        EXPECT_EQ(check(s), "");
    }
}


TEST(read, badFilesAreNamed)
{
    const auto read = [](const std::filesystem::path& file)
    {
        return messageOf([&]
        {
            readReport report;
            readSurface(file, 1, {"dict", 7, 7}, report);
        });
    };
    expectIn("Cannot find surface file", read(testFolder()/"none.stl"));
    expectIn("dict at line 7", read(testFolder()/"none.stl"));
    expectIn("is empty", read(writeText("empty.stl", "")));
    expectIn("unknown ending '.step'", read(writeText("a.step", "x")));
    expectIn("Cannot read", read(writeText("a.off", "OFF\n3 1 0\n0 0 0\n")));
    expectIn("Cannot read", read(writeText("a.obj", "f 1 2 3\n")));

    const auto file = testFolder()/"whole.stl";
    writeShape(file, makeBox(1, 2), true);
    const auto size = std::filesystem::file_size(file);
    std::filesystem::resize_file(file, size - 30);
    expectIn("cut short", read(file));
    std::filesystem::resize_file(file, 40);
    expectIn("cut short", read(file));

    writeShape(file, makeBox(1, 2), false);
    std::filesystem::resize_file
    (
        file, std::filesystem::file_size(file)/2
    );
    expectIn("no endsolid", read(file));

    shapeSurface broken = makeBox(1, 1);
    broken.points[3].y = std::numeric_limits<double>::quiet_NaN();
    writeShape(file, broken, true);
    expectIn("nan", read(file));

    writeShape(testFolder()/"nan.obj", broken, false);
    expectIn("coordinate nan", read(testFolder()/"nan.obj"));
    expectIn("at line 4", read(testFolder()/"nan.obj"));
}


TEST(read, trianglesWithoutAreaAreDropped)
{
    shapeSurface s = makeBox(1, 1);
    s.triangles.push_back({0, 1, 0});
    const auto file = testFolder()/"flat.off";
    writeShape(file, s, false);
    readReport report;
    EXPECT_EQ(readSurface(file, 1, {}, report).triangles.size(), 12u);
    EXPECT_EQ(report.nDegenerate, 1u);
}
