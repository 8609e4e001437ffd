#include "seeding/seeding.H"

#include "seeding/lineSweep.H"
#include "seeding/thinning.H"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gpuFsi
{

namespace
{

//- Points that a region gives in place of its crossings, where some lattice
//  point around them is inside every other region
void addPoints
(
    const lattice& l,
    const std::vector<regionTrace>& traces,
    int region,
    std::vector<wallCandidate>& candidates
)
{
    const auto keeps = [&](const vector& p)
    {
        std::array<long, 3> low{};
        for (int axis = 0; axis < l.dimensions(); ++axis)
        {
            const double x = component(p, axis) - component(l.lo(), axis);
            low[axis] = long(std::floor(x/l.h() - 0.5));
        }
        for (int corner = 0; corner < (1 << l.dimensions()); ++corner)
        {
            std::array<long, 3> c{};
            bool on = true;
            for (int axis = 0; axis < l.dimensions(); ++axis)
            {
                const long n = l.n(axis);
                const long i = low[axis] + (corner >> axis & 1);
                c[axis] = l.periodic(axis) ? (i % n + n) % n : i;
                on = on && c[axis] >= 0 && c[axis] < n;
            }
            const std::size_t point = on ? l.index(c[0], c[1], c[2]) : 0;
            for (std::size_t r = 0; r < traces.size() && on; ++r)
            {
                on = int(r) == region || traces[r].inside[point];
            }
            if (on)
            {
                return true;
            }
        }
        return false;
    };
    for (const surfacePoint& s : traces[region].points)
    {
        const vector p = l.wrap(s.position);
        if (keeps(p))
        {
            candidates.push_back({{p, s.normal, s.area, region}, 2, false});
        }
    }
}

//- Nodes of a solid with fluid in front of them, within 2 h (beside a round
//  wall the nearest place of the lattice that keeps half a spacing from it may
//  be 1.9 h away): others are inside a wall or between two solids
void addNodes
(
    const lattice& l,
    const std::vector<std::uint8_t>& bulk,
    const std::vector<surfacePoint>& nodes,
    int region,
    std::vector<wallCandidate>& candidates
)
{
    const double reach = 2*l.h()*(1 + 1e-6);
    const auto nearFluid = [&](const vector& p, const vector& normal)
    {
        std::array<long, 3> low{}, count{1, 1, 1};
        for (int axis = 0; axis < l.dimensions(); ++axis)
        {
            const double x = component(p, axis) - component(l.lo(), axis);
            low[axis] = long(std::floor(x/l.h())) - 3;
            count[axis] = 7;
        }
        for (int i = 0; i < count[0]*count[1]*count[2]; ++i)
        {
            std::array<long, 3> c
            {
                low[0] + i % 7, low[1] + i/7 % 7, low[2] + i/49
            };
            bool on = true;
            for (int axis = 0; axis < l.dimensions(); ++axis)
            {
                const long n = l.n(axis);
                c[axis] = l.periodic(axis) ? (c[axis] % n + n) % n : c[axis];
                on = on && c[axis] >= 0 && c[axis] < n;
            }
            const std::size_t q = on ? l.index(c[0], c[1], c[2]) : 0;
            if (!on || !bulk[q])
            {
                continue;
            }
            const vector away = l.difference(l.point(q), p);
            if (magnitude(away) <= reach && dot(away, normal) > 0)
            {
                return true;
            }
        }
        return false;
    };
    for (const surfacePoint& s : nodes)
    {
        if (nearFluid(s.position, s.normal))
        {
            candidates.push_back
            ({
                {s.position, s.normal, s.area, region, s.node}, 3, false
            });
        }
    }
}

//- Crossings become no particles where points are given; they give their area
//  to the points unless these have areas
void leaveToPoints
(
    const std::vector<regionTrace>& traces,
    std::vector<wallCandidate>& candidates
)
{
    const auto superfluous = [&](const wallCandidate& c)
    {
        const auto& points = traces[c.particle.patch].points;
        return !points.empty() && points[0].area > 0;
    };
    candidates.erase
    (
        std::remove_if(candidates.begin(), candidates.end(), superfluous),
        candidates.end()
    );
    for (wallCandidate& c : candidates)
    {
        c.areaOnly = !traces[c.particle.patch].points.empty();
    }
}

[[noreturn]] void failEmpty(const lattice& l, const regionList& regions)
{
    std::string text = fmt::format
    (
        "No particle is inside all regions.\n    bounds ({} {} {}) to"
        " ({} {} {}), spacing {}",
        l.lo().x, l.lo().y, l.lo().z, l.hi().x, l.hi().y, l.hi().z, l.h()
    );
    sourceSpan where;
    for (const auto& r : regions)
    {
        where = where.file.empty() ? r->where() : where;
        text += "\n    region " + r->name() + ": " + r->description();
        if (const auto b = r->bounds())
        {
            text += fmt::format
            (
                ", from ({} {} {}) to ({} {} {})",
                b->first.x, b->first.y, b->first.z,
                b->second.x, b->second.y, b->second.z
            );
        }
    }
    throw userError
    (
        text,
        where,
        "Check bounds, the units, the side of each region, and that spacing"
        " is small enough."
    );
}

std::optional<double> exactVolume(const lattice& l, const regionList& regions)
{
    if (regions.size() != 1 || !regions[0]->fluidInside())
    {
        return {};
    }
    const auto b = regions[0]->bounds();
    for (int axis = 0; b && axis < l.dimensions(); ++axis)
    {
        const double slack = 1e-6*l.h();
        if
        (
            component(b->first, axis) < component(l.lo(), axis) - slack
         || component(b->second, axis) > component(l.hi(), axis) + slack
        )
        {
            return {};
        }
    }
    return regions[0]->volume();
}

} // namespace

seededParticles seedFluid(const lattice& l, const regionList& regions)
{
    std::vector<regionTrace> traces;
    for (const auto& r : regions)
    {
        traces.push_back(r->trace(l));
    }

    seededParticles result;
    std::vector<std::uint8_t> bulk(l.size(), 1);
    std::size_t nBulk = 0;
    for (std::size_t i = 0; i < l.size(); ++i)
    {
        for (const regionTrace& t : traces)
        {
            bulk[i] = bulk[i] && t.inside[i] && !t.close[i];
        }
        nBulk += bulk[i];
    }
    result.bulk.reserve(nBulk);
    for (std::size_t i = 0; i < l.size(); ++i)
    {
        if (bulk[i])
        {
            result.bulk.push_back(l.point(i));
        }
    }
    if (result.bulk.empty())
    {
        failEmpty(l, regions);
    }

    sweptLines lines = sweepLines(l, traces);
    result.openEnds = lines.openEnds;
    const auto exact = exactVolume(l, regions);
    result.volume = exact.value_or(lines.volume);
    result.exactVolume = exact.has_value();

    leaveToPoints(traces, lines.candidates);
    for (std::size_t r = 0; r < traces.size(); ++r)
    {
        const auto& points = traces[r].points;
        if (!points.empty() && points[0].node >= 0)
        {
            addNodes(l, bulk, points, int(r), lines.candidates);
        }
        else
        {
            addPoints(l, traces, int(r), lines.candidates);
        }
    }
    result.nCandidates.resize(regions.size());
    result.nWalls.resize(regions.size());
    for (const wallCandidate& c : lines.candidates)
    {
        result.nCandidates[c.particle.patch] += !c.areaOnly;
    }
    thinnedWalls walls = thin(l, std::move(lines.candidates));
    result.walls = std::move(walls.particles);
    result.uncovered = std::move(walls.uncovered);
    for (const wallParticle& w : result.walls)
    {
        ++result.nWalls[w.patch];
    }
    return result;
}

} // namespace gpuFsi
