#include "checks.H"

#include "base/log.H"
#include "solid/brokenBonds.H"
#include "solid/springNetwork.H"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace gpuFsi;

namespace
{

struct bondCounts
{
    long n = 0;
    double length[2] = {std::numeric_limits<double>::infinity(), 0};
    double strain[2] = {std::numeric_limits<double>::infinity(), -1};
    double sum = 0;       // of strains
    long clipped = 0;     // springs of no stiffness
};

bondCounts countBonds
(
    const springNetwork& net,
    const solidMesh& mesh,
    const solidSet& set
)
{
    bondCounts c;
    for (int i = 0; i < net.n; ++i)
    for (int b = net.bondBegin[i]; b < net.bondBegin[i + 1]; ++b)
    {
        const int j = net.bondTo[b];
        if (j < i || isBroken(net, set.broken, i, b))
        {
            continue;
        }
        const vector d = mesh.offset(set.positions[j], set.positions[i]);
        const double strain = std::sqrt(dot(d, d))/net.bondLength[b] - 1;
        ++c.n;
        c.length[0] = std::min(c.length[0], net.bondLength[b]);
        c.length[1] = std::max(c.length[1], net.bondLength[b]);
        c.strain[0] = std::min(c.strain[0], strain);
        c.strain[1] = std::max(c.strain[1], strain);
        c.sum += strain;
        c.clipped += net.bondK[b] == 0;
    }
    return c;
}

//- Cells without volume at the present places
std::vector<int> turnedCells(solidMesh mesh, const solidSet& set)
{
    mesh.points = set.positions;
    std::vector<int> turned;
    for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
    {
        if (!(mesh.volume(mesh.cells[cell]) > 0))
        {
            turned.push_back(int(cell));
        }
    }
    return turned;
}

} // namespace


void checkSolids(const checkedCase& c, const checkedTime& t, findings& found)
{
    if (!c.solids)
    {
        return;
    }
    info("Checking solids...");
    const solidMesh& mesh = c.solids->mesh;
    const solidSet& set = t.state.solid;
    const springNetwork net =
        springNetwork::of(mesh, c.solids->properties);
    const bondCounts bonds = countBonds(net, mesh, set);
    info
    (
        "    {} particles, {} bonds of {:.4g} to {:.4g} m, {} broken, {} "
        "without stiffness", net.n, bonds.n, bonds.length[0], bonds.length[1],
        countBroken(set.broken), bonds.clipped
    );
    info
    (
        "    Strain of bonds: min = {:.4g} mean = {:.4g} max = {:.4g}",
        bonds.strain[0], bonds.sum/std::max(1L, bonds.n), bonds.strain[1]
    );
    const std::vector<int> turned = turnedCells(mesh, set);
    if (turned.empty())
    {
        found.good("All cells have a volume");
        return;
    }
    const vector& x = set.positions[mesh.cells[turned[0]][0]];
    found.bad
    (
        fmt::format
        (
            "{} cells of the solids turned inside out, the first at "
            "({:.4g} {:.4g} {:.4g})", turned.size(), x.x, x.y, x.z
        )
    );
}
