#include "seeding/lattice.H"

#include <fmt/format.h>

#include <cmath>

namespace gpuFsi
{

double magnitude(const vector& v)
{
    return std::sqrt(dot(v, v));
}


lattice::lattice
(
    int dimensions,
    double spacing,
    const vector& lo,
    const vector& hi,
    const std::array<bool, 3>& periodic,
    const sourceSpan& where
)
:
    dimensions_(dimensions),
    h_(spacing),
    lo_(lo),
    hi_(hi),
    periodic_(periodic)
{
    if (!(spacing > 0) || !std::isfinite(spacing))
    {
        throw userError
        (
            fmt::format("spacing {} is not a positive number", spacing),
            where,
            "Give the distance between particles in metres."
        );
    }
    if (dimensions_ == 2)
    {
        if (periodic_[2])
        {
            throw userError
            (
                "periodic in z, but dimensions is 2 (the x-y plane)",
                where,
                "Write no as the third word of periodic."
            );
        }
        lo_.z = -0.5*h_;
        hi_.z = 0.5*h_;
    }
    double cells = 1;
    for (int axis = 0; axis < dimensions_; ++axis)
    {
        fit(axis, where);
        cells *= double(n_[axis]);
    }
    if (cells > 2147483648.0)
    {
        throw userError
        (
            fmt::format
            (
                "{} x {} x {} = {:.3g} lattice points are too many"
                " (the limit is 2^31)",
                n_[0], n_[1], n_[2], cells
            ),
            where,
            "Increase spacing or reduce bounds; check the units of both."
        );
    }
}


void lattice::fit(int axis, const sourceSpan& where)
{
    const char name = "xyz"[axis];
    const double low = component(lo_, axis);
    const double high = component(hi_, axis);
    const double length = high - low;
    if (!(length > 0) || !std::isfinite(length))
    {
        throw userError
        (
            fmt::format("bounds in {} run from {} to {}", name, low, high),
            where,
            "The first point of bounds is the lower one in every direction."
        );
    }
    const double cells = length/h_;
    if (cells < 1 - 1e-6)
    {
        throw userError
        (
            fmt::format
            (
                "spacing {} is larger than the domain, {} long in {}",
                h_, length, name
            ),
            where,
            "Reduce spacing; check the units of spacing and bounds."
        );
    }
    if (cells > 4e9)
    {
        throw userError
        (
            fmt::format("{:.3g} cells in {} are too many", cells, name),
            where,
            "Increase spacing or reduce bounds; check the units of both."
        );
    }
    const double whole = std::round(cells);
    if (periodic_[axis] && std::abs(cells - whole) > 1e-6*whole)
    {
        throw userError
        (
            fmt::format
            (
                "periodic in {}, but the length {} is {:.6g} times"
                " the spacing {}",
                name, length, cells, h_
            ),
            where,
            fmt::format
            (
                "It must be a whole number of times: the nearest spacing"
                " that fits is {:.15g}.",
                length/whole
            )
        );
    }
    n_[axis] = long(std::floor(cells + 0.5 + 1e-9));
}


vector lattice::point(std::size_t index) const
{
    const std::size_t row = index/n_[0];
    return
    {
        centre(0, long(index % n_[0])),
        centre(1, long(row % n_[1])),
        centre(2, long(row/n_[1]))
    };
}


std::size_t lattice::firstPoint(int axis, std::size_t line) const
{
    const std::size_t nx = n_[0];
    switch (axis)
    {
        case 0: return line*nx;
        case 1: return line/nx*nx*n_[1] + line % nx;
        default: return line;
    }
}


std::size_t lattice::stride(int axis) const
{
    return axis == 0 ? 1
        : axis == 1 ? std::size_t(n_[0])
        : std::size_t(n_[0])*n_[1];
}


vector lattice::wrap(vector p) const
{
    for (int axis = 0; axis < dimensions_; ++axis)
    {
        const double low = component(lo_, axis);
        const double length = component(hi_, axis) - low;
        double& x = component(p, axis);
        if (periodic_[axis] && (x < low || x >= low + length))
        {
            x -= length*std::floor((x - low)/length);
            x = x >= low + length ? low : x;
        }
    }
    return p;
}


vector lattice::difference(const vector& a, const vector& b) const
{
    vector d = a - b;
    for (int axis = 0; axis < dimensions_; ++axis)
    {
        if (periodic_[axis])
        {
            const double length = component(hi_, axis) - component(lo_, axis);
            double& x = component(d, axis);
            x -= length*std::round(x/length);
        }
    }
    return d;
}

} // namespace gpuFsi
