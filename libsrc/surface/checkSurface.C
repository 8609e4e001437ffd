#include "surface/checkSurface.H"

#include "base/error.H"
#include "surface/polygonMesh.H"
#include "surface/surfaceParts.H"

#include <fmt/format.h>

#include <algorithm>

namespace gpuFsi
{

namespace
{

//- The first few places of one kind of defect, and how many there are
class defectList
{
public:

    void add(const std::string& place)
    {
        if (++count_ <= 3)
        {
            places_ += "\n    " + place;
        }
    }

    void fail
    (
        const std::string& file,
        const std::string& what,
        const std::string& remedy
    ) const
    {
        if (count_)
        {
            throw userError
            (
                fmt::format("Surface {}: {} {}", file, count_, what) + places_
              + (count_ > 3 ? "\n    ..." : ""),
                {file},
                remedy
            );
        }
    }

private:

    std::size_t count_ = 0;
    std::string places_;
};

std::string text(const vector& p)
{
    return fmt::format("({:.9g} {:.9g} {:.9g})", p.x, p.y, p.z);
}

std::string text(const triangleSurface& s, const triangleEdge& e)
{
    return "edge " + text(s.points[e.low]) + " to " + text(s.points[e.high]);
}

void checkEdges
(
    const triangleSurface& s,
    const std::vector<triangleEdge>& edges,
    const std::string& file
)
{
    defectList open, many, turned;
    for (std::size_t first = 0; first < edges.size(); )
    {
        const triangleEdge& e = edges[first];
        std::size_t last = first;
        std::string triangles;
        while
        (
            last < edges.size()
         && edges[last].low == e.low && edges[last].high == e.high
        )
        {
            triangles += fmt::format(" {}", edges[last++].triangle);
        }
        const std::size_t n = last - first;
        if (n == 1)
        {
            open.add(text(s, e) + " of triangle" + triangles);
        }
        else if (n > 2)
        {
            many.add(text(s, e) + " of triangles" + triangles);
        }
        else if (e.reversed == edges[first + 1].reversed)
        {
            turned.add(text(s, e) + " of triangles" + triangles);
        }
        first = last;
    }
    many.fail
    (
        file,
        "non-manifold edges, of more than two triangles",
        "Remove double or inner triangles; export one closed solid."
    );
    open.fail
    (
        file,
        "open edges: the surface has holes",
        "Close the holes. If the parts only seem to meet, merge points that"
        " differ by round-off before exporting."
    );
    turned.fail
    (
        file,
        "edges whose two triangles face opposite ways",
        "Make the normals consistent, pointing out of the shape."
    );
}

std::pair<vector, vector> boxOf(const triangleSurface& s)
{
    vector lo = s.points[0];
    vector hi = lo;
    for (const vector& p : s.points)
    {
        lo = {std::min(lo.x, p.x), std::min(lo.y, p.y), std::min(lo.z, p.z)};
        hi = {std::max(hi.x, p.x), std::max(hi.y, p.y), std::max(hi.z, p.z)};
    }
    return {lo, hi};
}

//- A part within an odd number of others is a cavity: it faces inwards
void checkOrientation
(
    const triangleSurface& s,
    const std::vector<int>& partOf,
    const std::string& file
)
{
    const int nParts = *std::max_element(partOf.begin(), partOf.end()) + 1;
    std::vector<triangleSurface> parts;
    for (int p = 0; p < nParts; ++p)
    {
        parts.push_back(extractPart(s, partOf, p));
    }
    defectList insideOut;
    for (int p = 0; p < nParts; ++p)
    {
        const vector& at = parts[p].points[0];
        bool cavity = false;
        for (int q = 0; q < nParts; ++q)
        {
            const auto b = boxOf(parts[q]);
            const bool near = q != p
             && at.x > b.first.x && at.x < b.second.x
             && at.y > b.first.y && at.y < b.second.y
             && at.z > b.first.z && at.z < b.second.z;
            cavity ^= near && sideOf(parts[q], {at})[0] > 0;
        }
        const double volume = parts[p].volume();
        if (volume < 0 ? !cavity : cavity)
        {
            insideOut.add
            (
                fmt::format
                (
                    "the {} at {}, {} triangles, volume {:.6g}",
                    cavity ? "cavity" : "part", text(at),
                    parts[p].triangles.size(), volume
                )
            );
        }
    }
    insideOut.fail
    (
        file,
        "parts are inside out",
        "Flip the normals: they point out of the solid that the surface"
        " encloses (into a cavity). For fluid around it write side outside."
    );
}

} // namespace

void checkSurface(const triangleSurface& s, const std::string& file)
{
    const std::vector<triangleEdge> edges = sortedEdges(s);
    checkEdges(s, edges, file);

    defectList cuts;
    for (const auto& [a, b] : selfIntersections(s))
    {
        cuts.add
        (
            fmt::format("triangles {} and {} near ", a, b)
          + text(s.corner(a, 0))
        );
    }
    cuts.fail
    (
        file,
        "pairs of triangles cut each other",
        "Unite overlapping parts (a boolean union) before exporting, or give"
        " each part as a region of its own."
    );
    checkOrientation(s, connectedParts(s, edges), file);
}

} // namespace gpuFsi
