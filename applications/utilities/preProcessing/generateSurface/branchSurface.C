#include "implicitSurface.H"

#include <algorithm>
#include <cmath>

namespace gpuFsi
{

namespace
{

const double pi = std::acos(-1.0);

//- 0 below 0, 1 above 1, smooth between
double rise(double t)
{
    return 0.5*(1 - std::cos(pi*std::clamp(t, 0.0, 1.0)));
}


//- One way through the branch: along y to the origin, sideways in z over a
//  bend, along y again
class branchWay
{
public:

    branchWay(double radius, double length, double side)
    :
        radius_(radius)
    {
        line_.push_back({0, -length, 0});
        for (int i = 0; i <= nBend; ++i)
        {
            const double t = double(i)/nBend;
            line_.push_back
            ({
                0, t*bend*radius, 2*side*radius*rise(t)
            });
        }
        line_.push_back
        ({
            0, std::max(length, 1.01*bend*radius), 2*side*radius
        });
    }

    //- Distance from its surface, negative inside
    double operator()(const vector& p) const
    {
        double least = HUGE_VAL;
        for (std::size_t i = 1; i < line_.size(); ++i)
        {
            const vector along = line_[i] - line_[i - 1];
            const vector d = p - line_[i - 1];
            const double t =
                std::clamp(dot(d, along)/dot(along, along), 0.0, 1.0);
            const vector off = d - t*along;
            least = std::min(least, dot(off, off));
        }
        return std::sqrt(least)
          - radius_*(1 - 0.2*rise(p.y/(bend*radius_)));
    }

    static constexpr double bend = 5;    // radii

private:

    static constexpr int nBend = 24;

    double radius_;
    std::vector<vector> line_;
};


//- The lesser of two, rounded where they differ by less than width
double smoothMin(double a, double b, double width)
{
    if (!(width > 0))
    {
        return std::min(a, b);
    }
    const double t = std::max(width - std::abs(a - b), 0.0)/width;
    return std::min(a, b) - 0.25*width*t*t;
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
    const branchWay left(radius, length, -1);
    const branchWay right(radius, length, 1);
    const auto distance = [&](const vector& p)
    {
        // Not where both are one tube
        const double width =
            0.5*radius*rise(p.y/(0.6*branchWay::bend*radius));
        return smoothMin(left(p), right(p), width);
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
