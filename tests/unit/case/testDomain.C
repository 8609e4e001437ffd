#include "temporaryCase.H"

#include "case/domain.H"

using namespace gpuFsi;

namespace
{

using domainTest = temporaryCase;

domain sample()
{
    domain d;
    d.dimensions = 3;
    d.spacing = 0.1;
    d.lo = {-1./3, 0, 0};
    d.hi = {1, 2, 1e-3};
    d.periodic = {true, false, true};
    d.volume = 1./7;
    d.walls = {"floor", "lid", "wall (1)"};
    return d;
}

} // namespace

TEST_F(domainTest, comesBackAsItWent)
{
    const domain d = sample();
    d.write(path);
    const domain e = domain::read(path);
    EXPECT_EQ(e.dimensions, 3);
    EXPECT_EQ(e.spacing, 0.1);
    EXPECT_EQ(e.lo.x, -1./3);
    EXPECT_EQ(e.hi.z, 1e-3);
    EXPECT_EQ(e.periodic, d.periodic);
    EXPECT_EQ(e.volume, 1./7);
    EXPECT_EQ(e.walls, d.walls);
}

TEST_F(domainTest, withoutWalls)
{
    domain d = sample();
    d.walls.clear();
    d.write(path);
    EXPECT_TRUE(domain::read(path).walls.empty());
}

TEST_F(domainTest, rejects)
{
    const auto error = [&] { return errorOf([&] { domain::read(path); }); };
    EXPECT_TRUE(says(error(), "Run seedParticles first"));
    domain d = sample();
    d.spacing = -1;
    d.write(path);
    EXPECT_TRUE(says(error(), "spacing must be positive, found -1"));
    d = sample();
    d.hi.y = -1;
    d.write(path);
    EXPECT_TRUE(says(error(), "must be above lo"));
    EXPECT_TRUE(says(error(), "constant/domain"));
    d = sample();
    d.dimensions = 4;
    d.write(path);
    EXPECT_TRUE(says(error(), "2 or 3, found 4"));
}
