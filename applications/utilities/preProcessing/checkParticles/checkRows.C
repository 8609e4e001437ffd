#include "checks.H"

#include "base/log.H"
#include "limits/stencil.H"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace gpuFsi;

namespace
{

//- What is counted and who comes first
struct tally
{
    long n = 0;
    std::size_t first = 0;

    void add(std::size_t i)
    {
        first = n == 0 ? i : first;
        ++n;
    }
};

//- Spacings: neighbours farther away fill no hole. One lattice place may be
//  empty (beside walls, where the search ends at 2.2, none), four may not.
constexpr double far = 2.25;

//- Is there a neighbour along d, nearer to it than 45 degrees, or a wall that d
//  leads behind?
bool fills
(
    const neighbourEntry& n,
    const vector& d,
    const std::vector<vector>& normals
)
{
    const double length = std::sqrt(dot(d, d));
    const double cosine = std::sqrt(0.5) + 1e-3;
    const bool wall = std::size_t(n.id) < normals.size();
    return n.u < far
     &&
        (
            dot(n.e, d) > cosine*n.u*length
         || (wall && dot(normals[n.id], d) < -0.35*length)
        );
}

bool besideHole
(
    const std::vector<neighbourEntry>& row,
    const hostState& state
)
{
    const int deep = state.dimensions == 3 ? 1 : 0;
    for (int k = -deep; k <= deep; ++k)
    for (int j = -1; j <= 1; ++j)
    for (int i = -1; i <= 1; ++i)
    {
        const vector d{double(i), double(j), double(k)};
        const bool seen = dot(d, d) == 0 || std::any_of
        (
            row.begin(), row.end(),
            [&](const neighbourEntry& n) { return fills(n, d, state.normals); }
        );
        if (!seen)
        {
            return true;
        }
    }
    return false;
}

struct rowCounts
{
    long covered = 0;
    int leastCovered = std::numeric_limits<int>::max();
    long whole = 0;         // all directions covered
    tally holes;
    tally negative;         // some weight below zero
    double leastWeight = 0; // over the mean one
    tally fallBacks;
};

void addWeights
(
    rowCounts& counts,
    const std::vector<neighbourEntry>& row,
    const checkedCase& c,
    std::size_t i
)
{
    stencil all;
    for (const neighbourEntry& n : row)
    {
        all.push_back({n.e, n.u});
    }
    if (all.empty() || !weigh(all, c.schemes, c.space.dimensions))
    {
        counts.fallBacks.add(i);
        return;
    }
    double sum = 0, least = std::numeric_limits<double>::infinity();
    for (const stencilNeighbour& n : all)
    {
        sum += n.laplacian*n.u;
        least = std::min(least, n.laplacian*n.u);
    }
    if (least < 0)
    {
        counts.negative.add(i);
        counts.leastWeight =
            std::min(counts.leastWeight, least*all.size()/sum);
    }
}

rowCounts countRows
(
    const checkedCase& c,
    const hostState& state,
    const neighbourRows& rows
)
{
    rowCounts counts;
    for (std::size_t i = 0; i < state.fluid.size(); ++i)
    {
        const std::vector<neighbourEntry> row = rows.of(i);
        const int covered = int(std::count_if
        (
            row.begin(), row.end(),
            [](const neighbourEntry& e) { return e.covers; }
        ));
        counts.covered += covered;
        counts.leastCovered = std::min(counts.leastCovered, covered);
        counts.whole += covered == rows.nDirections();
        if (besideHole(row, state))
        {
            counts.holes.add(i);
        }
        addWeights(counts, row, c, i);
    }
    return counts;
}

void reportDirections
(
    const checkedTime& t,
    const neighbourRows& rows,
    const rowCounts& counts,
    findings& found
)
{
    const double n = double(t.state.fluid.size());
    info
    (
        "    Covered of {}: min = {} mean = {:.2f}, all for {:.1f} % of the "
        "particles", rows.nDirections(), counts.leastCovered,
        counts.covered/n, 100*counts.whole/n
    );
    if (counts.holes.n > 0)
    {
        found.bad
        (
            fmt::format
            (
                "{} particles beside a hole, the first {}",
                counts.holes.n, t.name(counts.holes.first)
            )
        );
    }
    else
    {
        found.good("No holes");
    }
}

void reportWeights
(
    const checkedCase& c,
    const checkedTime& t,
    const rowCounts& counts,
    findings& found
)
{
    if (c.schemes.areaWeights == particleSchemes::weight::radial)
    {
        info("    areaWeights radial: all alike, positive");
        return;
    }
    if (counts.negative.n > 0)
    {
        info
        (
            "    {} particles with negative weights, down to {:.2g} of their "
            "mean, the first {}", counts.negative.n, counts.leastWeight,
            t.name(counts.negative.first)
        );
    }
    else
    {
        info("    All weights positive");
    }
    if (counts.fallBacks.n > 0)
    {
        found.bad
        (
            fmt::format
            (
                "{} particles whose weights fall back to first order, the "
                "first {}",
                counts.fallBacks.n, t.name(counts.fallBacks.first)
            )
        );
    }
    else
    {
        found.good("No weights fall back to first order");
    }
}

} // namespace


void checkRows
(
    const checkedCase& c,
    const checkedTime& t,
    const neighbourRows& rows,
    findings& found
)
{
    info("Checking directions...");
    const rowCounts counts = countRows(c, t.state, rows);
    reportDirections(t, rows, counts, found);
    info("Checking weights...");
    reportWeights(c, t, counts, found);
}
