#include "limits/stencil.H"

#include "operators/momentWeights.H"

#include <cmath>

namespace gpuFsi
{

template<int D>
static bool weighMoment(stencil& all, const particleSchemes& schemes)
{
    const bool steep = schemes.weightExponent == 3;
    const auto components = [](const vector& e, double (&to)[D])
    {
        to[0] = e.x;
        to[1] = e.y;
        if constexpr (D == 3)
        {
            to[2] = e.z;
        }
    };
    double e[D];
    momentSums<double, D> sums;
    for (const stencilNeighbour& n : all)
    {
        components(n.e, e);
        sums.add(e, n.u, baseWeight(1/n.u, steep));
    }
    double singular;
    const momentWeights<double, D> weight = sums.solve(singular);
    for (stencilNeighbour& n : all)
    {
        components(n.e, e);
        const double base = baseWeight(1/n.u, steep);
        n.gradient = n.divergence = n.laplacian = weight(e, n.u, base);
        n.damping = weight.plain(n.u, base);
    }
    return !(singular > 0);
}


static void weighRadial(stencil& all, int D)
{
    double distance = 0;
    for (const stencilNeighbour& n : all)
    {
        distance += n.u;
    }
    for (stencilNeighbour& n : all)
    {
        n.gradient = 2*D/(double(all.size())*n.u*n.u);
        n.divergence = n.laplacian = 2*D/(distance*n.u);
    }
}


bool weigh(stencil& all, const particleSchemes& schemes, int dimensions)
{
    if (schemes.areaWeights == particleSchemes::weight::radial)
    {
        weighRadial(all, dimensions);
        return true;
    }
    return dimensions == 3
      ? weighMoment<3>(all, schemes) : weighMoment<2>(all, schemes);
}


stencil latticeStencil(const particleSchemes& schemes, int dimensions)
{
    stencil all;
    const int deep = dimensions == 3 ? 1 : 0;
    for (int k = -deep; k <= deep; ++k)
    for (int j = -1; j <= 1; ++j)
    for (int i = -1; i <= 1; ++i)
    {
        if (i != 0 || j != 0 || k != 0)
        {
            const vector e{double(i), double(j), double(k)};
            all.push_back({e, std::sqrt(dot(e, e))});
        }
    }
    weigh(all, schemes, dimensions);
    return all;
}


stencilSums stencilSums::of(const stencil& all)
{
    stencilSums sums;
    for (const stencilNeighbour& n : all)
    {
        sums.sound += 0.5*std::sqrt(std::abs(n.gradient*n.divergence))*n.u;
        sums.diffusion += std::abs(n.laplacian);
    }
    return sums;
}

} // namespace gpuFsi
