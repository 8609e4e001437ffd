#include "decomposition/blockGrid.H"

#include <algorithm>
#include <cmath>

namespace gpuFsi
{

//- Top 32 bits of a coordinate in double precision
static std::uint32_t topOf(double x, double lo, double span)
{
    return std::uint32_t
    (
        std::uint64_t(frame::toFixed<double>(x, lo, span)) >> 32
    );
}


constexpr double mostBlocks = 1 << 24;

blockGrid blockGrid::of(const domain& d, const frame& f, double reach)
{
    const double lo[3] = {d.lo.x, d.lo.y, d.lo.z};
    const double hi[3] = {d.hi.x, d.hi.y, d.hi.z};
    const double origin[3] = {f.origin.x, f.origin.y, f.origin.z};
    const double span[3] = {f.span.x, f.span.y, f.span.z};
    double size[3];

    blockGrid g;
    for (int i = 0; i < 3; ++i)
    {
        const double length = hi[i] - lo[i];
        const bool flat = i >= d.dimensions;
        g.periodic[i] = f.periodic[i];
        // A little wider than the reach, for the rounding of coordinates
        g.n[i] = flat ? 1 : std::max(1, int(length/(1.001*reach)));
        g.lo[i] = g.periodic[i] ? 0 : topOf(lo[i], origin[i], span[i]);
        g.width[i] = g.periodic[i] || flat
          ? std::uint64_t(1) << 32
          : std::uint64_t(std::ceil(std::ldexp(length/span[i], 32)));
    }
    // Every rank holds a table of all blocks
    while (double(g.n[0])*g.n[1]*g.n[2] > mostBlocks)
    {
        int& most = *std::max_element(g.n, g.n + 3);
        most = (most + 1)/2;
    }
    for (int i = 0; i < 3; ++i)
    {
        size[i] = (hi[i] - lo[i])/g.n[i];
    }
    g.origin = d.lo;
    g.size = {size[0], size[1], size[2]};
    return g;
}


blockGrid blockGrid::cells(double width, int dimensions) const
{
    const double length[3] = {n[0]*size.x, n[1]*size.y, n[2]*size.z};
    blockGrid g = *this;
    for (int i = 0; i < dimensions; ++i)
    {
        g.n[i] = std::max(1, int(std::lround(length[i]/width)));
    }
    g.size = {length[0]/g.n[0], length[1]/g.n[1], length[2]/g.n[2]};
    return g;
}


int blockGrid::blockOf(const frame& f, const vector& x) const
{
    return index
    (
        along(0, topOf(x.x, f.origin.x, f.span.x)),
        along(1, topOf(x.y, f.origin.y, f.span.y)),
        n[2] == 1 ? 0 : along(2, topOf(x.z, f.origin.z, f.span.z))
    );
}

} // namespace gpuFsi
