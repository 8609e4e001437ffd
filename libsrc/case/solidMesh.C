#include "case/solidMesh.H"

#include "case/domain.H"
#include "case/fieldIO.H"
#include "case/nearestImage.H"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gpuFsi
{

namespace
{

[[noreturn]] void reject
(
    const std::filesystem::path& file,
    const std::string& message
)
{
    throw userError
    (
        message,
        {file.string()},
        "constant/solid and constant/domain must come from the same run of"
        " seedParticles: run it again."
    );
}

std::vector<int> labels(const cloudField& field)
{
    return {field.values.begin(), field.values.end()};
}

cloudField labelField(const std::string& name, const std::vector<int>& values)
{
    return {"labelField", name, {values.begin(), values.end()}};
}

void checkRange
(
    const std::filesystem::path& file,
    const std::vector<int>& values,
    int low,
    std::size_t end
)
{
    for (const int v : values)
    {
        if (v < low || (v >= 0 && std::size_t(v) >= end))
        {
            reject
            (
                file,
                fmt::format
                (
                    "{} holds {}, out of the range from {} to {}",
                    file.filename().string(), v, low, long(end) - 1
                )
            );
        }
    }
}

} // namespace

vector solidMesh::offset(const vector& x, const vector& y) const
{
    return nearestImage::of(period).offset(x, y);
}


double solidMesh::volume(const std::array<int, 8>& cell) const
{
    // From a corner: no loss of digits far from the origin
    std::array<vector, 8> x{};
    for (int i = 0; i < (dimensions == 2 ? 4 : 8); ++i)
    {
        x[i] = offset(points[cell[i]], points[cell[0]]);
    }
    if (dimensions == 2)
    {
        return 0.5*cross(x[3] - x[0], x[2] - x[1]).z;
    }
    // Under a bilinear face: the mean of its two triangulations
    double six = 0;
    for (const auto& f : hexFaces)
    {
        const vector& a = x[f[0]];
        const vector& b = x[f[1]];
        const vector& c = x[f[2]];
        const vector& d = x[f[3]];
        six += 0.5*
        (
            dot(a, cross(b, c)) + dot(a, cross(c, d))
          + dot(a, cross(b, d)) + dot(b, cross(c, d))
        );
    }
    return six/6;
}


std::size_t solidMesh::write
(
    const std::filesystem::path& casePath,
    const writeOptions& options
) const
{
    const std::filesystem::path folder = casePath/"constant/solid";
    std::vector<int> corners;
    for (const auto& cell : cells)
    {
        corners.insert
        (
            corners.end(),
            cell.begin(),
            cell.begin() + (dimensions == 2 ? 4 : 8)
        );
    }
    cloud all;
    all.addVector("points", points);
    all.fields.push_back(labelField("solid", solid));
    all.fields.push_back(labelField("part", part));
    all.fields.push_back(labelField("cells", corners));
    writeOptions exact = options;
    exact.precision = 17;
    std::size_t bytes = 0;
    for (const cloudField& field : all.fields)
    {
        bytes += writeField
        (
            folder, "constant/solid", fieldView(field), exact
        );
    }
    return bytes;
}


void solidMesh::read(const std::filesystem::path& casePath)
{
    *this = {};
    const domain d = domain::read(casePath);
    dimensions = d.dimensions;
    names = d.solids;
    if (names.empty())
    {
        return;
    }
    for (const domain::solidPart& p : d.solidParts)
    {
        const auto at = std::find(names.begin(), names.end(), p.solid);
        parts.push_back({int(at - names.begin()), p.name});
    }
    const vector size = d.hi - d.lo;
    period =
    {
        d.periodic[0] ? size.x : 0,
        d.periodic[1] ? size.y : 0,
        d.periodic[2] ? size.z : 0
    };

    const std::filesystem::path folder = casePath/"constant/solid";
    const auto field = [&]
    (
        const char* name,
        const char* cls,
        std::optional<std::size_t> n
    )
    {
        cloudField f = readField(folder/name, n);
        if (f.cls != cls)
        {
            reject(folder/name, "Class " + f.cls + " is not " + cls);
        }
        return f;
    };
    const cloudField x = field("points", "vectorField", {});
    for (std::size_t i = 0; i < x.size(); ++i)
    {
        points.push_back
        ({
            x.values[3*i], x.values[3*i + 1], x.values[3*i + 2]
        });
    }
    solid = labels(field("solid", "labelField", points.size()));
    part = labels(field("part", "labelField", points.size()));
    checkRange(folder/"solid", solid, 0, names.size());
    checkRange(folder/"part", part, -1, parts.size());

    const std::vector<int> corners = labels(field("cells", "labelField", {}));
    checkRange(folder/"cells", corners, 0, points.size());
    const std::size_t n = dimensions == 2 ? 4 : 8;
    if (corners.size() % n)
    {
        reject
        (
            folder/"cells",
            fmt::format("{} labels are not {} a cell", corners.size(), n)
        );
    }
    for (std::size_t i = 0; i < corners.size(); i += n)
    {
        std::array<int, 8> cell;
        cell.fill(-1);
        std::copy_n(corners.begin() + i, n, cell.begin());
        if (!(volume(cell) > 0))
        {
            reject
            (
                folder/"cells",
                fmt::format
                (
                    "Cell {} has the volume {:.6g}", i/n, volume(cell)
                )
            );
        }
        cells.push_back(cell);
    }
}

} // namespace gpuFsi
