#include "temporaryCase.H"

#include "case/domain.H"
#include "case/solidMesh.H"

#include <cmath>

using namespace gpuFsi;

namespace
{

//- Two cells of edge 1/3, the second around the periodic bound in x
class solidMeshTest
:
    public temporaryCase
{
public:

    solidMeshTest()
    {
        d.dimensions = 2;
        d.spacing = 1./3;
        d.lo = {0, 0, 0};
        d.hi = {1, 1, 0};
        d.periodic = {true, false, false};
        d.walls = {"tank", "left", "right"};
        d.solids = {"left", "right"};
        d.solidParts = {{"right", "clamp"}, {"left", "clamp"}};

        m.dimensions = 2;
        m.period = {1, 0, 0};
        m.names = d.solids;
        m.parts = {{1, "clamp"}, {0, "clamp"}};
        const double a = 1./3;
        m.points =
        {
            {0, 0, 0}, {a, 0, 0}, {0, a, 0}, {a, a, 0},
            {2*a, 0, 0}, {0, 0.5, 0}, {2*a, a, 0}, {0, 0.9, 0}
        };
        m.solid = {0, 0, 0, 0, 1, 1, 1, 1};
        m.part = {1, -1, 1, -1, -1, 0, -1, 0};
        m.cells =
        {
            {0, 1, 2, 3, -1, -1, -1, -1}, {4, 5, 6, 7, -1, -1, -1, -1}
        };
    }

    void write(const writeOptions& options = {}) const
    {
        d.write(path);
        m.write(path, options);
    }

    std::string error() const
    {
        return errorOf([&] { solidMesh().read(path); });
    }

    domain d;
    solidMesh m;
};

} // namespace

TEST_F(solidMeshTest, comesBackAsItWent)
{
    for (const writeOptions& options :
        {writeOptions{true, 6, false}, {false, 6, false}, {false, 6, true}})
    {
        std::filesystem::remove_all(path/"constant");
        write(options);
        solidMesh e;
        e.read(path);
        EXPECT_EQ(e.dimensions, 2);
        EXPECT_EQ(e.period.x, 1);
        EXPECT_EQ(e.period.y, 0);
        EXPECT_EQ(e.names, m.names);
        ASSERT_EQ(e.parts.size(), 2u);
        EXPECT_EQ(e.parts[0].solid, 1);
        EXPECT_EQ(e.parts[0].name, "clamp");
        EXPECT_EQ(e.parts[1].solid, 0);
        EXPECT_EQ(e.solid, m.solid);
        EXPECT_EQ(e.part, m.part);
        EXPECT_EQ(e.cells, m.cells);
        ASSERT_EQ(e.size(), m.size());
        for (std::size_t i = 0; i < m.size(); ++i)
        {
            EXPECT_EQ(e.points[i].x, m.points[i].x);
            EXPECT_EQ(e.points[i].y, m.points[i].y);
        }
    }
}

TEST_F(solidMeshTest, emptyWithoutSolids)
{
    d.solids.clear();
    d.solidParts.clear();
    d.write(path);
    solidMesh e = m;
    e.read(path);
    EXPECT_TRUE(e.empty());
    EXPECT_TRUE(e.names.empty());
    EXPECT_EQ(text("constant/domain").find("solid"), std::string::npos);
}

TEST_F(solidMeshTest, volumes)
{
    EXPECT_NEAR(m.volume(m.cells[0]), 1./9, 1e-16);
    // A trapezium of sides 1/3 and 0.4, 1/3 apart, through the bound
    EXPECT_NEAR(m.volume(m.cells[1]), (1./3 + 0.4)/6, 1e-16);
    solidMesh cube;
    for (int i = 0; i < 8; ++i)
    {
        cube.points.push_back({1e3 + (i & 1), 2.*(i >> 1 & 1), 3.*(i >> 2)});
    }
    const std::array<int, 8> cell{0, 1, 2, 3, 4, 5, 6, 7};
    EXPECT_NEAR(cube.volume(cell), 6, 1e-12);
    // A face warped at one corner: a quarter of that on average
    cube.points[7].x += 0.5;
    EXPECT_NEAR(cube.volume(cell), 6*(1 + 0.5/4), 1e-12);
}

TEST_F(solidMeshTest, rejects)
{
    EXPECT_TRUE(says(error(), "Run seedParticles first"));
    d.write(path);
    EXPECT_TRUE(says(error(), "There is no file"));
    m.solid[3] = 2;
    write();
    EXPECT_TRUE(says(error(), "solid holds 2, out of the range from 0 to 1"));
    m.solid[3] = 0;
    m.cells[1][2] = 8;
    write();
    EXPECT_TRUE(says(error(), "cells holds 8, out of the range"));
    std::swap(m.cells[0][0], m.cells[0][1]);
    m.cells[1][2] = 6;
    write();
    EXPECT_TRUE(says(error(), "Cell 0 has the volume"));
    d.solidParts = {{"middle", "clamp"}};
    d.write(path);
    EXPECT_TRUE(says(error(), "middle, which is no solid"));
}

TEST_F(solidMeshTest, truncated)
{
    write();
    const std::string whole = text("constant/solid/cells");
    put("constant/solid/cells", whole.substr(0, whole.size() - 9));
    EXPECT_NE(error(), "");
}
