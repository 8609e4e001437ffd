#include "seeding/solidSeeding.H"

#include "seeding/solidOverlap.H"
#include "seeding/solidRegion.H"
#include "seeding/solidReport.H"
#include "seeding/solidSnapping.H"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gpuFsi
{

namespace
{

constexpr double roundOff = 1e-9;    // of a length

std::string text(const box& b)
{
    return fmt::format
    (
        "({:.6g} {:.6g} {:.6g}) to ({:.6g} {:.6g} {:.6g})",
        b.first.x, b.first.y, b.first.z, b.second.x, b.second.y, b.second.z
    );
}

//- What the shape and the domain have in common
solidLattice fitLattice(const solidInput& s, const lattice& l)
{
    box common{l.lo(), l.hi()};
    const auto shape = s.shape->bounds();
    std::array<bool, 3> around{};
    for (int axis = 0; axis < l.dimensions(); ++axis)
    {
        double& low = component(common.first, axis);
        double& high = component(common.second, axis);
        const double slack = roundOff*(high - low);
        const double first = shape ? component(shape->first, axis) : low;
        const double last = shape ? component(shape->second, axis) : high;
        around[axis] =
            l.periodic(axis) && first < low + slack && last > high - slack;
        low = std::max(low, first);
        high = std::min(high, last);
        if (!(high - low > slack))
        {
            throw userError
            (
                "Solid " + s.name + " is outside the bounds\n    solid  from "
              + text(*shape) + "\n    bounds " + text({l.lo(), l.hi()}),
                s.shape->where(),
                "Move it, or widen bounds; check the units."
            );
        }
        if (!solidLattice::fitted(high - low, s.spacing, around[axis]))
        {
            throw userError
            (
                fmt::format
                (
                    "Solid {}: spacing {} is too large, {} of it is {} long"
                    " in {}",
                    s.name, s.spacing,
                    shape ? "what the bounds leave" : "the domain",
                    high - low, "xyz"[axis]
                ),
                s.where,
                "Give it a smaller spacing: a cell must fit, three where it"
                " goes around a periodic direction."
            );
        }
    }
    return {l.dimensions(), common, around, s.spacing};
}

std::vector<std::uint8_t> surfaceNodes(const solidBody& body)
{
    std::vector<std::uint8_t> on(body.mesh.size(), 0);
    for (const solidFace& f : body.faces)
    {
        for (const int node : f.nodes)
        {
            if (node >= 0)
            {
                on[node] = 1;
            }
        }
    }
    return on;
}

//- Later parts win
std::vector<int> assignParts(const solidInput& s, const solidBody& body)
{
    std::vector<int> part(body.mesh.size(), -1);
    const auto onSurface = surfaceNodes(body);
    const double slack = roundOff*body.lattice.longestEdge();
    for (std::size_t p = 0; p < s.parts.size(); ++p)
    {
        const auto in = s.parts[p].within->contains(body.mesh.points, slack);
        bool any = false;
        for (std::size_t i = 0; i < part.size(); ++i)
        {
            if (in[i] && (onSurface[i] || !s.parts[p].surface))
            {
                part[i] = int(p);
                any = true;
            }
        }
        if (!any)
        {
            const box b{body.lattice.lo(), body.lattice.hi()};
            throw userError
            (
                "Part " + s.parts[p].name + " of solid " + s.name
              + " has no node; the solid reaches from " + text(b),
                s.parts[p].within->where(),
                s.parts[p].surface
              ? "Nodes within the region that are on the solid's surface"
                " become the part."
              : "Nodes within the region become the part."
            );
        }
    }
    return part;
}

solidBody makeBody(const solidInput& s, const lattice& l, solidReport& report)
{
    const vector size = l.hi() - l.lo();
    const vector period
    {
        l.periodic(0) ? size.x : 0,
        l.periodic(1) ? size.y : 0,
        l.periodic(2) ? size.z : 0
    };
    solidBody body(fitLattice(s, l), *s.shape, period);
    const snapped result = snap(body, *s.shape);
    if (body.mesh.cells.empty())
    {
        throw userError
        (
            "Solid " + s.name + ": no cell fits in its shape",
            s.where,
            "Give it a smaller spacing; check the shape and its units."
        );
    }
    report = makeReport(s, body, result);
    for (vector& p : body.mesh.points)
    {
        p = l.wrap(p);
    }
    return body;
}

std::vector<vector> velocity(const solidInput& s, const solidBody& body)
{
    std::vector<vector> U(body.mesh.size(), {0, 0, 0});
    for (std::size_t c = 0; c < s.U.size(); ++c)
    {
        const std::vector<double> values = s.U[c].at(body.mesh.points);
        for (std::size_t i = 0; i < U.size(); ++i)
        {
            component(U[i], int(c)) = values[i];
        }
    }
    return U;
}

//- To the list of all solids
void append
(
    seededSolids& all,
    const solidInput& s,
    const solidBody& body,
    const std::vector<int>& parts
)
{
    const int first = int(all.mesh.size());
    const int firstPart = int(all.mesh.parts.size());
    const int number = int(all.mesh.names.size());
    all.mesh.names.push_back(s.name);
    for (const solidPartInput& p : s.parts)
    {
        all.mesh.parts.push_back({number, p.name});
    }
    const auto& x = body.mesh.points;
    all.mesh.points.insert(all.mesh.points.end(), x.begin(), x.end());
    all.mesh.solid.resize(all.mesh.size(), number);
    for (const int p : parts)
    {
        all.mesh.part.push_back(p < 0 ? -1 : p + firstPart);
    }
    for (std::array<int, 8> cell : body.mesh.cells)
    {
        for (int& node : cell)
        {
            node += node < 0 ? 0 : first;
        }
        all.mesh.cells.push_back(cell);
    }
    const std::vector<vector> U = velocity(s, body);
    all.U.insert(all.U.end(), U.begin(), U.end());
}

} // namespace

seededSolids seedSolids(std::vector<solidInput> solids, const lattice& l)
{
    seededSolids all;
    all.mesh.dimensions = l.dimensions();
    std::vector<solidBody> bodies;
    for (const solidInput& s : solids)
    {
        solidReport report;
        bodies.push_back(makeBody(s, l, report));
        const std::vector<int> parts = assignParts(s, bodies.back());
        for (std::size_t p = 0; p < s.parts.size(); ++p)
        {
            report.parts.emplace_back
            (
                s.parts[p].name,
                std::count(parts.begin(), parts.end(), int(p))
            );
        }
        append(all, s, bodies.back(), parts);
        all.reports.push_back(report);
        all.mesh.period = bodies.back().mesh.period;
    }
    checkOverlap(solids, bodies);
    int first = 0;
    for (std::size_t i = 0; i < solids.size(); ++i)
    {
        std::vector<surfacePoint> surface = bodies[i].surface();
        for (surfacePoint& p : surface)
        {
            p.node += first;
        }
        first += int(bodies[i].mesh.size());
        all.regions.push_back
        (
            std::make_unique<solidRegion>
            (
                solids[i].name, std::move(solids[i].shape), std::move(surface)
            )
        );
    }
    return all;
}

} // namespace gpuFsi
