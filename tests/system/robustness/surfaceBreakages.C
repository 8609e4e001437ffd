#include "breakage.H"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <sstream>

namespace
{

constexpr const char* file = "constant/triSurface/part.stl";

using point = std::array<double, 3>;
using triangle = std::array<point, 3>;

//- Cube of edge 2a about a centre, normals outwards
std::vector<triangle> cube(double a, const point& centre = {0, 0, 0})
{
    std::vector<triangle> list;
    for (int axis = 0; axis < 3; ++axis)
    {
        for (int sign : {-1, 1})
        {
            const auto corner = [&](int u, int v)
            {
                point p{};
                p[axis] = centre[axis] + sign*a;
                p[(axis + 1) % 3] = centre[(axis + 1) % 3] + sign*u*a;
                p[(axis + 2) % 3] = centre[(axis + 2) % 3] + v*a;
                return p;
            };
            list.push_back({corner(-1, -1), corner(1, -1), corner(1, 1)});
            list.push_back({corner(-1, -1), corner(1, 1), corner(-1, 1)});
        }
    }
    return list;
}

std::string asciiStl(const std::vector<triangle>& triangles)
{
    std::ostringstream out;
    out << "solid part\n";
    for (const triangle& t : triangles)
    {
        out << "facet normal 0 0 0\nouter loop\n";
        for (const point& p : t)
        {
            out << "vertex " << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
        }
        out << "endloop\nendfacet\n";
    }
    out << "endsolid part\n";
    return out.str();
}

std::string binaryStl(const std::vector<triangle>& triangles)
{
    std::string bytes(80, ' ');
    const auto append = [&](const auto& value)
    {
        bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
    };
    append(std::uint32_t(triangles.size()));
    for (const triangle& t : triangles)
    {
        append(std::array<float, 3>{});
        for (const point& p : t)
        {
            append
            (
                std::array<float, 3>{float(p[0]), float(p[1]), float(p[2])}
            );
        }
        append(std::uint16_t(0));
    }
    return bytes;
}

//- The region replaced by one of the surface, whose file holds these bytes
damage surface(const std::string& bytes, const char* name = file)
{
    return [=](systemCase& c)
    {
        c.set
        (
            "system/seedParticlesDict",
            "type",
            "surface; file \"" + std::string(name) + "\""
        );
        if (!bytes.empty())
        {
            c.write(name, bytes);
        }
    };
}

std::vector<triangle> without(std::vector<triangle> all, std::size_t i)
{
    all.erase(all.begin() + long(i));
    return all;
}

std::vector<triangle> joined
(
    std::vector<triangle> a,
    const std::vector<triangle>& b
)
{
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

std::vector<triangle> turned(std::vector<triangle> all, std::size_t from = 0)
{
    for (std::size_t i = from; i < all.size(); ++i)
    {
        std::swap(all[i][0], all[i][1]);
    }
    return all;
}

std::string cut(const std::string& bytes, std::size_t n)
{
    return bytes.substr(0, bytes.size() - n);
}

std::vector<breakage> surfaces()
{
    constexpr app seed = app::seedParticles;
    const auto sound = cube(5);
    std::string withNan = asciiStl(sound);
    withNan.replace(withNan.find("vertex -5"), 9, "vertex nan");
    return
    {
        {"open", seed, surface(asciiStl(without(sound, 4))),
            "3 open edges", "Close the holes"},
        {"open, binary", seed, surface(binaryStl(without(sound, 0))),
            "edge (-5 -5 -5)", "Close the holes"},
        {"two cubes that cut", seed,
            surface(binaryStl(joined(sound, cube(5, {3, 2, 1})))),
            "triangles cut each other", "boolean union"},
        {"inside out", seed, surface(binaryStl(turned(sound))),
            "inside out", "Flip the normals"},
        {"one triangle turned", seed, surface(asciiStl(turned(sound, 11))),
            "face opposite ways", "Make the normals consistent"},
        {"triangle twice", seed,
            surface(asciiStl(joined(sound, {sound[0]}))),
            "part.stl", "double or inner triangles"},
        {"cut short, binary", seed, surface(cut(binaryStl(sound), 70)),
            "is cut short: 614 bytes, but 12 triangles take 684",
            "Export the surface again"},
        {"cut short, ascii", seed, surface(cut(asciiStl(sound), 100)),
            "is cut short: it has no endsolid", "Export the surface again"},
        {"header only", seed, surface(std::string(60, ' ')),
            "is cut short", "Export the surface again"},
        {"coordinate not a number", seed, surface(withNan),
            "has the coordinate nan", "must be finite"},
        {"unknown ending", seed,
            surface(binaryStl(sound), "constant/triSurface/part.stp"),
            "unknown ending '.stp'", "Valid endings are .stl"},
        {"OBJ of garbage", seed,
            surface("this is no surface\n", "constant/triSurface/part.obj"),
            "Cannot read surface file", "Export the surface again"},
        {"face of missing points", seed,
            surface("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n",
                "constant/triSurface/part.obj"),
            "part.obj", "Export the surface again"},
        {"missing", seed, surface(""),
            "Cannot find surface file", "constant/triSurface"},
    };
}

} // namespace


TEST(badInput, surfaces)
{
    const systemCase& c = soundCase();
    systemCase whole(c);
    surface(binaryStl(cube(5)))(whole);
    const outcome o = whole.run(app::seedParticles);
    if (o.says("This build reads no surface meshes"))
    {
        GTEST_SKIP() << "built without CGAL";
    }
    ASSERT_EQ(o.code, 0) << o.err;
    for (const breakage& b : surfaces())
    {
        expectRefused(b);
    }
}
