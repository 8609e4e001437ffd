#include "decomposition/blockOwners.H"

#include "base/error.H"

#include <algorithm>
#include <fmt/format.h>

namespace gpuFsi
{

//- f(block) for the blocks beside block (x y z), itself included
template<class F>
static void forBlocksBeside(const blockGrid& g, int x, int y, int z, const F& f)
{
    for (int dz = -1; dz <= 1; ++dz)
    {
        for (int dy = -1; dy <= 1; ++dy)
        {
            for (int dx = -1; dx <= 1; ++dx)
            {
                const int a = g.beside(0, x, dx);
                const int b = g.beside(1, y, dy);
                const int c = g.beside(2, z, dz);
                if (a >= 0 && b >= 0 && c >= 0)
                {
                    f(g.index(a, b, c));
                }
            }
        }
    }
}


//- f(block, block beside it of another rank) for the blocks of a rank
template<class F>
static void forForeign
(
    const blockGrid& g,
    const std::vector<int>& owner,
    int rank,
    const F& f
)
{
    for (int z = 0; z < g.n[2]; ++z)
    {
        for (int y = 0; y < g.n[1]; ++y)
        {
            for (int x = 0; x < g.n[0]; ++x)
            {
                const int here = g.index(x, y, z);
                if (owner[here] == rank)
                {
                    forBlocksBeside(g, x, y, z, [&](int b)
                    {
                        if (owner[b] != rank)
                        {
                            f(here, b);
                        }
                    });
                }
            }
        }
    }
}


blockOwners::blockOwners
(
    const blockGrid& g,
    std::vector<int> ownerOf,
    int rank
)
:
    grid(g),
    owner(std::move(ownerOf)),
    beside(owner.size(), 0)
{
    forForeign(g, owner, rank, [&](int, int b)
    {
        neighbours.push_back(owner[b]);
    });
    std::sort(neighbours.begin(), neighbours.end());
    neighbours.erase
    (
        std::unique(neighbours.begin(), neighbours.end()), neighbours.end()
    );
    if (neighbours.size() > mostNeighbours)
    {
        throw userError
        (
            fmt::format
            (
                "Rank {} has {} ranks beside it; at most {} are allowed",
                rank, neighbours.size(), mostNeighbours
            ),
            {},
            "Use fewer ranks, or another method in system/decomposeParDict."
        );
    }
    forForeign(g, owner, rank, [&](int here, int b)
    {
        const auto at = std::lower_bound
        (
            neighbours.begin(), neighbours.end(), owner[b]
        );
        beside[here] |= std::uint64_t(1) << (at - neighbours.begin());
    });
}

} // namespace gpuFsi
