#include "vtk/raster.H"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace gpuFsi
{

static constexpr float infinite = std::numeric_limits<float>::infinity();


static double sqr(double v)
{
    return v*v;
}


static rgb scaled(rgb colour, double shade, double shine = 0)
{
    const auto channel = [&](unsigned char c)
    {
        return static_cast<unsigned char>
        (
            std::clamp(c*shade + 255*shine, 0.0, 255.0)
        );
    };
    return {channel(colour.r), channel(colour.g), channel(colour.b)};
}


raster::raster(int width, int height, int factor)
:
    factor_(factor),
    width_(width*factor),
    height_(height*factor),
    colour_(static_cast<std::size_t>(width_)*height_, rgb{255, 255, 255}),
    depth_(colour_.size(), infinite)
{}


//- paint(sample index, dx, dy) with dx, dy of the sample from the centre, in
//  samples, wherever dx^2 + dy^2 <= radius^2
template<class Paint>
void raster::overDisc
(
    double x,
    double y,
    double radius,
    const Paint& paint
)
{
    // Limits in floating point first: a far particle overflows an int
    const auto first = [](double low)
    {
        return static_cast<int>(std::clamp(std::ceil(low), 0.0, 1e9));
    };
    const auto last = [](double high, int size)
    {
        return static_cast<int>
        (
            std::clamp(std::floor(high), -1.0, size - 1.0)
        );
    };
    const int y0 = first(y - radius - 0.5);
    const int y1 = last(y + radius - 0.5, height_);
    for (int j = y0; j <= y1; ++j)
    {
        const double dy = j + 0.5 - y;
        const double half = std::sqrt(std::max(0.0, radius*radius - dy*dy));
        const int x0 = first(x - half - 0.5);
        const int x1 = last(x + half - 0.5, width_);
        for (int i = x0; i <= x1; ++i)
        {
            paint
            (
                static_cast<std::size_t>(j)*width_ + i,
                i + 0.5 - x,
                dy
            );
        }
    }
}


void raster::cell
(
    double x,
    double y,
    double radius,
    double offset,
    rgb colour
)
{
    const double base = offset*offset*factor_*factor_;
    const auto paint = [&](std::size_t sample, double dx, double dy)
    {
        const auto depth = static_cast<float>(dx*dx + dy*dy + base);
        if (depth < depth_[sample])
        {
            depth_[sample] = depth;
            colour_[sample] = colour;
        }
    };
    overDisc(factor_*x, factor_*y, factor_*radius, paint);
}


void raster::closeGaps(double reach)
{
    const int limit = std::max(1, static_cast<int>(factor_*reach));
    static constexpr int ways[4][2]{{-1, 0}, {1, 0}, {0, -1}, {0, 1}};
    std::vector<std::pair<std::size_t, rgb>> filled;
    const auto firstAlong = [&](int i, int j, const int (&way)[2])
    {
        for (int s = 1; s <= limit; ++s)
        {
            const int x = i + s*way[0], y = j + s*way[1];
            if (x < 0 || y < 0 || x >= width_ || y >= height_)
            {
                break;
            }
            if (depth_[static_cast<std::size_t>(y)*width_ + x] != infinite)
            {
                return s;
            }
        }
        return limit + 1;
    };
    for (int j = 0; j < height_; ++j)
    {
        for (int i = 0; i < width_; ++i)
        {
            const std::size_t sample = static_cast<std::size_t>(j)*width_ + i;
            if (depth_[sample] != infinite)
            {
                continue;
            }
            int nearest = limit + 1, x = i, y = j;
            bool enclosed = true;
            for (int w = 0; w < 4 && enclosed; ++w)
            {
                const int s = firstAlong(i, j, ways[w]);
                enclosed = s <= limit;
                if (s < nearest)
                {
                    nearest = s;
                    x = i + s*ways[w][0];
                    y = j + s*ways[w][1];
                }
            }
            if (enclosed)
            {
                filled.emplace_back
                (
                    sample,
                    colour_[static_cast<std::size_t>(y)*width_ + x]
                );
            }
        }
    }
    for (const auto& [sample, colour] : filled)
    {
        colour_[sample] = colour;
        depth_[sample] = 0;
    }
}


void raster::sphere
(
    double x,
    double y,
    double radius,
    double depth,
    rgb colour
)
{
    // Towards the light and half-way between light and onlooker
    static constexpr double light[3]{-0.40, -0.58, 0.71};
    static constexpr double half[3]{-0.2163, -0.3136, 0.9246};
    const double r = factor_*radius;
    const auto front = static_cast<float>(factor_*depth - r);
    const auto paint = [&](std::size_t sample, double dx, double dy)
    {
        if (front >= depth_[sample])
        {
            return;    // most of a cloud is hidden: no root for these
        }
        const double dz = std::sqrt(std::max(0.0, r*r - dx*dx - dy*dy));
        const auto z = static_cast<float>(factor_*depth - dz);
        if (z >= depth_[sample])
        {
            return;
        }
        const double nx = dx/r, ny = dy/r, nz = dz/r;
        const double lit =
            std::max(0.0, nx*light[0] + ny*light[1] + nz*light[2]);
        const double half2 = sqr(nx*half[0] + ny*half[1] + nz*half[2]);
        const double half8 = sqr(sqr(half2));
        depth_[sample] = z;
        colour_[sample] =
            scaled(colour, 0.58 + 0.5*lit, 0.10*half8*sqr(half8));
    };
    overDisc(factor_*x, factor_*y, r, paint);
}


void raster::line
(
    const double (&from)[3],
    const double (&to)[3],
    double width,
    rgb colour
)
{
    const double length = std::hypot(to[0] - from[0], to[1] - from[1]);
    const int n = 1 + static_cast<int>(2*factor_*length);
    for (int i = 0; i <= n; ++i)
    {
        const double t = static_cast<double>(i)/n;
        double at[3];
        for (int c = 0; c < 3; ++c)
        {
            at[c] = factor_*(from[c] + t*(to[c] - from[c]));
        }
        const auto z = static_cast<float>(at[2]);
        const auto paint = [&](std::size_t sample, double, double)
        {
            if (z < depth_[sample])
            {
                depth_[sample] = z;
                colour_[sample] = colour;
            }
        };
        overDisc(at[0], at[1], 0.5*factor_*width, paint);
    }
}


void raster::shadeHollows(double reach, double strength)
{
    // Opposite neighbours in pairs: a plane has no hollow, however it tilts
    static constexpr double axes[4][2]
    {
        {1, 0}, {0.7, 0.7}, {0, 1}, {-0.7, 0.7}
    };
    const double scale = factor_*reach;
    int steps[4][2];
    for (int a = 0; a < 4; ++a)
    {
        steps[a][0] = static_cast<int>(std::lround(scale*axes[a][0]));
        steps[a][1] = static_cast<int>(std::lround(scale*axes[a][1]));
    }
    const auto depthAt = [&](int x, int y)
    {
        const bool within = x >= 0 && y >= 0 && x < width_ && y < height_;
        return within
          ? depth_[static_cast<std::size_t>(y)*width_ + x]
          : infinite;
    };
    for (int j = 0; j < height_; ++j)
    {
        for (int i = 0; i < width_; ++i)
        {
            const std::size_t sample = static_cast<std::size_t>(j)*width_ + i;
            const float here = depth_[sample];
            if (here == infinite)
            {
                continue;
            }
            double hollow = 0;
            for (const auto& [dx, dy] : steps)
            {
                const double around =
                    0.5*(depthAt(i + dx, j + dy) + depthAt(i - dx, j - dy));
                hollow += std::clamp((here - around)/scale, 0.0, 1.0);
            }
            colour_[sample] =
                scaled(colour_[sample], std::exp(-strength*hollow/4));
        }
    }
}


void raster::putOn(image& picture, int x, int y) const
{
    const int samples = factor_*factor_;
    for (int j = 0; j < height_/factor_; ++j)
    {
        for (int i = 0; i < width_/factor_; ++i)
        {
            int r = samples/2, g = r, b = r;
            for (int s = 0; s < samples; ++s)
            {
                const rgb& c = colour_
                [
                    static_cast<std::size_t>(j*factor_ + s/factor_)*width_
                  + i*factor_ + s%factor_
                ];
                r += c.r;
                g += c.g;
                b += c.b;
            }
            picture.at(x + i, y + j) =
            {
                static_cast<unsigned char>(r/samples),
                static_cast<unsigned char>(g/samples),
                static_cast<unsigned char>(b/samples)
            };
        }
    }
}

} // namespace gpuFsi
