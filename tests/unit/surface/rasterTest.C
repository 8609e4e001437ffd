#include "fixture.H"

#include "surface/lineRaster.H"
#include "surface/nearTriangle.H"
#include "surface/polygonMesh.H"

#include <algorithm>
#include <chrono>
#include <random>
#include <tuple>

using namespace gpuFsi;

namespace
{

const std::array<bool, 3> none{};

//- Lattice points on the surface are close, and may count on either side
void expectAgreement
(
    const lattice& l,
    const triangleSurface& s,
    const regionTrace& trace,
    int nSamples
)
{
    std::mt19937_64 random(3);
    std::vector<std::size_t> chosen;
    std::vector<vector> points;
    for (int i = 0; i < nSamples; ++i)
    {
        chosen.push_back
        (
            nSamples < int(l.size()) ? random() % l.size() : i % l.size()
        );
        points.push_back(l.point(chosen.back()));
    }
    const std::vector<int> sides = sideOf(s, points);
    int wrong = 0;
    int nInside = 0;
    for (int i = 0; i < nSamples; ++i)
    {
        if (sides[i] == 0)
        {
            EXPECT_TRUE(trace.close[chosen[i]]);
            continue;
        }
        nInside += sides[i] > 0;
        wrong += (sides[i] > 0) != bool(trace.inside[chosen[i]]);
    }
    EXPECT_EQ(wrong, 0) << nSamples << " points, " << nInside << " inside";
    EXPECT_GT(nInside, nSamples/20);
}

//- Each line's crossings alternate, and sum to the surface's area
void expectOrder(const lattice& l, const regionTrace& trace)
{
    std::vector<lineCrossing> sorted = trace.crossings;
    std::stable_sort
    (
        sorted.begin(),
        sorted.end(),
        [](const lineCrossing& a, const lineCrossing& b)
        {
            return std::tie(a.axis, a.line, a.t)
                < std::tie(b.axis, b.line, b.t);
        }
    );
    std::size_t nPairs = 0;
    for (std::size_t i = 0; i + 1 < sorted.size(); i += 2)
    {
        nPairs += sorted[i].axis == sorted[i + 1].axis
            && sorted[i].line == sorted[i + 1].line
            && sorted[i].enters != sorted[i + 1].enters;
    }
    EXPECT_EQ(2*nPairs, sorted.size()) << l.size();
}

} // namespace

TEST(raster, equalsCgalOn100000Points)
{
    const triangleSurface s = bumpySphere(1, 320);
    EXPECT_GT(s.triangles.size(), 100000u);
    const lattice l(3, 2.5/80, {-1.25, -1.25, -1.25}, {1.25, 1.25, 1.25}, none);
    const regionTrace trace = traceSurface(l, s, true);
    expectAgreement(l, s, trace, 100000);
    expectOrder(l, trace);
}


TEST(raster, torusOfCoarseTriangles)
{
    const triangleSurface s = plain(makeTorus(0.8, 0.35, 12));
    const lattice l(3, 2.5/50, {-1.25, -1.25, -1.25}, {1.25, 1.25, 1.25}, none);
    expectAgreement(l, s, traceSurface(l, s, true), 100000);
}


TEST(raster, degenerateLinesEverywhere)
{
    // Lattice lines in the faces, through edges and corners of a cube
    for (const int n : {1, 2, 4, 8})
    {
        const triangleSurface s = plain(makeBox(2, n));
        const lattice l
        (
            3, 0.25, {-1.625, -1.625, -1.625}, {1.625, 1.625, 1.625}, none
        );
        const regionTrace trace = traceSurface(l, s, true);
        expectAgreement(l, s, trace, int(l.size()));
        expectOrder(l, trace);
    }
}


TEST(raster, latticeThroughEveryCornerOfACylinder)
{
    // Corners rounded to the lattice: lines meet edges and corners
    triangleSurface s = plain(makeCylinder(1, 2, 24));
    for (vector& p : s.points)
    {
        p = {std::round(8*p.x)/8, std::round(8*p.y)/8, std::round(8*p.z)/8};
    }
    const lattice l
    (
        3, 0.125, {-1.3125, -1.3125, -1.3125}, {1.3125, 1.3125, 1.3125}, none
    );
    expectAgreement(l, s, traceSurface(l, s, true), int(l.size()));
}


TEST(raster, closeIsNearerThanHalfASpacing)
{
    const triangleSurface s = bumpySphere(1, 24);
    const lattice l(3, 0.1, {-1.25, -1.25, -1.25}, {1.25, 1.25, 1.25}, none);
    const regionTrace trace = traceSurface(l, s, true);
    for (std::size_t i = 0; i < l.size(); i += 7)
    {
        double least = 1;
        for (std::size_t t = 0; t < s.triangles.size(); ++t)
        {
            least = std::min
            (
                least,
                distanceSquared
                (
                    l.point(i), s.corner(t, 0), s.corner(t, 1), s.corner(t, 2)
                )
            );
        }
        EXPECT_EQ(bool(trace.close[i]), least < std::pow(0.05*(1 - 1e-3), 2));
    }
}


TEST(raster, tenMillionInsideTestsInTime)
{
    const triangleSurface s = bumpySphere(1, 320);
    const lattice l
    (
        3, 2.5/215, {-1.25, -1.25, -1.25}, {1.25, 1.25, 1.25}, none
    );
    const auto start = std::chrono::steady_clock::now();
    const regionTrace trace = traceSurface(l, s, true);
    const std::chrono::duration<double> seconds =
        std::chrono::steady_clock::now() - start;
    std::size_t nInside = 0;
    for (const auto i : trace.inside)
    {
        nInside += i;
    }
    EXPECT_NEAR(nInside*std::pow(l.h(), 3), s.volume(), 1e-3*s.volume());
    EXPECT_LT(seconds.count(), 20);
    std::printf("    %zu inside tests in %.2f s\n", l.size(), seconds.count());
}
