#include "seeding/solidReport.H"

#include <algorithm>
#include <cmath>

namespace gpuFsi
{

namespace
{

void measureCells(const solidBody& body, solidReport& r)
{
    r.cellVolumes = r.edges = {INFINITY, 0};
    const auto widen = [](std::pair<double, double>& range, double value)
    {
        range.first = std::min(range.first, value);
        range.second = std::max(range.second, value);
    };
    const int dimensions = body.lattice.dimensions();
    for (const auto& cell : body.mesh.cells)
    {
        widen(r.cellVolumes, body.mesh.volume(cell));
        for (int c = 0; c < (1 << dimensions); ++c)
        {
            for (int axis = 0; axis < dimensions; ++axis)
            {
                if (!(c >> axis & 1))
                {
                    widen(r.edges, magnitude(body.mesh.offset
                    (
                        body.mesh.points[cell[c | 1 << axis]],
                        body.mesh.points[cell[c]]
                    )));
                }
            }
        }
    }
}

//- Is some of the shape beyond the bounds, for all that is known?
bool cut(const solidInput& s, const solidBody& body)
{
    const auto b = s.shape->bounds();
    const double slack = 1e-9*body.lattice.longestEdge();
    bool result = !b;
    for (int axis = 0; b && axis < body.lattice.dimensions(); ++axis)
    {
        const double low = component(body.lattice.lo(), axis);
        const double high = component(body.lattice.hi(), axis);
        result = result
         || component(b->first, axis) < low - slack
         || component(b->second, axis) > high + slack;
    }
    return result;
}

} // namespace

solidReport makeReport
(
    const solidInput& s,
    const solidBody& body,
    const snapped& result
)
{
    solidReport r;
    r.name = s.name;
    r.shape = s.shape->description();
    r.nNodes = body.mesh.size();
    r.nCells = body.mesh.cells.size();
    r.volume = body.volume();
    r.nDropped = result.nDropped;
    r.nOff = result.nOff;
    for (const surfacePoint& p : body.surface())
    {
        ++r.nSurface;
        r.area += p.area;
    }
    measureCells(body, r);
    r.shapeVolume = cut(s, body) ? std::nullopt : s.shape->volume();
    return r;
}

} // namespace gpuFsi
