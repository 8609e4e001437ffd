#include "coupling/wettedSurface.H"

#include <algorithm>

namespace gpuFsi
{

wettedSurface wettedSurface::of
(
    const solidMesh& mesh,
    const hostState& state,
    const std::vector<int>& order
)
{
    wettedSurface s;
    std::vector<int> wallOf(mesh.size(), -1);
    for (std::size_t i = 0; i < order.size(); ++i)
    {
        s.node.push_back(state.wallNode[order[i]]);
        if (s.node.back() >= 0)
        {
            wallOf[s.node.back()] = int(i);
        }
    }

    std::vector<std::vector<wetFace>> rows(order.size());
    const int corners = mesh.dimensions == 3 ? 4 : 2;
    for (const solidFace& f : surfaceFaces(mesh))
    {
        const auto wet = [&](int particle) { return wallOf[particle] >= 0; };
        if (std::all_of(f.begin(), f.begin() + corners, wet))
        {
            for (int c = 0; c < corners; ++c)
            {
                rows[wallOf[f[c]]].push_back({{f[0], f[1], f[2], f[3]}});
            }
        }
    }
    s.begin.push_back(0);
    for (const auto& row : rows)
    {
        s.faces.insert(s.faces.end(), row.begin(), row.end());
        s.begin.push_back(int(s.faces.size()));
    }
    return s;
}

} // namespace gpuFsi
