#include "vtk/marks.H"
#include "vtk/raster.H"
#include "vtk/ticks.H"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gpuFsi
{

camera::camera(double azimuth, double elevation)
{
    const double radians = std::acos(-1.0)/180;
    const double a = azimuth*radians, e = elevation*radians;
    towards = {std::cos(e)*std::cos(a), std::cos(e)*std::sin(a), std::sin(e)};
    right = {-std::sin(a), std::cos(a), 0};
    up = cross(towards, right);
}


namespace
{

//- Bits of the number choose hi (1) or lo (0) for x, y, z
vector corner(const domain& where, int bits)
{
    return
    {
        bits & 1 ? where.hi.x : where.lo.x,
        bits & 2 ? where.hi.y : where.lo.y,
        bits & 4 ? where.hi.z : where.lo.z
    };
}


vector centreOf(const domain& where)
{
    return 0.5*(where.lo + where.hi);
}


//- Pixels of the whole picture, y down, and depth
struct seen
{
    double x, y, depth;
};

class projection
{
public:

    projection(const layout& place, const domain& where, const camera& eye)
    :
        eye_(eye),
        centre_(centreOf(where)),
        scale_(place.scale),
        x_(0.5*(place.left + place.right)),
        y_(0.5*(place.top + place.bottom))
    {}

    seen operator()(const vector& p) const
    {
        const vector d = p - centre_;
        return
        {
            x_ + scale_*dot(d, eye_.right),
            y_ - scale_*dot(d, eye_.up),
            -scale_*dot(d, eye_.towards)
        };
    }

private:

    const camera& eye_;
    vector centre_;
    double scale_, x_, y_;
};


int nearestCorner(const domain& where, const projection& project)
{
    int nearest = 0;
    for (int bits = 1; bits < 8; ++bits)
    {
        const double depth = project(corner(where, bits)).depth;
        const double least = project(corner(where, nearest)).depth;
        nearest = depth < least - 1e-9 ? bits : nearest;
    }
    return nearest;
}


//- Edges that meet in front would cross the particles: left out. The others
//  come forward by lift (pixels), or particles at the walls would cut them
//  into dashes.
void paintBox
(
    raster& canvas,
    const domain& where,
    const projection& project,
    double lift
)
{
    const int front = nearestCorner(where, project);
    for (int bits = 0; bits < 8; ++bits)
    {
        for (int axis = 0; axis < 3; ++axis)
        {
            const int other = bits | (1 << axis);
            if (other == bits || bits == front || other == front)
            {
                continue;
            }
            const seen a = project(corner(where, bits));
            const seen b = project(corner(where, other));
            canvas.line
            (
                {a.x, a.y, a.depth - lift},
                {b.x, b.y, b.depth - lift},
                1.2,
                {150, 150, 150}
            );
        }
    }
}


//- The edge along an axis that carries its numbers: the lowest one seen for x
//  and y, the leftmost for z. Returns the corner where it begins.
int labelledEdge(const domain& where, const projection& project, int axis)
{
    int best = -1;
    double least = std::numeric_limits<double>::infinity();
    for (int bits = 0; bits < 8; ++bits)
    {
        if (bits & (1 << axis))
        {
            continue;
        }
        const seen a = project(corner(where, bits));
        const seen b = project(corner(where, bits | (1 << axis)));
        const double rank = axis == 2 ? a.x + b.x : -(a.y + b.y);
        if (rank < least - 1e-9)
        {
            least = rank;
            best = bits;
        }
    }
    return best;
}


void paintEdgeAxis
(
    image& picture,
    const layout& place,
    const domain& where,
    const projection& project,
    int axis
)
{
    static const char* const names[]{"x", "y", "z"};
    const int bits = labelledEdge(where, project, axis);
    const seen a = project(corner(where, bits));
    const seen b = project(corner(where, bits | (1 << axis)));
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    if (length < 2*place.font)
    {
        return;    // seen end on
    }

    // Unit normal of the edge in the picture, away from the box
    const seen middle = project(centreOf(where));
    double nx = (a.y - b.y)/length, ny = (b.x - a.x)/length;
    const double outward =
        nx*(0.5*(a.x + b.x) - middle.x) + ny*(0.5*(a.y + b.y) - middle.y);
    if (outward < 0)
    {
        nx = -nx;
        ny = -ny;
    }

    const double f = place.font;
    const double lo = axis == 0 ? where.lo.x
      : axis == 1 ? where.lo.y : where.lo.z;
    const double hi = axis == 0 ? where.hi.x
      : axis == 1 ? where.hi.y : where.hi.z;
    const int about = std::clamp(static_cast<int>(length/(5*f)), 1, 6);
    const double largest = std::max
    ({
        std::abs(where.lo.x), std::abs(where.lo.y), std::abs(where.lo.z),
        std::abs(where.hi.x), std::abs(where.hi.y), std::abs(where.hi.z)
    });
    const tickMarks marks = ticks(lo, hi, about, largest);
    double widest = 0;
    const auto put = [&](double t, double gap, const std::string& words)
    {
        const double w = image::textWidth(words, f);
        const double away =
            gap + 0.5*std::abs(nx)*w + 0.4*std::abs(ny)*f;
        widest = std::max(widest, w);
        picture.text
        (
            static_cast<int>(std::lround(a.x + t*(b.x - a.x) + nx*away)),
            static_cast<int>(std::lround(a.y + t*(b.y - a.y) + ny*away)),
            words,
            f,
            ink,
            {0, 0}
        );
    };
    for (std::size_t k = 0; k < marks.at.size(); ++k)
    {
        const double t = (marks.at[k] - lo)/(hi - lo);
        const double x = a.x + t*(b.x - a.x), y = a.y + t*(b.y - a.y);
        for (double s = 0; s < 0.4*f; s += 0.25)
        {
            const int px = static_cast<int>(std::lround(x + s*nx));
            const int py = static_cast<int>(std::lround(y + s*ny));
            picture.fill(px, py, px + 1, py + 1, ink);
        }

        // Numbers of x and y would meet at their common corner
        const double toEnd = length*std::min(t, 1 - t);
        if (axis != 1 || toEnd > 1.5*f)
        {
            put(t, 0.7*f, marks.labels[k]);
        }
    }
    const double beyond = 1.4*f + std::abs(nx)*widest + 0.8*std::abs(ny)*f;
    put(0.5, beyond, lengthLabel(names[axis], marks.exponent));
}

} // namespace


std::array<double, 2> seenExtent(const camera& eye, const domain& where)
{
    // The box is symmetric about its centre
    double across = 0, upwards = 0;
    for (int bits = 0; bits < 8; ++bits)
    {
        const vector d = corner(where, bits) - centreOf(where);
        across = std::max(across, 2*dot(d, eye.right));
        upwards = std::max(upwards, 2*dot(d, eye.up));
    }
    return {across, upwards};
}


void paintSpace
(
    image& picture,
    const layout& place,
    const markedScene& scene,
    const domain& where,
    const camera& eye,
    const colourMap& colours
)
{
    const projection project(place, where, eye);
    raster canvas(place.width, place.height, supersampling(place));

    // Touching spheres of a lattice leave gaps between them: slightly larger
    const double radius =
        std::max(0.6*where.spacing*place.scale, 1.0/canvas.factor());
    for (const mark& m : scene.marks)
    {
        const seen at = project(m.p);
        canvas.sphere
        (
            at.x, at.y, radius, at.depth, colourOf(m, scene, colours)
        );
    }
    canvas.shadeHollows(std::max(1.0, 4*radius), 0.8);
    paintBox(canvas, where, project, 2*radius);
    canvas.putOn(picture, 0, 0);
    for (int axis = 0; axis < 3; ++axis)
    {
        paintEdgeAxis(picture, place, where, project, axis);
    }
}

} // namespace gpuFsi
