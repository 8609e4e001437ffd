#include "solid/surfaceFaces.H"

#include <algorithm>
#include <map>

namespace gpuFsi
{

//- Corners of a cell's faces: -x, +x, -y, ...
static constexpr int sides2[4][2] = {{2, 0}, {1, 3}, {0, 1}, {3, 2}};
static constexpr int sides3[6][4] =
{
    {0, 4, 6, 2}, {1, 3, 7, 5},
    {0, 1, 5, 4}, {2, 6, 7, 3},
    {0, 2, 3, 1}, {4, 5, 7, 6}
};


static solidFace faceOf(const std::array<int, 8>& cell, int side, int D)
{
    if (D == 2)
    {
        return {cell[sides2[side][0]], cell[sides2[side][1]], -1, -1};
    }
    const auto& s = sides3[side];
    return {cell[s[0]], cell[s[1]], cell[s[2]], cell[s[3]]};
}


static solidFace sorted(solidFace f)
{
    std::sort(f.begin(), f.end());
    return f;
}


std::vector<solidFace> surfaceFaces(const solidMesh& mesh)
{
    const int D = mesh.dimensions;
    std::map<solidFace, int> times;
    for (const auto& cell : mesh.cells)
    {
        for (int side = 0; side < 2*D; ++side)
        {
            ++times[sorted(faceOf(cell, side, D))];
        }
    }
    std::vector<solidFace> faces;
    for (const auto& cell : mesh.cells)
    {
        for (int side = 0; side < 2*D; ++side)
        {
            const solidFace f = faceOf(cell, side, D);
            if (times[sorted(f)] == 1)
            {
                faces.push_back(f);
            }
        }
    }
    return faces;
}

} // namespace gpuFsi
