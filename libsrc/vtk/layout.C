#include "vtk/marks.H"
#include "vtk/ticks.H"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gpuFsi
{

layout arrange
(
    double sceneWidth,
    double sceneHeight,
    const pictureOptions& options
)
{
    layout place{};
    place.width = options.width;
    place.height = options.height;
    place.barBelow = sceneWidth > 2.2*sceneHeight;
    const double shortest = options.height > 0
      ? std::min(options.width, 3*options.height/2)
      : options.width;
    place.font = std::clamp(shortest/66.0, 9.0, 80.0);

    // Margins in letters: title above, axis left and below, bar
    const double f = place.font;
    const int left = std::lround(6.5*f), top = std::lround(6.8*f);
    const int right = std::lround((place.barBelow ? 3 : 10)*f);
    const int bottom = std::lround((place.barBelow ? 9 : 5)*f);
    const double across = std::max(16, place.width - left - right);
    if (place.height <= 0)
    {
        const double fits = across*sceneHeight/sceneWidth;
        const double limited =
            std::clamp(fits, 8*f, 0.95*options.width);
        place.height = top + bottom + static_cast<int>(std::lround(limited));
    }
    const double down = std::max(16, place.height - top - bottom);
    place.scale = std::min(across/sceneWidth, down/sceneHeight);

    const int w = std::max(1L, std::lround(place.scale*sceneWidth));
    const int h = std::max(1L, std::lround(place.scale*sceneHeight));
    place.left = left + (static_cast<int>(across) - w)/2;
    place.top = top + (static_cast<int>(down) - h)/2;
    place.right = place.left + w;
    place.bottom = place.top + h;
    return place;
}


int supersampling(const layout& place)
{
    const double pixels = 1.0*place.width*place.height;
    return pixels < 8e6 ? 3 : pixels < 20e6 ? 2 : 1;
}


void paintTitle
(
    image& picture,
    const layout& place,
    const std::string& title,
    const std::string& subtitle
)
{
    const double f = place.font;
    const int x = std::lround(1.5*f);
    picture.text(x, std::lround(1.7*f), title, 1.4*f, ink, {-1, 0});
    picture.text(x, std::lround(3.5*f), subtitle, 0.9*f, faintInk, {-1, 0});
}


void paintColourBar
(
    image& picture,
    const layout& place,
    const std::array<double, 2>& range,
    const colourMap& colours
)
{
    const double f = place.font;
    const auto letters = [f](double n)
    {
        return static_cast<int>(std::lround(n*f));
    };
    const auto [lo, hi] = range;
    const bool flat = place.barBelow;

    // Along the plot's side, but never shorter than its numbers need
    int begin = flat ? place.left : place.top;
    int end = flat ? place.right : place.bottom;
    const int least = std::min(letters(10), flat ? place.width : place.height);
    if (end - begin < least)
    {
        const int middle = (begin + end)/2;
        begin = middle - least/2;
        end = middle + least/2;
    }
    const int side =
        flat ? place.bottom + letters(5) : place.right + letters(2);
    const int thick = letters(1.1);
    for (int i = begin; i < end; ++i)
    {
        const double t = (i - begin + 0.5)/(end - begin);
        if (flat)
        {
            picture.fill(i, side, i + 1, side + thick, colours(t));
        }
        else
        {
            picture.fill(side, i, side + thick, i + 1, colours(1 - t));
        }
    }
    if (flat)
    {
        picture.frame(begin, side, end, side + thick, ink);
    }
    else
    {
        picture.frame(side, begin, side + thick, end, ink);
    }

    const int about = std::clamp((end - begin)/letters(flat ? 7 : 3.5), 2, 6);
    const tickMarks marks = ticks(lo, hi, about);
    const int length = letters(0.4);
    for (std::size_t k = 0; k < marks.at.size(); ++k)
    {
        const double t = (marks.at[k] - lo)/(hi - lo);
        const long along = std::lround(t*(end - begin - 1));
        if (flat)
        {
            const int x = begin + static_cast<int>(along);
            const int y = side + thick;
            picture.fill(x, y, x + 1, y + length, ink);
            picture.text(x, y + letters(1.1), marks.labels[k], f, ink, {0, 0});
        }
        else
        {
            const int x = side + thick;
            const int y = end - 1 - static_cast<int>(along);
            picture.fill(x, y, x + length, y + 1, ink);
            picture.text(x + letters(0.8), y, marks.labels[k], f, ink, {-1, 0});
        }
    }
    if (marks.exponent != 0)
    {
        const std::string factor = fmt::format("x 1e{}", marks.exponent);
        if (flat)
        {
            const int y = side + thick + letters(2.5);
            picture.text(end, y, factor, 0.9*f, ink, {1, 0});
        }
        else
        {
            picture.text
            (
                side, begin - letters(1), factor, 0.9*f, ink, {-1, 0}
            );
        }
    }
}

} // namespace gpuFsi
