#include "seeding/implicitRegion.H"

#include <cmath>

namespace gpuFsi
{

std::vector<std::uint8_t> implicitRegion::contains
(
    const std::vector<vector>& points,
    double slack
) const
{
    std::vector<std::uint8_t> result(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        const double f = phi(points[i]);
        result[i] = f <= 0 || (isDistance_ && f <= slack);
        if (f > 0 && !isDistance_)
        {
            const vector g = gradient(points[i], 1e-4*spacing_);
            result[i] = f <= slack*magnitude(g);
        }
    }
    return result;
}


bool implicitRegion::descend(vector& x, vector& n) const
{
    const double h = spacing_;
    double last = INFINITY;
    for (int step = 0; step < 50 && last > 1e-13*h; ++step)
    {
        const vector g = (fluidInside() ? 1.0 : -1.0)*gradient(x, 1e-4*h);
        const double g2 = dot(g, g);
        const double move = -phi(x)/g2;
        if (!(g2 > 0) || !std::isfinite(move))
        {
            return false;
        }
        last = std::abs(move)*std::sqrt(g2);
        n = (1/std::sqrt(g2))*g;
        x = x + (last > h ? move*h/last : move)*g;
    }
    return last < 1e-10*h;
}


std::optional<surfacePoint> implicitRegion::nearest(const vector& p) const
{
    const double h = spacing_;
    vector x = p;
    vector n{};
    if (!descend(x, n))
    {
        return {};
    }
    const surfacePoint first{x, n, 0};
    for (int round = 0; round < 20; ++round)
    {
        const vector d = p - x;
        const vector along = d - dot(d, n)*n;
        const double length = magnitude(along);
        if (length < 1e-3*h)
        {
            return surfacePoint{x, n, 0};
        }
        x = x + (length > 0.5*h ? 0.5*h/length : 1.0)*along;
        if (!descend(x, n))
        {
            break;
        }
    }
    // Beside an edge the way along the surface has no end
    return first;
}

} // namespace gpuFsi
