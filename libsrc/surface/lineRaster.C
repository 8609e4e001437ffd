#include "surface/lineRaster.H"

#include "surface/nearTriangle.H"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cmath>

namespace gpuFsi
{

namespace
{

using kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

//- A place in the plane across a lattice line
struct flat
{
    double u, v;
};

double area(const flat& a, const flat& b, const flat& q)
{
    return (b.u - a.u)*(q.v - a.v) - (b.v - a.v)*(q.u - a.u);
}

//- Exact sign of area()
int side(const flat& a, const flat& b, const flat& q)
{
    const double l = (b.u - a.u)*(q.v - a.v);
    const double r = (b.v - a.v)*(q.u - a.u);
    const double bound = 1e-15*(std::abs(l) + std::abs(r));
    if (l - r > bound || r - l > bound)
    {
        return l > r ? 1 : -1;
    }
    return CGAL::orientation
    (
        kernel::Point_2(a.u, a.v),
        kernel::Point_2(b.u, b.v),
        kernel::Point_2(q.u, q.v)
    );
}

//- Of q moved by (eps, eps^2): never 0 unless a and b are the same
int movedSide(const flat& a, const flat& b, const flat& q)
{
    const int s = side(a, b, q);
    if (s != 0)
    {
        return s;
    }
    if (a.v != b.v)
    {
        return a.v > b.v ? 1 : -1;
    }
    return b.u > a.u ? 1 : b.u < a.u ? -1 : 0;
}

class rasteriser
{
public:

    rasteriser(const lattice& l, const triangleSurface& s, bool fluidInside)
    :
        lattice_(l),
        surface_(s),
        fluidInside_(fluidInside)
    {
        result.inside.assign(l.size(), 0);
        result.close.assign(l.size(), 0);
        for (int axis = 0; axis < l.dimensions(); ++axis)
        {
            for (std::size_t t = 0; t < s.triangles.size(); ++t)
            {
                cross(axis, t);
            }
        }
        fill();
        for (std::size_t t = 0; t < s.triangles.size(); ++t)
        {
            markNear(l, s, t, result.close);
        }
    }

    regionTrace result;

private:

    //- First lattice point at or above x, and last at or below it, within
    //  the lattice; a little generous for round-off
    std::pair<long, long> range(int axis, double low, double high) const
    {
        const double origin = component(lattice_.lo(), axis);
        const double first = (low - origin)/lattice_.h() - 0.5;
        const double last = (high - origin)/lattice_.h() - 0.5;
        const double n = double(lattice_.n(axis));
        return
        {
            long(std::ceil(std::clamp(first - 1e-6, 0.0, n))),
            long(std::floor(std::clamp(last + 1e-6, -1.0, n - 1)))
        };
    }

    void cross(int axis, std::size_t triangle)
    {
        const int lower = axis == 0 ? 1 : 0;
        const int upper = axis == 2 ? 1 : 2;
        // The orientation of (lower, upper) seen along the axis
        const int turn = axis == 1 ? -1 : 1;
        std::array<flat, 3> c;
        std::array<double, 3> height;
        for (int i = 0; i < 3; ++i)
        {
            const vector& p = surface_.corner(triangle, i);
            c[i] = {component(p, lower), component(p, upper)};
            height[i] = component(p, axis);
        }
        const auto us = std::minmax({c[0].u, c[1].u, c[2].u});
        const auto vs = std::minmax({c[0].v, c[1].v, c[2].v});
        const auto [iBegin, iEnd] = range(lower, us.first, us.second);
        const auto [jBegin, jEnd] = range(upper, vs.first, vs.second);
        if (iBegin > iEnd || jBegin > jEnd)
        {
            return;
        }
        const int whole = side(c[0], c[1], c[2]);
        if (whole == 0)
        {
            return;    // edge-on: the moved lines pass beside it
        }
        for (long j = jBegin; j <= jEnd; ++j)
        {
            for (long i = iBegin; i <= iEnd; ++i)
            {
                const flat q
                {
                    lattice_.centre(lower, i), lattice_.centre(upper, j)
                };
                if
                (
                    movedSide(c[0], c[1], q) == whole
                 && movedSide(c[1], c[2], q) == whole
                 && movedSide(c[2], c[0], q) == whole
                )
                {
                    const double w0 = area(c[1], c[2], q);
                    const double w1 = area(c[2], c[0], q);
                    const double w2 = area(c[0], c[1], q);
                    const double t =
                        (w0*height[0] + w1*height[1] + w2*height[2])
                       /(w0 + w1 + w2);
                    add(axis, lattice_.line(axis, i, j), triangle,
                        clamp(t, height), whole*turn > 0);
                }
            }
        }
    }

    static double clamp(double t, const std::array<double, 3>& height)
    {
        const auto ends = std::minmax({height[0], height[1], height[2]});
        return t >= ends.first && t <= ends.second
            ? t
            : t > ends.second ? ends.second : ends.first;
    }

    //- leaves: the outer normal points along the axis
    void add
    (
        int axis,
        std::size_t line,
        std::size_t triangle,
        double t,
        bool leaves
    )
    {
        if (axis == 0)
        {
            // Its first point beyond starts to differ; see fill()
            const long first = firstBeyond(line, triangle, t, leaves);
            if (first < lattice_.n(0))
            {
                result.inside[line*lattice_.n(0) + first] ^= 1;
            }
        }
        vector n = surface_.normal(triangle);
        if (lattice_.dimensions() == 2)
        {
            n.z = 0;
        }
        n = ((fluidInside_ ? -1 : 1)/magnitude(n))*n;
        result.crossings.push_back
        ({
            axis, line, t, leaves != fluidInside_, n
        });
    }

    //- Lattice point along x, decided exactly; one on the surface counts as
    //  beyond it
    long firstBeyond
    (
        std::size_t line,
        std::size_t triangle,
        double t,
        bool leaves
    ) const
    {
        const auto exact = [](const vector& p)
        {
            return kernel::Point_3(p.x, p.y, p.z);
        };
        const auto a = exact(surface_.corner(triangle, 0));
        const auto b = exact(surface_.corner(triangle, 1));
        const auto c = exact(surface_.corner(triangle, 2));
        const std::size_t start = lattice_.firstPoint(0, line);
        const auto beyond = [&](long i)
        {
            const auto where =
                CGAL::orientation(a, b, c, exact(lattice_.point(start + i)));
            return where == CGAL::COPLANAR
                || (where == CGAL::POSITIVE) == leaves;
        };
        const long n = lattice_.n(0);
        const double place = (t - lattice_.lo().x)/lattice_.h() - 0.5;
        long first = long(std::ceil(std::clamp(place, 0.0, double(n))));
        while (first < n && !beyond(first))
        {
            ++first;
        }
        while (first > 0 && beyond(first - 1))
        {
            --first;
        }
        return first;
    }

    void fill()
    {
        const std::size_t n = lattice_.n(0);
        for (std::size_t line = 0; line < lattice_.nLines(0); ++line)
        {
            std::uint8_t state = fluidInside_ ? 0 : 1;
            for (std::size_t i = line*n; i < (line + 1)*n; ++i)
            {
                state ^= result.inside[i];
                result.inside[i] = state;
            }
        }
    }

    const lattice& lattice_;
    const triangleSurface& surface_;
    bool fluidInside_;
};

} // namespace

regionTrace traceSurface
(
    const lattice& l,
    const triangleSurface& s,
    bool fluidInside
)
{
    return std::move(rasteriser(l, s, fluidInside).result);
}

} // namespace gpuFsi
