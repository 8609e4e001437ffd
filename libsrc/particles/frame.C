#include "particles/frame.H"

namespace gpuFsi
{

//- Room outside the domain for walls that move and particles on their way out
static constexpr double margin = 8;

static void setDirection
(
    double& origin,
    double& span,
    bool periodic,
    double lo,
    double hi,
    double h
)
{
    origin = lo;
    span = hi - lo;
    if (!periodic)
    {
        // Wide enough that any two particles differ by less than half of it
        const double cells = 2*((hi - lo)/h + 2*margin);
        const double wide = h*std::exp2(std::ceil(std::log2(cells)));
        origin = lo - std::floor((wide - span)/(2*h))*h;
        span = wide;
    }
}


frame frame::of(const domain& d)
{
    frame f;
    for (int i = 0; i < 3; ++i)
    {
        f.periodic[i] = d.periodic[i];
    }
    const double h = d.spacing;
    setDirection(f.origin.x, f.span.x, f.periodic[0], d.lo.x, d.hi.x, h);
    setDirection(f.origin.y, f.span.y, f.periodic[1], d.lo.y, d.hi.y, h);
    setDirection(f.origin.z, f.span.z, f.periodic[2], d.lo.z, d.hi.z, h);
    return f;
}

} // namespace gpuFsi
