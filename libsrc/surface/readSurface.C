#include "surface/readSurface.H"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/polygon_soup_io.h>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <numeric>
#include <sstream>
#include <tuple>

namespace gpuFsi
{

namespace
{

using kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using soupPoint = kernel::Point_3;
namespace fs = std::filesystem;

const char* const exportAgain =
    "Export the surface again, as STL, OBJ, PLY or OFF.";

void checkFile(const fs::path& file, const sourceSpan& where)
{
    if (!fs::is_regular_file(file))
    {
        throw userError
        (
            "Cannot find surface file " + file.string(),
            where,
            "The path is relative to the case, usually constant/triSurface."
        );
    }
    const std::string type = file.extension().string();
    const std::vector<std::string> known{".stl", ".obj", ".ply", ".off"};
    if (std::find(known.begin(), known.end(), type) == known.end())
    {
        throw userError
        (
            "Surface file " + file.string() + " has the unknown ending '"
          + type + "'",
            where,
            "Valid endings are .stl, .obj, .ply and .off."
        );
    }
    if (fs::file_size(file) == 0)
    {
        throw userError
        (
            "Surface file " + file.string() + " is empty",
            {file.string()},
            exportAgain
        );
    }
}

//- A binary STL states its length; other formats show their end to the reader
void checkStlLength(const fs::path& file)
{
    std::ifstream in(file, std::ios::binary);
    char head[84] = {};
    in.read(head, sizeof head);
    const std::uintmax_t size = fs::file_size(file);
    std::string start(head, std::size_t(in.gcount()));
    const bool solid = start.compare(0, 5, "solid") == 0;
    std::uint32_t nTriangles = 0;
    std::memcpy(&nTriangles, head + 80, 4);
    const std::uintmax_t expected = 84 + 50*std::uintmax_t(nTriangles);
    if (solid && size != expected)
    {
        std::string tail(std::min<std::uintmax_t>(size, 400), ' ');
        in.clear();
        in.seekg(std::streamoff(size - tail.size()));
        in.read(&tail[0], std::streamsize(tail.size()));
        if (tail.find("endsolid") == std::string::npos)
        {
            throw userError
            (
                "Surface file " + file.string()
              + " is cut short: it has no endsolid",
                {file.string()},
                exportAgain
            );
        }
        return;
    }
    if (size < expected || size < 84)
    {
        throw userError
        (
            fmt::format
            (
                "Surface file {} is cut short: {} bytes, but {} triangles"
                " take {}",
                file.string(), size, nTriangles, expected
            ),
            {file.string()},
            exportAgain
        );
    }
}

//- Readers stop at, or skip, words such as nan: say on which line they stand
void checkWords(const fs::path& file)
{
    std::ifstream in(file, std::ios::binary);
    std::string line;
    for (int number = 1; std::getline(in, line); ++number)
    {
        if (line.find('\0') != std::string::npos)
        {
            return;    // binary
        }
        std::istringstream words(line);
        std::string word;
        words >> word;
        const bool coordinates =
            word == "vertex" || word == "v" || word.empty()
         || std::strchr("+-.0123456789nNiI", word[0]);
        if (!coordinates || line.find_first_of("nNiI") == std::string::npos)
        {
            continue;
        }
        for (bool more = true; more; more = bool(words >> word))
        {
            const std::size_t sign = word.find_first_not_of("+-");
            std::string bare =
                sign == std::string::npos ? "" : word.substr(sign);
            std::transform
            (
                bare.begin(),
                bare.end(),
                bare.begin(),
                [](unsigned char c) { return char(std::tolower(c)); }
            );
            if (bare == "nan" || bare == "inf" || bare == "infinity")
            {
                throw userError
                (
                    "Surface file " + file.string() + " has the coordinate "
                  + word,
                    {file.string(), number, number},
                    "Coordinates must be finite. " + std::string(exportAgain)
                );
            }
        }
    }
}

void checkFinite
(
    const fs::path& file,
    const std::vector<soupPoint>& points,
    const std::vector<std::vector<std::size_t>>& polygons
)
{
    for (std::size_t i = 0; i < polygons.size(); ++i)
    {
        for (const std::size_t c : polygons[i])
        {
            const soupPoint& p = points[c];
            if
            (
                !std::isfinite(p.x()) || !std::isfinite(p.y())
             || !std::isfinite(p.z())
            )
            {
                throw userError
                (
                    fmt::format
                    (
                        "Surface file {}: triangle {} (from 0) has the corner"
                        " ({} {} {})",
                        file.string(), i, p.x(), p.y(), p.z()
                    ),
                    {file.string()},
                    "Coordinates must be finite. "
                  + std::string(exportAgain)
                );
            }
        }
    }
}

//- Number of each point among the different ones; equal ones share it
std::vector<int> mergePoints
(
    const std::vector<soupPoint>& points,
    double scale,
    std::vector<vector>& merged
)
{
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort
    (
        order.begin(),
        order.end(),
        [&](std::size_t a, std::size_t b)
        {
            const auto key = [&](std::size_t i)
            {
                const soupPoint& p = points[i];
                return std::make_tuple(p.x(), p.y(), p.z());
            };
            return std::make_pair(key(a), a) < std::make_pair(key(b), b);
        }
    );
    std::vector<int> number(points.size());
    for (std::size_t i = 0; i < order.size(); ++i)
    {
        const soupPoint& p = points[order[i]];
        if (i == 0 || p != points[order[i - 1]])
        {
            merged.push_back({scale*p.x(), scale*p.y(), scale*p.z()});
        }
        number[order[i]] = int(merged.size()) - 1;
    }
    return number;
}

bool hasNoArea(const triangleSurface& s, const std::array<int, 3>& t)
{
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0])
    {
        return true;
    }
    const auto point = [&](int i)
    {
        const vector& p = s.points[t[i]];
        return soupPoint(p.x, p.y, p.z);
    };
    return CGAL::collinear(point(0), point(1), point(2));
}

} // namespace

triangleSurface readSurface
(
    const fs::path& file,
    double scale,
    const sourceSpan& where,
    readReport& report
)
{
    checkFile(file, where);
    if (file.extension() == ".stl")
    {
        checkStlLength(file);
    }
    checkWords(file);
    std::vector<soupPoint> points;
    std::vector<std::vector<std::size_t>> polygons;
    bool read = false;
    try
    {
        read = CGAL::IO::read_polygon_soup
        (
            file.string(), points, polygons, CGAL::parameters::verbose(false)
        );
    }
    catch (const std::exception&)
    {}
    const auto tooHigh = [&](const std::vector<std::size_t>& polygon)
    {
        return std::any_of
        (
            polygon.begin(),
            polygon.end(),
            [&](std::size_t c) { return c >= points.size(); }
        );
    };
    if
    (
        !read || polygons.empty()
     || std::any_of(polygons.begin(), polygons.end(), tooHigh)
    )
    {
        throw userError
        (
            fmt::format
            (
                "Cannot read surface file {}: it is damaged, cut short or not"
                " of the type that its ending says ({} faces found)",
                file.string(), polygons.size()
            ),
            {file.string()},
            exportAgain
        );
    }
    checkFinite(file, points, polygons);

    triangleSurface surface;
    const std::vector<int> number = mergePoints(points, scale, surface.points);
    report.nPolygons = polygons.size();
    for (const auto& polygon : polygons)
    {
        for (std::size_t i = 2; i < polygon.size(); ++i)
        {
            const std::array<int, 3> t
            {
                number[polygon[0]], number[polygon[i - 1]], number[polygon[i]]
            };
            if (hasNoArea(surface, t))
            {
                ++report.nDegenerate;
                continue;
            }
            surface.triangles.push_back(t);
        }
    }
    if (surface.triangles.empty())
    {
        throw userError
        (
            "Surface file " + file.string() + " has no triangle with an area",
            {file.string()},
            exportAgain
        );
    }
    return surface;
}

} // namespace gpuFsi
