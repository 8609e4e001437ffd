#include "surface/nearTriangle.H"

#include <algorithm>
#include <cmath>

namespace gpuFsi
{

static double toEdge(const vector& p, const vector& a, const vector& b)
{
    const vector ab = b - a;
    const double share = std::clamp(dot(p - a, ab)/dot(ab, ab), 0.0, 1.0);
    const vector d = p - a - share*ab;
    return dot(d, d);
}


double distanceSquared
(
    const vector& p,
    const vector& a,
    const vector& b,
    const vector& c
)
{
    const vector n = cross(b - a, c - a);
    const auto within = [&](const vector& from, const vector& to)
    {
        return dot(cross(to - from, p - from), n) >= 0;
    };
    if (within(a, b) && within(b, c) && within(c, a))
    {
        const double height = dot(p - a, n);
        return height*height/dot(n, n);
    }
    return std::min({toEdge(p, a, b), toEdge(p, b, c), toEdge(p, c, a)});
}


void markNear
(
    const lattice& l,
    const triangleSurface& s,
    std::size_t triangle,
    std::vector<std::uint8_t>& close
)
{
    const vector& a = s.corner(triangle, 0);
    const vector& b = s.corner(triangle, 1);
    const vector& c = s.corner(triangle, 2);
    const vector n = s.normal(triangle);
    const double limit = 0.5*l.h()*(1 - 1e-3);

    // Rows along the axis that the triangle faces most: few points each
    int axis = 0;
    for (int i = 1; i < l.dimensions(); ++i)
    {
        axis = std::abs(component(n, i)) > std::abs(component(n, axis))
            ? i : axis;
    }
    std::array<long, 3> first{}, last{};
    for (int i = 0; i < l.dimensions(); ++i)
    {
        const auto ends = std::minmax
        ({
            component(a, i), component(b, i), component(c, i)
        });
        const double origin = component(l.lo(), i);
        const double top = double(l.n(i) - 1);
        const double low = (ends.first - limit - origin)/l.h() - 0.5;
        const double high = (ends.second + limit - origin)/l.h() - 0.5;
        if (high < 0 || low > top)
        {
            return;
        }
        first[i] = long(std::ceil(std::max(low, 0.0)));
        last[i] = long(std::floor(std::min(high, top)));
    }
    const std::array<long, 2> ends{first[axis], last[axis]};
    const double slope = component(n, axis);
    const double reach = limit*magnitude(n);
    if (slope == 0)
    {
        return;    // 2-D: it lies along the plane
    }
    first[axis] = last[axis] = 0;
    std::array<long, 3> i{};
    for (i[2] = first[2]; i[2] <= last[2]; ++i[2])
    {
        for (i[1] = first[1]; i[1] <= last[1]; ++i[1])
        {
            for (i[0] = first[0]; i[0] <= last[0]; ++i[0])
            {
                // Within the slab |(p - a).n| <= limit |n|
                vector p
                {
                    l.centre(0, i[0]), l.centre(1, i[1]), l.centre(2, i[2])
                };
                component(p, axis) = component(a, axis);
                const double offset = dot(p - a, n);
                const double origin =
                    component(a, axis) - component(l.lo(), axis);
                const double middle = origin - offset/slope;
                const double half = std::abs(reach/slope);
                const double low = (middle - half)/l.h() - 0.5;
                const double high = (middle + half)/l.h() - 0.5;
                const long from =
                    long(std::ceil(std::max(low, double(ends[0]))));
                const long to =
                    long(std::floor(std::min(high, double(ends[1]))));
                for (long q = from; q <= to; ++q)
                {
                    component(p, axis) = l.centre(axis, q);
                    std::array<long, 3> at = i;
                    at[axis] = q;
                    std::uint8_t& mark = close[l.index(at[0], at[1], at[2])];
                    mark = mark
                     || distanceSquared(p, a, b, c) < limit*limit;
                }
            }
        }
    }
}

} // namespace gpuFsi
