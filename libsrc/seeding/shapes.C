#include "seeding/shapes.H"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gpuFsi
{

static double positiveRadius(const dictionary& dict)
{
    const double radius = dict.get<double>("radius");
    if (!(radius > 0) || !std::isfinite(radius))
    {
        throw userError
        (
            fmt::format("radius {} is not a positive number", radius),
            dict.where("radius"),
            "Give the radius in metres."
        );
    }
    return radius;
}


static const double pi = std::acos(-1.0);


boxRegion::boxRegion(const regionInput& input)
:
    implicitRegion(input, true),
    dimensions_(input.dimensions),
    lo_(input.dict.get<vector>("min")),
    hi_(input.dict.get<vector>("max"))
{
    for (int axis = 0; axis < dimensions_; ++axis)
    {
        if (!(component(lo_, axis) < component(hi_, axis)))
        {
            throw userError
            (
                fmt::format
                (
                    "Box {}: min {} is not below max {} in {}",
                    name(), component(lo_, axis), component(hi_, axis),
                    "xyz"[axis]
                ),
                input.dict.where("max"),
                "min and max are opposite corners."
            );
        }
    }
}


double boxRegion::phi(const vector& p) const
{
    double within = -INFINITY;
    double beyond = 0;
    for (int axis = 0; axis < dimensions_; ++axis)
    {
        const double x = component(p, axis);
        const double d =
            std::max(component(lo_, axis) - x, x - component(hi_, axis));
        within = std::max(within, d);
        beyond += d > 0 ? d*d : 0;
    }
    return within > 0 ? std::sqrt(beyond) : within;
}


std::optional<surfacePoint> boxRegion::nearest(const vector& p) const
{
    vector on = p;
    vector away{0, 0, 0};
    int face = 0;
    double most = -INFINITY;
    for (int axis = 0; axis < dimensions_; ++axis)
    {
        const double x = component(p, axis);
        const double low = component(lo_, axis);
        const double high = component(hi_, axis);
        component(on, axis) = std::clamp(x, low, high);
        component(away, axis) = x - component(on, axis);
        const double d = std::max(low - x, x - high);
        face = d > most ? axis : face;
        most = std::max(d, most);
    }
    if (most > 0)
    {
        return surfacePoint{on, (1/magnitude(away))*away, 0};
    }
    const double low = component(lo_, face);
    const double high = component(hi_, face);
    const bool upper = component(p, face) - low > high - component(p, face);
    component(on, face) = upper ? high : low;
    vector normal{0, 0, 0};
    component(normal, face) = upper ? 1 : -1;
    return surfacePoint{on, normal, 0};
}


std::optional<box> boxRegion::bounds() const
{
    return box{lo_, hi_};
}


std::optional<double> boxRegion::volume() const
{
    const vector size = hi_ - lo_;
    return size.x*size.y*(dimensions_ == 2 ? 1 : size.z);
}


std::string boxRegion::description() const
{
    return "box" + sideText();
}


sphereRegion::sphereRegion(const regionInput& input)
:
    implicitRegion(input, true),
    dimensions_(input.dimensions),
    centre_(input.dict.get<vector>("centre")),
    radius_(positiveRadius(input.dict))
{
    if (input.dimensions == 2)
    {
        centre_.z = 0;
    }
}


double sphereRegion::phi(const vector& p) const
{
    return magnitude(p - centre_) - radius_;
}


std::optional<surfacePoint> sphereRegion::nearest(const vector& p) const
{
    vector d = p - centre_;
    d.z = dimensions_ == 2 ? 0 : d.z;
    const double r = magnitude(d);
    const vector n = r > 0 ? (1/r)*d : vector{1, 0, 0};
    return surfacePoint{centre_ + radius_*n, n, 0};
}


std::optional<box> sphereRegion::bounds() const
{
    const vector r{radius_, radius_, radius_};
    return box{centre_ - r, centre_ + r};
}


std::optional<double> sphereRegion::volume() const
{
    return dimensions_ == 2
        ? pi*radius_*radius_
        : 4*pi/3*radius_*radius_*radius_;
}


std::string sphereRegion::description() const
{
    return fmt::format("sphere of radius {}", radius_) + sideText();
}


cylinderRegion::cylinderRegion(const regionInput& input)
:
    implicitRegion(input, true),
    dimensions_(input.dimensions),
    point1_(input.dict.get<vector>("point1")),
    point2_(input.dict.get<vector>("point2")),
    axis_(point2_ - point1_),
    radius_(positiveRadius(input.dict)),
    length_(magnitude(axis_))
{
    if (!(length_ > 0))
    {
        throw userError
        (
            "Cylinder " + name() + ": point1 and point2 are the same",
            input.dict.where("point2"),
            "They are the centres of its two end faces."
        );
    }
    axis_ = (1/length_)*axis_;
    if (input.dimensions == 2 && std::abs(axis_.z) < 1)
    {
        throw userError
        (
            "Cylinder " + name() + ": in 2-D its axis must be along z",
            input.dict.where("point2"),
            "Use a box, or a level set."
        );
    }
}


double cylinderRegion::phi(const vector& p) const
{
    const vector d = p - point1_;
    const double along = dot(d, axis_);
    const vector across = d - along*axis_;
    const double radial = magnitude(across) - radius_;
    if (dimensions_ == 2)
    {
        return radial;
    }
    const double axial = std::max(-along, along - length_);
    return radial > 0 && axial > 0
        ? std::hypot(radial, axial)
        : std::max(radial, axial);
}


std::optional<surfacePoint> cylinderRegion::nearest(const vector& p) const
{
    const vector d = p - point1_;
    const double along = dot(d, axis_);
    vector across = d - along*axis_;
    double r = magnitude(across);
    if (!(r > 0))
    {
        // Any direction across the axis
        vector aside{0, 0, 0};
        component(aside, std::abs(axis_.x) < 0.9 ? 0 : 1) = 1;
        across = cross(axis_, aside);
        r = magnitude(across);
        across = (1e-300/r)*across;
        r = 1e-300;
    }
    const vector n = (1/r)*across;
    const double radial = r - radius_;
    const double axial = std::max(-along, along - length_);
    const vector foot = p + (-radial)*n;
    if (dimensions_ == 2 || (axial <= 0 && radial >= axial))
    {
        return surfacePoint{foot, n, 0};
    }
    const double sign = along > 0.5*length_ ? 1 : -1;
    if (radial <= 0)
    {
        return surfacePoint{p + (-axial*sign)*axis_, sign*axis_, 0};
    }
    const vector rim = foot + (-axial*sign)*axis_;
    const vector away = p - rim;
    return surfacePoint{rim, (1/magnitude(away))*away, 0};
}


std::optional<box> cylinderRegion::bounds() const
{
    vector lo, hi;
    for (int axis = 0; axis < 3; ++axis)
    {
        const double a = component(axis_, axis);
        const double reach = radius_*std::sqrt(std::max(0.0, 1 - a*a));
        const double x1 = component(point1_, axis);
        const double x2 = component(point2_, axis);
        component(lo, axis) = std::min(x1, x2) - reach;
        component(hi, axis) = std::max(x1, x2) + reach;
    }
    return box{lo, hi};
}


std::optional<double> cylinderRegion::volume() const
{
    return pi*radius_*radius_*(dimensions_ == 2 ? 1 : length_);
}


std::string cylinderRegion::description() const
{
    return fmt::format("cylinder of radius {} and length {}", radius_, length_)
        + sideText();
}


planeRegion::planeRegion(const regionInput& input)
:
    implicitRegion(input, true),
    point_(input.dict.get<vector>("point")),
    normal_(input.dict.get<vector>("normal"))
{
    if (input.dimensions == 2)
    {
        normal_.z = 0;
    }
    const double length = magnitude(normal_);
    if (!(length > 0) || !std::isfinite(length))
    {
        throw userError
        (
            "Plane " + name() + ": its normal has no length",
            input.dict.where("normal"),
            "Give a vector that points into the fluid."
        );
    }
    normal_ = (1/length)*normal_;
}


double planeRegion::phi(const vector& p) const
{
    return dot(point_ - p, normal_);
}


std::string planeRegion::description() const
{
    return "plane" + sideText();
}

} // namespace gpuFsi
