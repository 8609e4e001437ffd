#include "shapeSurface.H"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace gpuFsi
{

static const double pi = std::acos(-1.0);


namespace
{

//- Square grids of triangles with points that equal coordinates share
class builder
{
public:

    int point(const vector& p)
    {
        const auto key = std::make_tuple(p.x, p.y, p.z);
        const auto found = number_.find(key);
        if (found != number_.end())
        {
            return found->second;
        }
        number_[key] = int(result.points.size());
        result.points.push_back(p);
        return number_[key];
    }

    void triangle(int a, int b, int c)
    {
        if (a != b && b != c && c != a)
        {
            result.triangles.push_back({a, b, c});
        }
    }

    void quad(int a, int b, int c, int d)
    {
        triangle(a, b, c);
        triangle(a, c, d);
    }

    shapeSurface result;

private:

    std::map<std::tuple<double, double, double>, int> number_;
};

//- A profile (radius, y), from bottom to top, turned about the y axis
shapeSurface revolve(const std::vector<std::array<double, 2>>& profile, int n)
{
    builder b;
    std::vector<std::vector<int>> rings;
    for (const auto& [radius, y] : profile)
    {
        std::vector<int> ring;
        for (int i = 0; i < n; ++i)
        {
            const double angle = 2*pi*i/n;
            ring.push_back
            (
                b.point
                ({
                    radius*std::cos(angle), y, -radius*std::sin(angle)
                })
            );
        }
        rings.push_back(ring);
    }
    for (std::size_t r = 1; r < rings.size(); ++r)
    {
        for (int i = 0; i < n; ++i)
        {
            const int next = (i + 1) % n;
            b.quad
            (
                rings[r - 1][i], rings[r - 1][next], rings[r][next], rings[r][i]
            );
        }
    }
    return b.result;
}

} // namespace

shapeSurface makeBox(double length, int n)
{
    builder b;
    const auto at = [&](int i) { return length*(double(i)/n - 0.5); };
    for (int axis = 0; axis < 3; ++axis)
    {
        for (const int end : {0, n})
        {
            const auto corner = [&](int i, int j)
            {
                std::array<double, 3> x;
                x[axis] = at(end);
                x[(axis + 1) % 3] = at(i);
                x[(axis + 2) % 3] = at(j);
                return b.point({x[0], x[1], x[2]});
            };
            for (int i = 0; i < n; ++i)
            {
                for (int j = 0; j < n; ++j)
                {
                    const int c00 = corner(i, j);
                    const int c10 = corner(i + 1, j);
                    const int c11 = corner(i + 1, j + 1);
                    const int c01 = corner(i, j + 1);
                    if (end)
                    {
                        b.quad(c00, c10, c11, c01);
                    }
                    else
                    {
                        b.quad(c00, c01, c11, c10);
                    }
                }
            }
        }
    }
    return b.result;
}


shapeSurface makeSphere(double radius, int n)
{
    std::vector<std::array<double, 2>> profile{{0, -radius}};
    const int nRings = std::max(2, n/2);
    for (int i = 1; i < nRings; ++i)
    {
        const double angle = pi*(double(i)/nRings - 0.5);
        profile.push_back({radius*std::cos(angle), radius*std::sin(angle)});
    }
    profile.push_back({0, radius});
    return revolve(profile, n);
}


shapeSurface makeCylinder(double radius, double length, int n)
{
    const int nAlong =
        std::max(1, int(std::lround(length*n/(2*pi*radius))));
    std::vector<std::array<double, 2>> profile{{0, -0.5*length}};
    for (int i = 0; i <= nAlong; ++i)
    {
        profile.push_back({radius, length*(double(i)/nAlong - 0.5)});
    }
    profile.push_back({0, 0.5*length});
    return revolve(profile, n);
}


shapeSurface makeTorus(double radius, double tube, int n)
{
    std::vector<std::array<double, 2>> profile;
    for (int i = 0; i < n; ++i)
    {
        const double angle = 2*pi*i/n;
        profile.push_back
        ({
            radius + tube*std::cos(angle), tube*std::sin(angle)
        });
    }
    profile.push_back(profile.front());
    return revolve(profile, n);
}

} // namespace gpuFsi
