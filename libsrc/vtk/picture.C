#include "vtk/picture.H"

#include "vtk/marks.H"

#include <fmt/format.h>

#include <cmath>

namespace gpuFsi
{

static void checkDomain(const domain& where)
{
    const bool flat = where.dimensions == 2;
    if
    (
        !(where.spacing > 0)
     || !(where.hi.x > where.lo.x)
     || !(where.hi.y > where.lo.y)
     || (!flat && !(where.hi.z > where.lo.z))
    )
    {
        throw userError
        (
            fmt::format
            (
                "The domain has no extent to draw: spacing {}, from ({} {} {})"
                " to ({} {} {})",
                where.spacing,
                where.lo.x, where.lo.y, where.lo.z,
                where.hi.x, where.hi.y, where.hi.z
            ),
            {},
            "Run seedParticles again, which writes constant/domain"
        );
    }
}


//- The plane that a picture without -view 3d shows
static cutPlane planeOf(const domain& where, const pictureOptions& options)
{
    if (where.dimensions == 2)
    {
        if (options.cut)
        {
            throw userError
            (
                "A 2-D case has nothing to cut",
                {},
                "Leave -cut out: all its particles are shown"
            );
        }
        return {2, 0};
    }
    return options.cut
      ? *options.cut
      : cutPlane{2, 0.5*(where.lo.z + where.hi.z)};
}


//- 1234567 as 1 234 567
static std::string grouped(std::size_t n)
{
    std::string digits = std::to_string(n);
    for (int i = static_cast<int>(digits.size()) - 3; i > 0; i -= 3)
    {
        digits.insert(static_cast<std::size_t>(i), " ");
    }
    return digits;
}


image paint
(
    const std::vector<cloud>& clouds,
    const domain& where,
    double time,
    const pictureOptions& options
)
{
    checkDomain(where);
    const bool flat = where.dimensions == 2;
    if (options.view3d && flat)
    {
        throw userError
        (
            "A 2-D case has no 3-D view",
            {},
            "Leave -view out: all its particles are shown"
        );
    }
    const shownField field(clouds, options.field);
    const colourMap colours(options.colours);
    const cutPlane plane =
        options.view3d ? cutPlane{2, 0} : planeOf(where, options);
    const bool cuts = !options.view3d && !flat;
    const markedScene scene = collect
    (
        clouds,
        field,
        cuts ? std::optional(plane) : std::nullopt,
        where.spacing,
        options
    );

    const camera eye(options.azimuth, options.elevation);
    const vector size = where.hi - where.lo;
    const std::array<double, 2> extent = options.view3d
      ? seenExtent(eye, where)
      : std::array<double, 2>
        {
            plane.axis == 0 ? size.y : size.x,
            plane.axis == 2 ? size.y : size.z
        };
    const layout place = arrange(extent[0], extent[1], options);
    image picture(place.width, place.height);
    if (options.view3d)
    {
        paintSpace(picture, place, scene, where, eye, colours);
    }
    else
    {
        paintCut(picture, place, scene, where, plane, colours);
    }
    paintColourBar(picture, place, scene.range, colours);

    std::string subtitle = grouped(scene.marks.size()) + " particles";
    if (cuts)
    {
        subtitle += fmt::format
        (
            " at {} = {:.4g} m", "xyz"[plane.axis], plane.value
        );
    }
    if (!scene.marks.empty())
    {
        subtitle += fmt::format
        (
            ", {:.4g} to {:.4g}", scene.lowest, scene.highest
        );
    }
    paintTitle
    (
        picture,
        place,
        fmt::format("{}   t = {:.6g} s", field.title(), time),
        subtitle
    );
    return picture;
}

} // namespace gpuFsi
