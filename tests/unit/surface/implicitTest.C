#include "implicitSurface.H"
#include "shapeSurface.H"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

using namespace gpuFsi;

namespace
{

const double pi = std::acos(-1.0);

//- Every edge once in each direction: closed, and turned alike
bool closed(const shapeSurface& s)
{
    std::map<std::pair<int, int>, int> edges;
    for (const auto& t : s.triangles)
    {
        for (int i = 0; i < 3; ++i)
        {
            ++edges[{t[i], t[(i + 1) % 3]}];
        }
    }
    for (const auto& [edge, n] : edges)
    {
        const auto back = edges.find({edge.second, edge.first});
        if (n != 1 || back == edges.end())
        {
            return false;
        }
    }
    return !edges.empty();
}

//- Positive where normals point outwards
double volume(const shapeSurface& s)
{
    double sum = 0;
    for (const auto& t : s.triangles)
    {
        const auto& x = s.points;
        sum += dot(x[t[0]], cross(x[t[1]], x[t[2]]))/6;
    }
    return sum;
}

} // namespace

TEST(implicitSurface, sphere)
{
    const auto sphere = [](const vector& p)
    {
        return std::sqrt(dot(p, p)) - 1;
    };
    double error[2];
    for (const int fine : {0, 1})
    {
        const double edge = fine ? 0.1 : 0.2;
        const shapeSurface s =
            makeImplicit(sphere, {-1.3, -1.3, -1.3}, {1.3, 1.3, 1.3}, edge);
        EXPECT_TRUE(closed(s));
        error[fine] = 1 - volume(s)/(4*pi/3);
        for (const vector& p : s.points)
        {
            EXPECT_LT(std::abs(sphere(p)), 0.02*edge*std::sqrt(3.0));
        }
    }
    EXPECT_LT(std::abs(error[1]), 0.005);
    EXPECT_NEAR(error[0]/error[1], 4, 0.4);
}

TEST(implicitSurface, branchIsATubeBeforeItsOrigin)
{
    const shapeSurface s = makeBranch(1, 8, 0, 0, 24);
    EXPECT_TRUE(closed(s));
    double top = 0;
    for (const vector& p : s.points)
    {
        if (p.y < -0.1 && p.y > -8)
        {
            EXPECT_NEAR(std::hypot(p.x, p.z), 1, 0.01);
        }
        top = std::max(top, std::abs(p.z));
    }
    EXPECT_NEAR(top, 2.8, 0.01);    // four radii between axes, 0.8 wide
}

TEST(implicitSurface, wallIsOuterWithoutInner)
{
    const shapeSurface wall = makeBranch(1, 8, 0.1, 0.4, 16);
    const double outer = volume(makeBranch(1, 8, 0.5, 0, 16));
    const double inner = volume(makeBranch(1, 8, 0.1, 0, 16));
    EXPECT_TRUE(closed(wall));
    EXPECT_GT(inner, 8*pi);
    EXPECT_NEAR(volume(wall), outer - inner, 1e-9);
}
