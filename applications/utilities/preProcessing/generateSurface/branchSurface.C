#include "implicitSurface.H"

#include <algorithm>
#include <cmath>

namespace gpuFsi
{

namespace
{

const double pi = std::acos(-1.0);

//- A round tube about a line of points
struct branchTube
{
    std::vector<vector> line;
    double radius;

    //- Distance from its surface, negative inside
    double operator()(const vector& p) const
    {
        double least = HUGE_VAL;
        for (std::size_t i = 1; i < line.size(); ++i)
        {
            const vector along = line[i] - line[i - 1];
            const vector d = p - line[i - 1];
            const double t =
                std::clamp(dot(d, along)/dot(along, along), 0.0, 1.0);
            const vector off = d - t*along;
            least = std::min(least, dot(off, off));
        }
        return std::sqrt(least) - radius;
    }
};


//- The lesser of two, rounded where they differ by less than width
double smoothMin(double a, double b, double width)
{
    const double t = std::max(width - std::abs(a - b), 0.0)/width;
    return std::min(a, b) - 0.25*width*t*t;
}


//- From the origin sideways in z within four radii of y, then along y
branchTube daughter(double radius, double length, double side)
{
    branchTube tube{{}, 0.8*radius};
    constexpr int n = 24;
    const double bend = 5*radius;
    for (int i = 0; i <= n; ++i)
    {
        const double t = double(i)/n;
        tube.line.push_back
        ({
            0, t*bend, side*radius*(1 - std::cos(pi*t))
        });
    }
    tube.line.push_back({0, std::max(length, 1.01*bend), side*2*radius});
    return tube;
}


void append(shapeSurface& to, const shapeSurface& other, bool turned)
{
    const int first = int(to.points.size());
    to.points.insert(to.points.end(), other.points.begin(), other.points.end());
    for (std::array<int, 3> t : other.triangles)
    {
        if (turned)
        {
            std::swap(t[1], t[2]);
        }
        to.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    }
}

} // namespace

shapeSurface makeBranch
(
    double radius,
    double length,
    double offset,
    double wall,
    int n
)
{
    const branchTube parent{{{0, -length, 0}, {0, 0, 0}}, radius};
    const branchTube left = daughter(radius, length, -1);
    const branchTube right = daughter(radius, length, 1);
    const auto distance = [&](const vector& p)
    {
        const double width = 0.4*radius;
        return smoothMin
        (
            parent(p), smoothMin(left(p), right(p), width), width
        );
    };
    const double edge = 2*pi*radius/n;
    const auto level = [&](double value)
    {
        const double margin = radius + value + 2*edge;
        const double far = std::max(length, 6*radius) + margin;
        return makeImplicit
        (
            [&](const vector& p) { return distance(p) - value; },
            {-margin, -length - margin, -2*radius - margin},
            {margin, far, 2*radius + margin},
            edge
        );
    };
    shapeSurface surface = level(offset + wall);
    if (wall > 0)
    {
        append(surface, level(offset), true);
    }
    return surface;
}

} // namespace gpuFsi
