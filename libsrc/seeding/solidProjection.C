#include "seeding/solidProjection.H"

#include <algorithm>
#include <cmath>

namespace gpuFsi
{

static constexpr double onSurface = 1e-9;    // of an edge


//- Is this end of the lattice a bound of the domain, inside the shape?
bool solidProjection::cut(int axis, bool upper) const
{
    const double slack = onSurface*lattice_.edge(axis);
    return !bounds_
     || (upper
      ? component(bounds_->second, axis)
      > component(lattice_.hi(), axis) + slack
      : component(bounds_->first, axis)
      < component(lattice_.lo(), axis) - slack);
}


std::optional<surfacePoint> solidProjection::nearest(const vector& x) const
{
    auto on = shape_.nearest(x);
    for (int axis = 0; axis < lattice_.dimensions(); ++axis)
    {
        // An end of the shape in a periodic bound is no surface of the solid
        const bool end = on && bounds_ && lattice_.around(axis)
         && std::abs(component(on->normal, axis)) > 0.9;
        if (end)
        {
            vector middle = x;
            component(middle, axis) =
                0.5*(component(lattice_.lo(), axis)
              + component(lattice_.hi(), axis));
            on = shape_.nearest(middle);
            if (on)
            {
                component(on->position, axis) +=
                    component(x, axis) - component(middle, axis);
            }
        }
    }
    return on;
}


solidProjection::freedom solidProjection::freedomOf
(
    std::size_t place,
    const vector& x,
    int faceAxes
) const
{
    freedom f;
    const auto on = nearest(x);
    const bool there = on
     && magnitude(on->position - x) <= onSurface*lattice_.longestEdge();
    for (int axis = 0; axis < lattice_.dimensions(); ++axis)
    {
        const long i = lattice_.nodeIndex(place, axis);
        const bool upper = i == lattice_.n(axis);
        if (lattice_.around(axis) || (i > 0 && !upper))
        {
            continue;
        }
        const bool bound = cut(axis, upper);
        // A flat end: the node is on it, or beyond its edge but in its plane
        const bool level = on
         && std::abs(component(on->position - x, axis))
         <= onSurface*lattice_.longestEdge();
        const bool flat = !bound && level
         && (!there || std::abs(component(on->normal, axis)) > 1 - 1e-6);
        f.fixed[axis] = bound || flat;
        if (flat)
        {
            const double inwards = std::min
            (
                lattice_.edge(axis), 0.5*lattice_.n(axis)*lattice_.edge(axis)
            );
            component(f.shift, axis) = upper ? -inwards : inwards;
        }
        faceAxes &= f.fixed[axis] ? ~(1 << axis) : ~0;
    }
    const bool held = f.fixed[0] || f.fixed[1] || f.fixed[2];
    f.project = faceAxes != 0;
    f.stays = there && !(held && f.project);
    return f;
}


vector solidProjection::within(vector normal, const freedom& f)
{
    for (int axis = 0; axis < 3; ++axis)
    {
        component(normal, axis) *= !f.fixed[axis];
    }
    return normal;
}


//- In a shape thinner than the way to its side the flat ends are nearest: the
//  nearest place on the side as seen from an edge away along each axis
vector solidProjection::beside(const vector& x, const freedom& f) const
{
    vector best = x;
    double least = INFINITY;
    for (int way = 0; way < 2*lattice_.dimensions(); ++way)
    {
        if (f.fixed[way/2])
        {
            continue;
        }
        vector from = x + f.shift;
        component(from, way/2) += (way % 2 ? 1 : -1)*lattice_.edge(way/2);
        const auto on = nearest(from);
        if (!on || magnitude(within(on->normal, f)) < 0.5)
        {
            continue;
        }
        const vector to = within(on->position - x, f);
        if (magnitude(to) < least*(1 - 1e-9))
        {
            least = magnitude(to);
            best = x + to;
        }
    }
    return best;
}


std::optional<vector> solidProjection::operator()
(
    const vector& x,
    const freedom& f
) const
{
    const bool held = f.fixed[0] || f.fixed[1] || f.fixed[2];
    vector at = x;
    if (held)
    {
        const auto on = nearest(x + f.shift);
        const bool end = on && magnitude(within(on->normal, f)) < 0.1;
        at = end ? beside(x, f) : x;
    }
    for (int step = 0; step < 50; ++step)
    {
        const vector from = at + f.shift;
        const auto on = nearest(from);
        if (!on)
        {
            return {};
        }
        if (!held)
        {
            return on->position;
        }
        const vector along = within(on->normal, f);
        const double slope = dot(along, along);
        if (slope < 0.01)
        {
            return {};
        }
        const double move = dot(on->position - from, on->normal)/slope;
        at = at + move*along;
        if (std::abs(move) <= 1e-12*lattice_.longestEdge())
        {
            return at;
        }
    }
    return {};
}

} // namespace gpuFsi
