#include "decomposeReport.H"

#include "base/log.H"

#include <algorithm>
#include <set>

namespace gpuFsi
{

namespace
{

struct rankShare
{
    int blocks = 0;
    double weight = 0;
    std::set<int> neighbours;
    std::size_t halo = 0;
};

//- Calls f(index) for the 26 (8) blocks around and the block itself
template<class Visit>
void eachAround(const blockGrid& g, int block, const Visit& f)
{
    const int at[3] =
        {block % g.n[0], block/g.n[0] % g.n[1], block/g.n[0]/g.n[1]};
    for (int dz = -1; dz <= 1; ++dz)
    for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx)
    {
        const int x = g.beside(0, at[0], dx);
        const int y = g.beside(1, at[1], dy);
        const int z = g.beside(2, at[2], dz);
        if (x >= 0 && y >= 0 && z >= 0)
        {
            f(g.index(x, y, z));
        }
    }
}

std::vector<rankShare> sharesOf(const decomposedTime& t, const blockGrid& g)
{
    std::vector<rankShare> shares(t.nRanks());
    const std::vector<int>& ranks = t.rankOfBlock();
    const std::vector<std::size_t> particles = t.particlesOfBlock();
    for (int b = 0; b < g.count(); ++b)
    {
        rankShare& own = shares[ranks[b]];
        ++own.blocks;
        own.weight += t.weightOfBlock()[b];

        // Who needs the particles of this block
        std::set<int> others;
        eachAround(g, b, [&](int around)
        {
            if (ranks[around] != ranks[b] && particles[around] > 0)
            {
                others.insert(ranks[around]);
            }
        });
        for (int r : others)
        {
            if (particles[b] > 0)
            {
                shares[r].neighbours.insert(ranks[b]);
                shares[r].halo += particles[b];
            }
        }
    }
    return shares;
}

} // namespace


void reportTime(const decomposedTime& t, const blockGrid& g)
{
    const std::vector<rankShare> shares = sharesOf(t, g);
    info("Time = {}\n", t.name());
    std::string head = fmt::format("{:>6}", "rank");
    for (const auto& c : t.clouds())
    {
        head += fmt::format(" {:>11}", c.whole.name);
    }
    info("{}{:>9}{:>12}{:>11}", head, "blocks", "neighbours", "halo");
    double heaviest = 0, all = 0;
    for (int r = 0; r < t.nRanks(); ++r)
    {
        std::string row = fmt::format("{:>6}", r);
        for (const auto& c : t.clouds())
        {
            row += fmt::format(" {:>11}", c.ids[r].size());
        }
        const rankShare& s = shares[r];
        info("{}{:>9}{:>12}{:>11}", row, s.blocks, s.neighbours.size(),
            s.halo);
        heaviest = std::max(heaviest, s.weight);
        all += s.weight;
    }
    if (all > 0)
    {
        info("\nImbalance, heaviest over mean weight: {:.3f}",
            heaviest*t.nRanks()/all);
    }
    info("");
}

} // namespace gpuFsi
