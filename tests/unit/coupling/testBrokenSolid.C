// Solids that have come to what none may: cells through themselves.

#include "coupling/brokenSolid.H"

#include <gtest/gtest.h>

#include <cmath>

using namespace gpuFsi;

namespace
{

//- A square or cube of side 1, the first corner at the origin
solidMesh oneCell(int dimensions)
{
    solidMesh m;
    m.dimensions = dimensions;
    m.names = {"bar"};
    const int n = 1 << dimensions;
    m.cells.push_back({0, 1, 2, 3, -1, -1, -1, -1});
    for (int a = 0; a < n; ++a)
    {
        m.points.push_back({double(a & 1), double(a >> 1 & 1), double(a >> 2)});
        m.cells[0][a] = a;
    }
    m.solid.assign(n, 0);
    m.part.assign(n, -1);
    return m;
}

struct scene
{
    solidMesh mesh;
    solidProperties properties;
    std::vector<vector> x, U;

    explicit scene(int dimensions)
    :
        mesh(oneCell(dimensions)),
        x(mesh.points),
        U(mesh.points.size(), vector{0, 0, 0})
    {
        properties.materials.resize(1);
    }

    std::string say() const
    {
        return describeBrokenSolid
        (
            mesh, watchedCells(mesh, properties), x, U
        );
    }
};

} // namespace


TEST(brokenSolid, spansAreThoseOfEachCorner)
{
    const solidMesh square = oneCell(2), cube = oneCell(3);
    for (int a = 0; a < 8; ++a)
    {
        EXPECT_EQ(spannedAt<3>(cube.points.data(), a), 1);
        if (a < 4)
        {
            EXPECT_EQ(spannedAt<2>(square.points.data(), a), 1);
        }
    }
}


TEST(brokenSolid, soundOnesAreNot)
{
    for (const int D : {2, 3})
    {
        scene s(D);
        EXPECT_EQ(s.say(), "");
        for (vector& x : s.x)
        {
            // Sheared, turned, squeezed
            x = vector{0.1*x.y + 5, -x.x + 3*x.y, 0.01*x.z};
        }
        EXPECT_EQ(s.say(), "");
    }
}


TEST(brokenSolid, aCellThroughItselfIs)
{
    for (const int D : {2, 3})
    {
        scene s(D);
        for (std::size_t i = 1; i < s.x.size(); i += 2)
        {
            s.x[i].x = -0.1;
        }
        EXPECT_EQ
        (
            s.say(), "the cell at particle 0 of solid bar, unstrained at "
            "(0 0 0), is turned over"
        );
        // One that may tear may do so
        s.properties.materials[0].breakStrain = 0.1;
        EXPECT_EQ(s.say(), "");
    }
}


TEST(brokenSolid, aCornerThroughItsCellIs)
{
    for (const int D : {2, 3})
    {
        scene s(D);
        s.x[0] = vector{0.6, 0.6, D == 3 ? 0.6 : 0.0};
        EXPECT_NE(s.say(), "") << D;
        // Unless it was seeded so
        s.mesh.points[0] = s.x[0];
        EXPECT_EQ(s.say(), "") << D;
    }
}


TEST(brokenSolid, lostParticlesAreNamedFirst)
{
    scene s(2);
    s.x[1].x = -1;
    s.U[3].y = NAN;
    EXPECT_EQ
    (
        s.say(),
        "particle 3 of solid bar, unstrained at (1 1 0), is nowhere"
    );
}
