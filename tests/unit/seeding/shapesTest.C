#include "fixture.H"

using namespace gpuFsi;

namespace
{

const double pi = std::acos(-1.0);

struct shapeCase
{
    const char* text;
    double area;
    double volume;
    double tolerance;
};

//- A bulk particle beside a wall is up to 1.5 h away from it: its lattice
//  neighbour is missing, nearer to the wall than h/2
void expectNoGaps(const lattice& l, const seededParticles& s)
{
    std::vector<char> bulk(l.size(), 0);
    const auto indexOf = [&](const vector& p)
    {
        return l.index
        (
            std::lround((p.x - l.lo().x)/l.h() - 0.5),
            std::lround((p.y - l.lo().y)/l.h() - 0.5),
            std::lround((p.z - l.lo().z)/l.h() - 0.5)
        );
    };
    for (const vector& p : s.bulk)
    {
        bulk[indexOf(p)] = 1;
    }
    double worst = 0;
    for (const vector& p : s.bulk)
    {
        bool beside = false;
        for (int axis = 0; axis < 3; ++axis)
        {
            for (const double step : {-l.h(), l.h()})
            {
                vector q = p;
                component(q, axis) += step;
                const double x = component(q, axis);
                beside = beside || x < component(l.lo(), axis)
                    || x > component(l.hi(), axis) || !bulk[indexOf(q)];
            }
        }
        worst = beside ? std::max(worst, nearestWall(s, p)) : worst;
    }
    EXPECT_LT(worst, 1.55*l.h());
}

} // namespace

TEST(shapes, areaVolumeAndNoGaps)
{
    const shapeCase cases[]
    {
        {
            "w { type sphere; centre (0.01 0.02 0.03); radius 0.9; }",
            4*pi*0.81, 4*pi/3*0.729, 0.01
        },
        {
            "w { type cylinder; point1 (0 -0.8 0); point2 (0 0.8 0);"
            " radius 0.9; }",
            2*pi*0.9*1.6 + 2*pi*0.81, pi*0.81*1.6, 0.01
        },
        {
            "w { type cylinder; point1 (-0.4 -0.5 0.1);"
            " point2 (0.5 0.4 0.2); radius 0.4; }",
            2*pi*0.4*std::sqrt(1.63) + 2*pi*0.16, pi*0.16*std::sqrt(1.63), 0.02
        },
        {
            "w { type box; min (-0.9 -0.8 -0.7); max (0.9 0.8 0.7); }",
            2*(1.8*1.6 + 1.8*1.4 + 1.6*1.4), 1.8*1.6*1.4, 1e-9
        }
    };
    const double h = 0.1;
    const lattice l(3, h, {-1, -1, -1}, {1, 1, 1}, {});
    for (const shapeCase& c : cases)
    {
        SCOPED_TRACE(c.text);
        const seededParticles s = seedFluid(l, makeRegions(c.text, 3, h));
        EXPECT_NEAR(totalArea(s), c.area, c.tolerance*c.area);
        EXPECT_TRUE(s.exactVolume);
        EXPECT_NEAR(s.volume, c.volume, 1e-12*c.volume);
        expectNoGaps(l, s);
        for (const vector& p : s.bulk)
        {
            EXPECT_GE(nearestWall(s, p), 0.5*h*(1 - 1e-6));
        }
    }
}


TEST(shapes, sphereSurfaceIsExact)
{
    const lattice l(3, 0.1, {-1, -1, -1}, {1, 1, 1}, {});
    const auto s = seedFluid
    (
        l, makeRegions("w { type sphere; centre (0 0 0); radius 0.9; }", 3, 0.1)
    );
    for (const wallParticle& w : s.walls)
    {
        EXPECT_NEAR(magnitude(w.position), 0.9, 1e-12);
        EXPECT_NEAR(dot(w.normal, w.position), -0.9, 1e-7);
    }
    for (std::size_t i = 1; i < s.walls.size(); ++i)
    {
        for (std::size_t j = 0; j < i; ++j)
        {
            EXPECT_GE
            (
                magnitude(s.walls[i].position - s.walls[j].position),
                0.07*(1 - 1e-9)
            );
        }
    }
}


TEST(shapes, wallsCoverTheirSurface)
{
    const double h = 0.1;
    const lattice l(3, h, {-1, -1, -1}, {1, 1, 1}, {});
    const auto ball = seedFluid
    (
        l, makeRegions("w { type sphere; centre (0 0 0); radius 0.9; }", 3, h)
    );
    const auto pipe = seedFluid(l, makeRegions(
        "w { type cylinder; point1 (0 -0.8 0); point2 (0 0.8 0);"
        " radius 0.9; }", 3, h));
    const auto cube = seedFluid(l, makeRegions(
        "w { type box; min (-0.93 -0.92 -0.91); max (0.9 0.9 0.9); }", 3, h));
    double most[3] = {};
    const int n = 3000;
    for (int i = 0; i < n; ++i)
    {
        const double z = 1 - (2*i + 1.0)/n;
        const double a = i*pi*(3 - std::sqrt(5.0));
        const double rho = std::sqrt(1 - z*z);
        const vector onBall{0.9*rho*std::cos(a), 0.9*rho*std::sin(a), 0.9*z};
        const vector onPipe{0.9*std::cos(a), 0.8*z, 0.9*std::sin(a)};
        const vector onCube{0.9, 0.9*z, 0.9*std::cos(a)};
        most[0] = std::max(most[0], nearestWall(ball, onBall));
        most[1] = std::max(most[1], nearestWall(pipe, onPipe));
        most[2] = std::max(most[2], nearestWall(cube, onCube));
    }
    EXPECT_LT(most[0], h);
    EXPECT_LT(most[1], h);
    EXPECT_LT(most[2], h);
}


TEST(shapes, cylinderAcrossPeriodicBoundsHasNoEnds)
{
    const lattice l(3, 0.1, {-1, -1, -1}, {1, 1, 1}, {false, true, false});
    const auto s = seedFluid(l, makeRegions(
        "w { type cylinder; point1 (0 -1 0); point2 (0 1 0);"
        " radius 0.9; }", 3, 0.1));
    EXPECT_NEAR(totalArea(s), 2*pi*0.9*2, 0.01*2*pi*0.9*2);
    for (const wallParticle& w : s.walls)
    {
        EXPECT_NEAR(w.normal.y, 0, 1e-9);
    }
    EXPECT_EQ(s.bulk.size() % 20, 0u);
}


TEST(shapes, levelSetAgreesWithShape)
{
    const lattice l(3, 0.1, {-1, -1, -1}, {1, 1, 1}, {});
    const auto shape = seedFluid
    (
        l, makeRegions("w { type sphere; centre (0 0 0); radius 0.9; }", 3, 0.1)
    );
    const auto level = seedFluid
    (
        l, makeRegions("w { type levelSet; expression \"r - 0.9\"; }", 3, 0.1)
    );
    ASSERT_EQ(shape.bulk.size(), level.bulk.size());
    ASSERT_EQ(shape.walls.size(), level.walls.size());
    EXPECT_NEAR(level.volume, shape.volume, 0.005*shape.volume);
    for (std::size_t i = 0; i < shape.walls.size(); ++i)
    {
        EXPECT_NEAR
        (
            magnitude(shape.walls[i].position - level.walls[i].position),
            0, 1e-11
        );
    }
}


TEST(shapes, boxAlignedWithLatticeIsExact)
{
    // 10 x 10 wall particles a face, one before each bulk particle
    const lattice l(3, 0.1, {0, 0, 0}, {1, 1, 1}, {});
    const auto s = seedFluid
    (
        l, makeRegions("w { type box; min (0 0 0); max (1 1 1); }", 3, 0.1)
    );
    EXPECT_EQ(s.bulk.size(), 1000u);
    ASSERT_EQ(s.walls.size(), 600u);
    for (const wallParticle& w : s.walls)
    {
        EXPECT_NEAR(w.area, 0.01, 1e-12);
    }
    EXPECT_EQ(s.openEnds, (std::array<std::size_t, 6>{}));
}


TEST(shapes, planesMeetWithOneWallEach)
{
    // A quarter of the plane between two walls, the rest open
    const lattice l(2, 0.1, {0, 0, 0}, {1, 1, 0}, {});
    const auto s = seedFluid(l, makeRegions(
        "left { type plane; point (0 0 0); normal (1 0 0); }"
        "floor { type plane; point (0 0 0); normal (0 2 0); }", 2, 0.1));
    EXPECT_EQ(s.bulk.size(), 100u);
    EXPECT_EQ(s.nWalls, (std::vector<std::size_t>{10, 10}));
    EXPECT_NEAR(s.volume, 1, 1e-12);
    EXPECT_EQ(s.openEnds, (std::array<std::size_t, 6>{0, 10, 0, 10, 0, 0}));
}


TEST(shapes, obstacleInPeriodicChannel)
{
    const double h = 0.05;
    const lattice l(2, h, {0, 0, 0}, {2, 1, 0}, {true, false, false});
    const auto s = seedFluid(l, makeRegions(
        "walls { type box; min (-1 0 -1); max (3 1 1); }"
        "disc { type sphere; centre (1 0.5 0); radius 0.2; side outside; }",
        2, h));
    EXPECT_NEAR(s.volume, 2 - pi*0.04, 0.003);
    EXPECT_NEAR(totalArea(s), 4 + 2*pi*0.2, 0.02);
    for (const wallParticle& w : s.walls)
    {
        if (w.patch == 1)
        {
            const vector out = w.position - vector{1, 0.5, 0};
            EXPECT_NEAR(dot(out, w.normal), 0.2, 1e-7);
        }
    }
    EXPECT_EQ(s.openEnds, (std::array<std::size_t, 6>{}));
}


TEST(shapes, thinPlateIsNotMissed)
{
    // Thinner than h and between lattice points
    const lattice l(3, 0.1, {0, 0, 0}, {1, 1, 1}, {true, true, true});
    const auto s = seedFluid(l, makeRegions(
        "plate { type box; min (-1 -1 0.48); max (2 2 0.52);"
        " side outside; }", 3, 0.1));
    EXPECT_EQ(s.walls.size(), 200u);
    EXPECT_NEAR(totalArea(s), 2, 1e-9);
    EXPECT_NEAR(s.volume, 0.96, 0.03);
}


TEST(shapes, seedingTwiceGivesTheSame)
{
    const lattice l(3, 0.1, {-1, -1, -1}, {1, 1, 1}, {});
    const char* text = "w { type sphere; centre (0 0 0); radius 0.9; }";
    auto a = seedFluid(l, makeRegions(text, 3, 0.1));
    auto b = seedFluid(l, makeRegions(text, 3, 0.1));
    displaceBulk(l, a, 0.2, 7);
    displaceBulk(l, b, 0.2, 7);
    double most = 0;
    double sum = 0;
    for (std::size_t i = 0; i < a.bulk.size(); ++i)
    {
        EXPECT_EQ(a.bulk[i].x, b.bulk[i].x);
        const double place = (a.bulk[i].x + 1)/0.1 - 0.5;
        const double moved = place - std::round(place);
        most = std::max(most, std::abs(moved));
        sum += moved;
    }
    EXPECT_LE(most, 0.2 + 1e-9);
    EXPECT_GT(most, 0.19);
    EXPECT_LT(std::abs(sum)/a.bulk.size(), 0.01);
}


TEST(shapes, nothingInsideIsAnError)
{
    const lattice l(3, 0.1, {0, 0, 0}, {1, 1, 1}, {});
    try
    {
        seedFluid(l, makeRegions(
            "ball { type sphere; centre (5 5 5); radius 1; }", 3, 0.1));
        FAIL();
    }
    catch (const userError& e)
    {
        const std::string text = e.what();
        EXPECT_NE(text.find("region ball: sphere"), std::string::npos) << text;
        EXPECT_NE(text.find("bounds (0 0 0)"), std::string::npos) << text;
    }
}


TEST(shapes, unknownTypeListsTheValid)
{
    try
    {
        makeRegions("w { type spheer; }", 3, 0.1);
        FAIL();
    }
    catch (const userError& e)
    {
        const std::string text = e.what();
        EXPECT_NE(text.find("did you mean sphere?"), std::string::npos);
        EXPECT_NE(text.find("levelSet"), std::string::npos);
    }
}


TEST(shapes, wallsOnLatticePointsHalveTheirCells)
{
    // Lattice points at 0, 0.1 .. 1: planes on the first and last of them
    const char* planes =
        "low { type plane; point (0 0 0); normal (1 0 0); }"
        "high { type plane; point (1 0 0); normal (-1 0 0); }"
        "floor { type plane; point (0 0 0); normal (0 1 0); }"
        "lid { type plane; point (0 1 0); normal (0 -1 0); }";
    const lattice across(2, 0.1, {-0.05, -0.05, 0}, {1.05, 1.05, 0}, {});
    EXPECT_NEAR
    (
        seedFluid(across, makeRegions(planes, 2, 0.1)).volume, 1, 1e-12
    );

    const lattice column
    (
        3, 0.1, {-0.05, -0.05, 0}, {1.05, 1.05, 0.5}, {false, false, true}
    );
    EXPECT_NEAR
    (
        seedFluid(column, makeRegions(planes, 3, 0.1)).volume, 0.5, 1e-12
    );
}
