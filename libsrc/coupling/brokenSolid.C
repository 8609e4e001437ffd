#include "coupling/brokenSolid.H"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace gpuFsi
{

namespace
{

std::string describe
(
    const solidMesh& mesh,
    const char* what,
    int particle,
    const char* state
)
{
    const vector& x = mesh.points[particle];
    return fmt::format
    (
        "{} {} of solid {}, unstrained at ({:.9g} {:.9g} {:.9g}), {}", what,
        particle, mesh.names[mesh.solid[particle]], x.x, x.y, x.z, state
    );
}


//- Corners count where each spans a tenth of what the cell does on average: one
//  that is flat or over leaves those beside it so little that bending turns them
template<int D>
void addCell
(
    const solidMesh& mesh,
    const std::array<int, 8>& cell,
    std::vector<int>& cells
)
{
    constexpr int N = cellShape<D>::corners;
    vector x[N];
    for (int a = 0; a < N; ++a)
    {
        x[a] = mesh.offset(mesh.points[cell[a]], mesh.points[cell[0]]);
        cells.push_back(cell[a]);
    }
    const double least = 0.1*cellShape<D>::volume(x);
    bool good = true;
    for (int a = 0; a < N; ++a)
    {
        good = good && spannedAt<D>(x, a) > least;
    }
    cells.push_back(good ? (1 << N) - 1 : 0);
}


//- The lowest particle of the first, or -1
template<int D>
int firstTurned
(
    const solidMesh& mesh,
    const std::vector<int>& cells,
    const std::vector<vector>& x
)
{
    int broken = 0;
    const turnedCell<D> look
    {
        x.data(), cells.data(), nearestImage::of(mesh.period), &broken
    };
    const std::size_t n = turnedCell<D>::stride;
    for (std::size_t i = 0; i < cells.size()/n; ++i)
    {
        look(int(i));
        if (broken)
        {
            return *std::min_element
            (
                cells.begin() + i*n, cells.begin() + i*n + n - 1
            );
        }
    }
    return -1;
}

} // namespace


std::vector<int> watchedCells
(
    const solidMesh& mesh,
    const solidProperties& properties
)
{
    std::vector<int> cells;
    for (const auto& cell : mesh.cells)
    {
        if (!(properties.materials[mesh.solid[cell[0]]].breakStrain > 0))
        {
            mesh.dimensions == 2 ? addCell<2>(mesh, cell, cells)
              : addCell<3>(mesh, cell, cells);
        }
    }
    return cells;
}


std::string describeBrokenSolid
(
    const solidMesh& mesh,
    const std::vector<int>& watched,
    const std::vector<vector>& x,
    const std::vector<vector>& U
)
{
    for (std::size_t i = 0; i < mesh.size(); ++i)
    {
        const vector sum = x[i] + U[i];
        if (!std::isfinite(sum.x + sum.y + sum.z))
        {
            return describe(mesh, "particle", int(i), "is nowhere");
        }
    }
    const int turned = mesh.dimensions == 2
      ? firstTurned<2>(mesh, watched, x) : firstTurned<3>(mesh, watched, x);
    return turned < 0 ? std::string()
      : describe(mesh, "the cell at particle", turned, "is turned over");
}

} // namespace gpuFsi
