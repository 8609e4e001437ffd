#include "stepping/storageOrder.H"
#include "particles/storageKey.H"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fmt/format.h>
#include <numeric>
#include <parallel/algorithm>

namespace gpuFsi
{

static std::uint64_t keyOf(const vector& p, const domain& d)
{
    const auto cell = [&](double x, double lo)
    {
        const double c = std::floor((x - lo)/d.spacing) + 16;
        return std::uint64_t(std::clamp(c, 0.0, 1048575.0));
    };
    const std::uint64_t x = cell(p.x, d.lo.x);
    const std::uint64_t y = cell(p.y, d.lo.y);
    return d.dimensions == 3
      ? storageKey<3>(x, y, cell(p.z, d.lo.z)) : storageKey<2>(x, y, 0);
}


std::vector<int> storageOrder(const hostState& s, const domain& d)
{
    const std::size_t nWalls = s.walls.size();
    std::vector<std::pair<std::uint64_t, int>> keys;
    keys.reserve(nWalls + s.fluid.size());
    for (std::size_t i = 0; i < nWalls; ++i)
    {
        keys.emplace_back(keyOf(s.walls.positions[i], d), int(i));
    }
    for (std::size_t i = 0; i < s.fluid.size(); ++i)
    {
        keys.emplace_back(keyOf(s.fluid.positions[i], d), int(nWalls + i));
    }
    // No two are equal: the order is that of any sort
    __gnu_parallel::sort(keys.begin(), keys.begin() + nWalls);
    __gnu_parallel::sort(keys.begin() + nWalls, keys.end());

    std::vector<int> order(keys.size());
    for (std::size_t i = 0; i < order.size(); ++i)
    {
        order[i] = keys[i].second;
    }
    return order;
}


std::string describeBreakdown
(
    const hostState& s,
    int id,
    std::size_t nWalls
)
{
    std::size_t i = id - nWalls;
    const std::size_t named = i;
    if (s.partial)
    {
        i = std::lower_bound(s.fluidId.begin(), s.fluidId.end(), int(i))
          - s.fluidId.begin();
    }
    const vector& x = s.fluid.positions[i];
    const vector& u = s.fluid.U[i];
    const double rho = s.rho0 + s.fluid.deltaRho[i];
    const bool velocity = !std::isfinite(u.x + u.y + u.z);
    return fmt::format
    (
        "fluid particle {} at ({:.9g} {:.9g} {:.9g}): field {} = {}",
        named, x.x, x.y, x.z,
        velocity ? "U" : "rho",
        velocity ? fmt::format("({} {} {})", u.x, u.y, u.z)
                 : fmt::format("{}", rho)
    );
}

} // namespace gpuFsi
