#include "solid/brokenBonds.H"

#include <algorithm>
#include <fmt/format.h>

namespace gpuFsi
{

void checkMasks(const springNetwork& net)
{
    for (int i = 0; i < net.n; ++i)
    {
        const int bonds = net.bondBegin[i + 1] - net.bondBegin[i];
        if (bonds > maskedBonds)
        {
            throw userError
            (
                fmt::format
                (
                    "Particle {} of the solids has {} bonds; of those that "
                    "break it may have {}",
                    i, bonds, maskedBonds
                ),
                {},
                "Leave 'breakStrain' out of constant/solidProperties, or "
                "seed the solid with another mesh."
            );
        }
    }
}


std::vector<int> pairBonds(const springNetwork& net)
{
    std::vector<int> bonds;
    const int N = net.nCorners();
    for (int cell = 0; cell < net.nCells(); ++cell)
    {
        for (int a = 0; a < N; ++a)
        {
            const int i = net.corners[cell*N + a];
            const auto begin = net.bondTo.begin();
            for (int b = a + 1; b < N; ++b)
            {
                const auto at = std::lower_bound
                (
                    begin + net.bondBegin[i], begin + net.bondBegin[i + 1],
                    net.corners[cell*N + b]
                );
                bonds.push_back(int(at - begin));
            }
        }
    }
    return bonds;
}


std::vector<double> cellShares
(
    const springNetwork& net,
    const std::vector<bondMask>& broken
)
{
    std::vector<double> shares(net.nCells(), 1);
    if (countBroken(broken) == 0)
    {
        return shares;
    }
    const std::vector<int> bonds = pairBonds(net);
    const int N = net.nCorners();
    std::size_t pair = 0;
    for (int cell = 0; cell < net.nCells(); ++cell)
    {
        unsigned links[8]{};
        for (int a = 0; a < N; ++a)
        {
            const int i = net.corners[cell*N + a];
            for (int b = a + 1; b < N; ++b, ++pair)
            {
                const bool holds = !isBroken(net, broken, i, bonds[pair]);
                links[a] |= unsigned(holds) << b;
                links[b] |= unsigned(holds) << a;
            }
        }
        shares[cell] = heldShare(links, N);
    }
    return shares;
}


long countBroken(const std::vector<bondMask>& broken)
{
    long ends = 0;
    for (const bondMask m : broken)
    {
        ends += __builtin_popcountll(m);
    }
    return ends/2;
}

} // namespace gpuFsi
