#include "coupling/touchedWalls.H"

namespace gpuFsi
{

contactWalls touchedWalls(const hostState& s, const fluidProperties& fluid)
{
    contactWalls walls;
    walls.spacing = s.h;
    walls.fluidSpacing = s.walls.size() == 0 ? 0 : s.h;
    walls.time = s.time;
    for (std::size_t w = 0; w < s.walls.size(); ++w)
    {
        if (s.wallNode[w] < 0)
        {
            walls.points.push_back(s.wallReference[w]);
            walls.normals.push_back(s.normals[w]);
            walls.area.push_back(s.area[w]);
            walls.patch.push_back(s.patch[w]);
        }
    }
    for (const auto& m : fluid.motions)
    {
        walls.motions.push_back(m.get());
    }
    return walls;
}

} // namespace gpuFsi
