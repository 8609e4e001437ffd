#include "vtk/marks.H"
#include "vtk/raster.H"
#include "vtk/ticks.H"

#include <algorithm>
#include <cmath>

namespace gpuFsi
{

namespace
{

double component(const vector& p, int axis)
{
    return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
}


void paintAxes
(
    image& picture,
    const layout& place,
    const domain& where,
    int a,
    int b
)
{
    static const char* const names[]{"x", "y", "z"};
    const double f = place.font;
    const auto letters = [f](double n)
    {
        return static_cast<int>(std::lround(n*f));
    };
    const int length = letters(0.4);
    picture.frame
    (
        place.left - 1, place.top - 1, place.right + 1, place.bottom + 1, ink
    );

    const double loA = component(where.lo, a), hiA = component(where.hi, a);
    const double loB = component(where.lo, b), hiB = component(where.hi, b);
    const double largest = std::max
    (
        {std::abs(loA), std::abs(hiA), std::abs(loB), std::abs(hiB)}
    );
    const int wide = place.right - place.left;
    const tickMarks across =
        ticks(loA, hiA, std::clamp(wide/letters(5.5), 1, 8), largest);
    for (std::size_t k = 0; k < across.at.size(); ++k)
    {
        const long along = std::lround(place.scale*(across.at[k] - loA));
        const int x = place.left + std::min(static_cast<int>(along), wide);
        const int y = place.bottom + 1;
        picture.fill(x, y, x + 1, y + length, ink);
        picture.text(x, y + letters(1.1), across.labels[k], f, ink, {0, 0});
    }
    picture.text
    (
        (place.left + place.right)/2,
        place.bottom + letters(2.9),
        lengthLabel(names[a], across.exponent),
        f,
        ink,
        {0, 0}
    );

    const int high = place.bottom - place.top;
    const tickMarks up =
        ticks(loB, hiB, std::clamp(high/letters(3.5), 1, 8), largest);
    for (std::size_t k = 0; k < up.at.size(); ++k)
    {
        const long along = std::lround(place.scale*(up.at[k] - loB));
        const int x = place.left - 1;
        const int y = place.bottom - std::min(static_cast<int>(along), high);
        picture.fill(x - length, y, x, y + 1, ink);
        picture.text(x - letters(0.7), y, up.labels[k], f, ink, {1, 0});
    }
    picture.text
    (
        place.left - letters(0.7),
        place.top - letters(1.2),
        lengthLabel(names[b], up.exponent),
        f,
        ink,
        {1, 0}
    );
}

} // namespace


void paintCut
(
    image& picture,
    const layout& place,
    const markedScene& scene,
    const domain& where,
    const cutPlane& plane,
    const colourMap& colours
)
{
    const int a = plane.axis == 0 ? 1 : 0;
    const int b = plane.axis == 2 ? 1 : 2;
    const int w = place.right - place.left, h = place.bottom - place.top;
    raster canvas(w, h, supersampling(place));

    // Reaches the corners of a lattice's square; a sample at the least
    const double radius =
        std::max(0.71*where.spacing*place.scale, 0.7/canvas.factor());

    // Of two layers of a lattice as far from the plane the lower one shows
    const double planeValue = plane.value - 1e-3*where.spacing;
    for (const mark& m : scene.marks)
    {
        const double x = component(m.p, a) - component(where.lo, a);
        const double y = component(where.hi, b) - component(m.p, b);
        const double off = component(m.p, plane.axis) - planeValue;
        canvas.cell
        (
            place.scale*x,
            place.scale*y,
            radius,
            where.dimensions == 2 ? 0 : place.scale*off,
            colourOf(m, scene, colours)
        );
    }
    canvas.closeGaps(0.8*where.spacing*place.scale);
    canvas.putOn(picture, place.left, place.top);
    paintAxes(picture, place, where, a, b);
}

} // namespace gpuFsi
