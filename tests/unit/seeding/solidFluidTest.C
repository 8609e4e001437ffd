#include "solidFixture.H"

using namespace gpuFsi;

namespace
{

const char* ball = "type sphere; centre (0.03 0.02 0.01); radius 0.45;";

seededParticles withRegions(const lattice& l, regionList& regions)
{
    return seedFluid(l, regions);
}

seededParticles withSolids
(
    const lattice& l,
    const std::string& walls,
    seededSolids& solids
)
{
    regionList regions = makeRegions(walls, l.dimensions(), l.h());
    for (auto& r : solids.regions)
    {
        regions.push_back(std::move(r));
    }
    return seedFluid(l, regions);
}

} // namespace

TEST(solidsInFluid, fluidIsThatAroundTheShape)
{
    const lattice l(3, 0.1, {-1, -1, -1}, {1, 1, 1}, {true, true, true});
    seededSolids solids = makeSolids(std::string("s { ") + ball + " }", l);
    const seededParticles s = withSolids(l, "", solids);

    regionList same =
        makeRegions(std::string("s { side outside; ") + ball + " }", 3, 0.1);
    const seededParticles expected = withRegions(l, same);
    ASSERT_EQ(s.bulk.size(), expected.bulk.size());
    EXPECT_EQ(s.volume, expected.volume);

    const solidReport& r = solids.reports[0];
    EXPECT_EQ(s.walls.size(), r.nSurface);
    EXPECT_NEAR(totalArea(s), r.area, 1e-12);
    vector sum{0, 0, 0};
    for (const wallParticle& w : s.walls)
    {
        ASSERT_GE(w.node, 0);
        const vector away = w.position - vector{0.03, 0.02, 0.01};
        EXPECT_LT(magnitude(w.position - solids.mesh.points[w.node]), 1e-15);
        EXPECT_GT(dot(w.normal, away), 0.99*0.45*0.97);
        sum += w.area*w.normal;
    }
    EXPECT_LT(magnitude(sum), 0.01*r.area);
    for (const vector& p : s.bulk)
    {
        EXPECT_GE(magnitude(p - vector{0.03, 0.02, 0.01}), 0.4999999);
    }
}

TEST(solidsInFluid, shapeThatEndsInAPeriodicBound)
{
    const lattice l(3, 0.1, {-1, -1, 0}, {1, 1, 1}, {true, true, true});
    seededSolids solids = makeSolids
    (
        "rod { type cylinder; point1 (0 0 0); point2 (0 0 1); radius 0.5; }", l
    );
    const seededParticles s = withSolids(l, "", solids);
    EXPECT_NEAR(s.volume, 4 - std::acos(-1.0)/4, 0.02);
    EXPECT_EQ(s.walls.size(), solids.reports[0].nSurface);
    EXPECT_NEAR(totalArea(s), std::acos(-1.0), 0.02);
}

TEST(solidsInFluid, nodesWithoutFluidAreNoWalls)
{
    // A beam that goes 0.3 into a wall, and a block upon its end
    const lattice l(2, 0.05, {-0.5, -1, 0}, {1.5, 1, 0}, {});
    seededSolids solids = makeSolids
    (
        "beam { type box; min (-0.3 -0.1 0); max (0.7 0.1 0); }"
        "block { type box; min (0.7 -0.1 0); max (1 0.1 0); }",
        l
    );
    const seededParticles s = withSolids
    (
        l,
        "wall { type box; min (0 -1 0); max (1.5 1 0); }",
        solids
    );
    for (const wallParticle& w : s.walls)
    {
        if (w.node >= 0)
        {
            EXPECT_GT(w.position.x, -0.075001);
            const bool between =
                w.position.x == 0.7 && std::abs(w.position.y) < 0.02;
            EXPECT_FALSE(between);
        }
    }
}

TEST(solidsInFluid, regionsGiveWayToNodes)
{
    const lattice l(2, 0.05, {0, 0, 0}, {1, 1, 0}, {});
    seededSolids solids = makeSolids
    (
        "s { type box; min (0.31 0.02 0); max (0.69 0.4 0); spacing 0.01; }", l
    );
    const std::size_t nSurface = solids.reports[0].nSurface;
    const seededParticles s = withSolids
    (
        l, "tank { type box; min (0 0 0); max (1 1 0); }", solids
    );
    std::size_t nNodes = 0;
    for (const wallParticle& w : s.walls)
    {
        nNodes += w.node >= 0;
        for (const wallParticle& v : s.walls)
        {
            if (w.node >= 0 && v.node < 0)
            {
                EXPECT_GE(magnitude(w.position - v.position), 0.5*0.05);
            }
        }
    }
    EXPECT_GT(nNodes, 0.7*nSurface);
    EXPECT_LE(nNodes, nSurface);
}

TEST(solidsInFluid, allOfARoundLumenIsWet)
{
    const lattice l(3, 0.2, {-1.6, -1.6, 0}, {1.6, 1.6, 0.6}, {0, 0, 1});
    seededSolids solids = makeSolids
    (
        "tube { spacing 0.15; type levelSet; expression"
        " \"(sqrt(x^2 + y^2) - 1)*(sqrt(x^2 + y^2) - 1.4)\"; }",
        l
    );
    const seededParticles s = withSolids
    (
        l,
        "lumen { type cylinder; point1 (0 0 -1); point2 (0 0 2); radius 1.2; }",
        solids
    );
    std::size_t inner = 0, wet = 0;
    for (const vector& p : solids.mesh.points)
    {
        inner += std::hypot(p.x, p.y) < 1.001;
    }
    for (const wallParticle& w : s.walls)
    {
        EXPECT_LT(std::hypot(w.position.x, w.position.y), 1.001);
        wet += w.node >= 0;
    }
    EXPECT_GT(inner, 100u);
    EXPECT_EQ(wet, inner);
}
