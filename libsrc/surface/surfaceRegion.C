#include "surface/surfaceRegion.H"

#include "base/log.H"
#include "surface/checkSurface.H"
#include "surface/lineRaster.H"
#include "surface/polygonMesh.H"
#include "surface/readSurface.H"

#include <fmt/format.h>

#include <algorithm>

namespace gpuFsi
{

surfaceRegion::surfaceRegion(const regionInput& input)
:
    region(input),
    file_(input.dict.get<std::string>("file")),
    dimensions_(input.dimensions)
{
    const double scale =
        input.dict.getNumberOrDefault("scale", 1, 1e-30, 1e30);
    readReport report;
    surface_ = readSurface
    (
        input.casePath/file_, scale, input.dict.where("file"), report
    );
    info
    (
        "Surface {}: {} faces, {} triangles, {} points",
        file_, report.nPolygons, surface_.triangles.size(),
        surface_.points.size()
    );
    if (report.nDegenerate)
    {
        info("    {} triangles without area dropped", report.nDegenerate);
    }
    checkSurface(surface_, (input.casePath/file_).string());

    bounds_ = {surface_.points[0], surface_.points[0]};
    for (const vector& p : surface_.points)
    {
        for (int axis = 0; axis < 3; ++axis)
        {
            double& low = component(bounds_.first, axis);
            double& high = component(bounds_.second, axis);
            low = std::min(low, component(p, axis));
            high = std::max(high, component(p, axis));
        }
    }
    info
    (
        "    from ({:.6g} {:.6g} {:.6g}) to ({:.6g} {:.6g} {:.6g}),"
        " volume {:.8g}\n",
        bounds_.first.x, bounds_.first.y, bounds_.first.z,
        bounds_.second.x, bounds_.second.y, bounds_.second.z,
        surface_.volume()
    );
    warnUnit(input.spacing);
}


void surfaceRegion::warnUnit(double spacing) const
{
    const vector size = bounds_.second - bounds_.first;
    double most = 0;
    for (int axis = 0; axis < dimensions_; ++axis)
    {
        most = std::max(most, component(size, axis)/spacing);
    }
    if (most < 3 || most > 2000)
    {
        warning
        (
            fmt::format
            (
                "Surface {} is {:.3g} spacings across: is it in metres?\n"
                "    A file in millimetres needs scale 0.001.",
                file_, most
            )
        );
    }
}


std::optional<double> surfaceRegion::volume() const
{
    return dimensions_ == 3
        ? std::optional<double>(surface_.volume())
        : std::nullopt;
}


std::vector<std::uint8_t> surfaceRegion::contains
(
    const std::vector<vector>& points,
    double slack
) const
{
    const std::vector<int> sides = sideOf(surface_, points);
    std::vector<std::uint8_t> result(points.size());
    for (std::size_t i = 0; i < result.size(); ++i)
    {
        result[i] = sides[i] >= 0;
        if (!result[i] && slack > 0)
        {
            const auto on = nearest(points[i]);
            result[i] = on && magnitude(on->position - points[i]) <= slack;
        }
    }
    return result;
}


std::optional<surfacePoint> surfaceRegion::nearest(const vector& p) const
{
    if (!distance_)
    {
        distance_ = std::make_unique<surfaceDistance>(surface_, dimensions_);
    }
    return distance_->nearest(p);
}


regionTrace surfaceRegion::trace(const lattice& l) const
{
    return traceSurface(l, surface_, fluidInside());
}


std::string surfaceRegion::description() const
{
    return fmt::format
    (
        "surface {}, {} triangles", file_, surface_.triangles.size()
    ) + sideText();
}

} // namespace gpuFsi
