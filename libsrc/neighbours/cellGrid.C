#include "neighbours/cellGrid.H"

#include "base/error.H"

#include <algorithm>
#include <fmt/format.h>
#include <limits>

namespace gpuFsi
{

cellGrid cellGrid::of(const domain& d, const frame& f, double searchRadius)
{
    const double cell = searchRadius/2;
    const double span[3] = {f.span.x, f.span.y, f.span.z};
    const double origin[3] = {f.origin.x, f.origin.y, f.origin.z};
    const double lo[3] = {d.lo.x, d.lo.y, d.lo.z};
    const double hi[3] = {d.hi.x, d.hi.y, d.hi.z};

    cellGrid g;
    g.perRadius = 0;
    for (int i = 0; i < 3; ++i)
    {
        g.periodic[i] = f.periodic[i];
        g.world[i] = 1;
        g.first[i] = 0;
        g.count[i] = 1;
        g.widthSquared[i] = 0;
        if (i >= d.dimensions)
        {
            continue;
        }
        g.world[i] = std::max(1, int(std::floor(span[i]/cell)));
        g.count[i] = g.world[i];
        const double inRadii = span[i]/g.world[i]/searchRadius;
        g.widthSquared[i] = float(0.9999*inRadii*inRadii);
        if (i == 0)
        {
            g.perRadius = float(1.0001/inRadii);
        }
        if (!f.periodic[i])
        {
            const double width = span[i]/g.world[i];
            g.first[i] = int(std::floor((lo[i] - origin[i])/width)) - 1;
            const int last = int(std::floor((hi[i] - origin[i])/width)) + 1;
            g.count[i] = last - g.first[i] + 1;
        }
    }
    const double cells = double(g.count[0])*g.count[1]*g.count[2];
    if (cells >= std::numeric_limits<int>::max())
    {
        throw userError
        (
            fmt::format
            (
                "The domain has {:.3g} cells to search for neighbours; at most "
                "{} may be", cells, std::numeric_limits<int>::max()
            ),
            {},
            "Narrow `bounds` in system/seedParticlesDict to where particles can "
            "be, or use a coarser spacing."
        );
    }
    return g;
}

} // namespace gpuFsi
