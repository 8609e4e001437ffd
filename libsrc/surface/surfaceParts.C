#include "surface/surfaceParts.H"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace gpuFsi
{

std::vector<triangleEdge> sortedEdges(const triangleSurface& s)
{
    std::vector<triangleEdge> edges;
    edges.reserve(3*s.triangles.size());
    for (std::size_t t = 0; t < s.triangles.size(); ++t)
    {
        for (int i = 0; i < 3; ++i)
        {
            const int a = s.triangles[t][i];
            const int b = s.triangles[t][(i + 1) % 3];
            edges.push_back({std::min(a, b), std::max(a, b), a > b, int(t)});
        }
    }
    std::sort
    (
        edges.begin(),
        edges.end(),
        [](const triangleEdge& a, const triangleEdge& b)
        {
            return std::tie(a.low, a.high, a.triangle)
                < std::tie(b.low, b.high, b.triangle);
        }
    );
    return edges;
}


std::vector<int> connectedParts
(
    const triangleSurface& s,
    const std::vector<triangleEdge>& edges
)
{
    std::vector<int> root(s.triangles.size());
    std::iota(root.begin(), root.end(), 0);
    const auto find = [&](int t)
    {
        while (root[t] != t)
        {
            t = root[t] = root[root[t]];
        }
        return t;
    };
    for (std::size_t e = 1; e < edges.size(); ++e)
    {
        const triangleEdge& a = edges[e - 1];
        const triangleEdge& b = edges[e];
        if (a.low == b.low && a.high == b.high)
        {
            const auto ends =
                std::minmax({find(a.triangle), find(b.triangle)});
            root[ends.second] = ends.first;
        }
    }
    std::vector<int> part(root.size());
    int nParts = 0;
    for (std::size_t t = 0; t < root.size(); ++t)
    {
        const int r = find(int(t));
        part[t] = r == int(t) ? nParts++ : part[r];
    }
    return part;
}


triangleSurface extractPart
(
    const triangleSurface& s,
    const std::vector<int>& parts,
    int part
)
{
    triangleSurface result;
    std::vector<int> number(s.points.size(), -1);
    for (std::size_t t = 0; t < s.triangles.size(); ++t)
    {
        if (parts[t] != part)
        {
            continue;
        }
        std::array<int, 3> corners;
        for (int i = 0; i < 3; ++i)
        {
            int& n = number[s.triangles[t][i]];
            if (n < 0)
            {
                n = int(result.points.size());
                result.points.push_back(s.corner(t, i));
            }
            corners[i] = n;
        }
        result.triangles.push_back(corners);
    }
    return result;
}

} // namespace gpuFsi
