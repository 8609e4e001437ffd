#include "solid/solidLedger.H"

#include "base/sum.H"
#include "solid/solidView.H"

namespace gpuFsi
{

solidEnergies solidLedger
(
    const springNetwork& net,
    const hostSolid& s,
    const std::vector<double>& work,
    const std::vector<double>& cellLoss
)
{
    const auto account = [&](solidAccount which)
    {
        const std::size_t first = std::size_t(which)*net.n;
        return pairwiseSum
        (
            first, first + net.n, [&](std::size_t i) { return work[i]; }
        );
    };
    solidEnergies e;
    e.kinetic = pairwiseSum
    (
        0, net.n,
        [&](std::size_t i) { return 0.5*net.mass[i]*dot(s.U[i], s.U[i]); }
    );
    e.elastic = elasticEnergy(net, s.positions, s.broken);
    e.dissipated = pairwiseSum
    (
        0, cellLoss.size(), [&](std::size_t c) { return cellLoss[c]; }
    ) - account(damped);
    e.brokenBonds = countBroken(s.broken);
    e.gravity = account(gravitational);
    e.loads = account(loaded);
    e.driven = account(driven);
    e.fluid = account(fluidLoad);
    return e;
}

} // namespace gpuFsi
