#include "vtk/colourMap.H"

#include "base/error.H"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace gpuFsi
{

namespace
{

//- Evenly spaced; a smooth curve through them leaves no visible bands
using controlPoints = std::vector<std::array<double, 3>>;

const std::map<std::string, controlPoints>& maps()
{
    static const std::map<std::string, controlPoints> all
    {
        {
            "coolToWarm",
            {
                {59, 76, 192}, {98, 130, 234}, {141, 176, 254},
                {184, 208, 249}, {221, 221, 221}, {245, 196, 173},
                {244, 154, 123}, {222, 96, 77}, {180, 4, 38}
            }
        },
        {
            "viridis",
            {
                {68, 1, 84}, {71, 44, 122}, {59, 81, 139},
                {44, 113, 142}, {33, 144, 141}, {39, 173, 129},
                {92, 200, 99}, {170, 220, 50}, {253, 231, 37}
            }
        },
        {
            "grey",
            {{30, 30, 30}, {82, 82, 82}, {134, 134, 134},
                {186, 186, 186}, {238, 238, 238}}
        }
    };
    return all;
}


//- Catmull-Rom curve, ends mirrored
double curve(double a, double b, double c, double d, double t)
{
    return b + 0.5*t*((c - a)
        + t*((2*a - 5*b + 4*c - d) + t*(3*(b - c) + d - a)));
}

} // namespace


std::vector<std::string> colourMap::names()
{
    std::vector<std::string> list;
    for (const auto& map : maps())
    {
        list.push_back(map.first);
    }
    return list;
}


colourMap::colourMap(const std::string& name)
:
    table_(256)
{
    const auto found = maps().find(name);
    if (found == maps().end())
    {
        throw userError(unknownChoice("colours", name, names()));
    }
    const controlPoints& points = found->second;
    const int last = static_cast<int>(points.size()) - 1;
    for (int i = 0; i < 256; ++i)
    {
        const double place = i/255.0*last;
        const int k = std::min(static_cast<int>(place), last - 1);
        unsigned char channel[3];
        for (int c = 0; c < 3; ++c)
        {
            const double b = points[k][c], d = points[k + 1][c];
            const double before = k > 0 ? points[k - 1][c] : 2*b - d;
            const double after = k + 1 < last ? points[k + 2][c] : 2*d - b;
            const double v = curve(before, b, d, after, place - k);
            channel[c] = static_cast<unsigned char>
            (
                std::lround(std::clamp(v, 0.0, 255.0))
            );
        }
        table_[i] = {channel[0], channel[1], channel[2]};
    }
}


rgb colourMap::operator()(double t) const
{
    return table_[std::lround(255*std::clamp(t, 0.0, 1.0))];
}

} // namespace gpuFsi
