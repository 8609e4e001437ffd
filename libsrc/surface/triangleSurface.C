#include "surface/triangleSurface.H"

#include "base/sum.H"

namespace gpuFsi
{

double triangleSurface::volume() const
{
    if (points.empty())
    {
        return 0;
    }
    // From a point of the surface: no loss of digits far from the origin
    const vector origin = points[0];
    return pairwiseSum(0, triangles.size(), [&](std::size_t t)
    {
        return dot(corner(t, 0) - origin, normal(t))/6;
    });
}

} // namespace gpuFsi
