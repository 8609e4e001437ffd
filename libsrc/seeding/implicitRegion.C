#include "seeding/implicitRegion.H"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gpuFsi
{

//- Parts thinner than h are found by samples between the lattice points
static constexpr int samplesPerCell = 4;

class implicitRegion::tracer
{
public:

    tracer(const implicitRegion& r, const lattice& l)
    :
        region_(r),
        lattice_(l),
        onSurface_(1e-9*l.h())
    {
        sample();
        for (int axis = 0; axis < l.dimensions(); ++axis)
        {
            for (std::size_t line = 0; line < l.nLines(axis); ++line)
            {
                traceLine(axis, line);
            }
        }
    }

    regionTrace result;

private:

    //- Just outside counts as inside, so that round-off makes no crossings
    bool inside(double value) const { return value <= onSurface_; }

    double checked(const vector& p) const
    {
        const double v = region_.value(lattice_.wrap(p));
        if (!std::isfinite(v))
        {
            throw userError
            (
                fmt::format
                (
                    "Region {}: the expression is {} at ({} {} {})",
                    region_.name(), v, p.x, p.y, p.z
                ),
                region_.where(),
                "It must have a finite value everywhere within bounds and"
                " one spacing around them."
            );
        }
        return v;
    }

    void sample()
    {
        const std::size_t size = lattice_.size();
        values_.resize(size);
        result.inside.resize(size);
        result.close.resize(size);
        for (std::size_t i = 0; i < size; ++i)
        {
            values_[i] = checked(lattice_.point(i));
            result.inside[i] = inside(values_[i]);
        }
        const double limit = closeDistance(lattice_);
        for (std::size_t i = 0; i < size; ++i)
        {
            double distance = std::abs(values_[i]);
            if (!region_.isDistance_ && distance < 4*limit*slope(i))
            {
                const double g = magnitude
                (
                    region_.gradient(lattice_.point(i), 0.01*lattice_.h())
                );
                distance = g > 0 ? distance/g : 2*limit;
            }
            else if (!region_.isDistance_)
            {
                distance = 2*limit;
            }
            result.close[i] = distance < limit;
        }
    }

    //- Largest difference to a neighbouring point, over h
    double slope(std::size_t point) const
    {
        if (region_.isDistance_)
        {
            return 1;
        }
        double most = 0;
        for (int axis = 0; axis < lattice_.dimensions(); ++axis)
        {
            const std::size_t stride = lattice_.stride(axis);
            const long i = long(point/stride % lattice_.n(axis));
            if (i > 0)
            {
                most = std::max
                (
                    most, std::abs(values_[point] - values_[point - stride])
                );
            }
            if (i + 1 < lattice_.n(axis))
            {
                most = std::max
                (
                    most, std::abs(values_[point] - values_[point + stride])
                );
            }
        }
        return most/lattice_.h();
    }

    void traceLine(int axis, std::size_t line)
    {
        const std::size_t first = lattice_.firstPoint(axis, line);
        const std::size_t stride = lattice_.stride(axis);
        const long n = lattice_.n(axis);
        origin_ = lattice_.point(first);
        // A cell beyond either end, or once around
        const bool around = lattice_.periodic(axis);
        double before = around ? values_[first] : at(axis, -1);
        for (long i = around ? 1 : 0; i <= n; ++i)
        {
            const std::size_t here =
                first + std::min<long>(std::max<long>(i - 1, 0), n - 1)*stride;
            const double after =
                i < n ? values_[first + i*stride]
              : around ? values_[first]
              : at(axis, n);
            const bool far =
                inside(before) == inside(after)
             && std::abs(before) + std::abs(after)
              > (region_.isDistance_ ? 1 : 2)*slope(here)*lattice_.h();
            if (!far)
            {
                traceCell(axis, line, i - 1, before, after);
            }
            before = after;
        }
    }

    double at(int axis, double cell) const
    {
        vector p = origin_;
        component(p, axis) = component(lattice_.lo(), axis)
            + (cell + 0.5)*lattice_.h();
        return checked(p);
    }

    //- From lattice point i to the next
    void traceCell(int axis, std::size_t line, long i, double from, double to)
    {
        const std::size_t before = result.crossings.size();
        for (int s = 1; s <= samplesPerCell; ++s)
        {
            const double next = s == samplesPerCell
                ? to
                : at(axis, i + double(s)/samplesPerCell);
            if (inside(from) != inside(next))
            {
                const double low = lattice_.centre(axis, i)
                    + lattice_.h()*(s - 1)/samplesPerCell;
                addCrossing
                (
                    axis, line, low, low + lattice_.h()/samplesPerCell,
                    from, next
                );
            }
            from = next;
        }
        // Shapes that end in a periodic bound leave no gap there
        auto& crossings = result.crossings;
        if (lattice_.periodic(axis) && crossings.size() == before + 2)
        {
            vector gap{0, 0, 0};
            component(gap, axis) = crossings[before].t - crossings.back().t;
            gap = lattice_.difference(gap, {0, 0, 0});
            if (magnitude(gap) < 1e-6*lattice_.h())
            {
                crossings.resize(before);
            }
        }
    }

    void addCrossing
    (
        int axis,
        std::size_t line,
        double low,
        double high,
        double valueLow,
        double valueHigh
    )
    {
        const bool enters = inside(valueHigh);
        vector p = origin_;
        component(p, axis) = root(axis, low, high, valueLow, valueHigh);
        p = lattice_.wrap(p);
        vector n = -1.0*region_.gradient(p, 1e-4*lattice_.h());
        if (!(magnitude(n) > 0) || !std::isfinite(magnitude(n)))
        {
            n = {0, 0, 0};
            component(n, axis) = enters ? 1 : -1;
        }
        n = (1/magnitude(n))*n;
        result.crossings.push_back
        ({
            axis, line, component(p, axis), enters, n
        });
    }

    //- Regula falsi (Illinois), every third step a bisection
    double root(int axis, double a, double b, double fa, double fb) const
    {
        if (fa*fb >= 0)
        {
            // One end lies on the surface but for round-off
            return std::abs(fa) < std::abs(fb) ? a : b;
        }
        vector p = origin_;
        double& x = component(p, axis);
        for (int step = 1; step < 200 && b - a > 1e-13*lattice_.h(); ++step)
        {
            x = step % 3 ? (a*fb - b*fa)/(fb - fa) : 0.5*(a + b);
            if (!(x > a && x < b))
            {
                x = 0.5*(a + b);
                if (x == a || x == b)
                {
                    break;
                }
            }
            const double f = checked(p);
            if (f == 0)
            {
                return x;
            }
            if ((f > 0) == (fa > 0))
            {
                a = x;
                fa = f;
                fb *= 0.5;
            }
            else
            {
                b = x;
                fb = f;
                fa *= 0.5;
            }
        }
        return 0.5*(a + b);
    }

    const implicitRegion& region_;
    const lattice& lattice_;
    double onSurface_;
    std::vector<double> values_;
    vector origin_{};
};


implicitRegion::implicitRegion(const regionInput& input, bool isDistance)
:
    region(input),
    isDistance_(isDistance),
    dimensions_(input.dimensions),
    spacing_(input.spacing)
{}


regionTrace implicitRegion::trace(const lattice& l) const
{
    return std::move(tracer(*this, l).result);
}


vector implicitRegion::gradient(const vector& p, double delta) const
{
    vector g{0, 0, 0};
    for (int axis = 0; axis < dimensions_; ++axis)
    {
        vector high = p, low = p;
        component(high, axis) += delta;
        component(low, axis) -= delta;
        component(g, axis) = (value(high) - value(low))/(2*delta);
    }
    return g;
}

} // namespace gpuFsi
