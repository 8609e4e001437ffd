#include "seedReport.H"

#include "base/log.H"

#include <cmath>

namespace gpuFsi
{

void reportSettings(const seedSettings& settings)
{
    const lattice& l = *settings.mesh;
    const auto yes = [&](int axis) { return l.periodic(axis) ? "yes" : "no"; };
    info("Lattice");
    info("    dimensions  {}", l.dimensions());
    info("    spacing     {}", l.h());
    info
    (
        "    bounds      ({} {} {}) ({} {} {})",
        l.lo().x, l.lo().y, l.lo().z, l.hi().x, l.hi().y, l.hi().z
    );
    info("    periodic    ({} {} {})", yes(0), yes(1), yes(2));
    info
    (
        "    points      {} x {} x {} = {}\n",
        l.n(0), l.n(1), l.n(2), l.size()
    );
    info("Regions");
    for (const auto& r : settings.regions)
    {
        info("    {}: {}", r->name(), r->description());
    }
    info("");
}


void reportSolids(const std::vector<solidReport>& solids)
{
    if (solids.empty())
    {
        return;
    }
    info("Solids");
    for (const solidReport& s : solids)
    {
        info("    {}: {}", s.name, s.shape);
        info
        (
            "        nodes         {}, {} of them on the surface, area {:.6g}",
            s.nNodes, s.nSurface, s.area
        );
        info
        (
            "        cells         {}, volumes {:.4g} to {:.4g}, edges {:.4g}"
            " to {:.4g}",
            s.nCells, s.cellVolumes.first, s.cellVolumes.second,
            s.edges.first, s.edges.second
        );
        info
        (
            "        volume        {:.8g}{}", s.volume,
            s.shapeVolume ? fmt::format(", its shape's {:.8g}", *s.shapeVolume)
          : std::string()
        );
        if (s.nDropped)
        {
            info("        dropped       {} cells without room", s.nDropped);
        }
        if (s.nOff)
        {
            warning
            (
                fmt::format
                (
                    "Solid {}: {} of its surface nodes are not on the surface"
                    " of its shape.\n    Give it a smaller spacing.",
                    s.name, s.nOff
                )
            );
        }
        for (const auto& [part, nodes] : s.parts)
        {
            info("        part {}: {} nodes", part, nodes);
        }
    }
    info("");
}


static void warnOpenEnds(const seededParticles& seeded)
{
    std::size_t total = 0;
    std::string sides;
    for (int side = 0; side < 6; ++side)
    {
        if (const std::size_t n = seeded.openEnds[side])
        {
            total += n;
            sides += fmt::format
            (
                "{}{} at the {} end of {}",
                sides.empty() ? "" : ", ", n, side % 2 ? "upper" : "lower",
                "xyz"[side/2]
            );
        }
    }
    if (total)
    {
        warning
        (
            fmt::format
            (
                "{} lattice lines meet the bounds in fluid, where there is no"
                " wall ({}).\n    Particles leave the domain there: add a"
                " region, make that direction periodic, or widen bounds.",
                total, sides
            )
        );
    }
}


void reportSeeded(const seedSettings& settings, const seededParticles& seeded)
{
    const lattice& l = *settings.mesh;
    double area = 0;
    for (const wallParticle& w : seeded.walls)
    {
        area += w.area;
    }
    info("Particles");
    info("    fluid       {}", seeded.bulk.size());
    info("    walls       {}", seeded.walls.size());
    for (std::size_t r = 0; r < settings.regions.size(); ++r)
    {
        double patchArea = 0;
        for (const wallParticle& w : seeded.walls)
        {
            patchArea += w.patch == int(r) ? w.area : 0;
        }
        info
        (
            "        {}: {} of {} candidates, area {:.6g}",
            settings.regions[r]->name(), seeded.nWalls[r],
            seeded.nCandidates[r], patchArea
        );
    }
    info
    (
        "    volume      {:.8g} ({}), {:.8g} by fluid particles\n",
        seeded.volume,
        seeded.exactVolume ? "exact" : "from the lattice lines",
        seeded.bulk.size()*std::pow(l.h(), l.dimensions())
    );
    warnOpenEnds(seeded);
    if (!seeded.uncovered.empty())
    {
        const vector& p = seeded.uncovered[0];
        warning
        (
            fmt::format
            (
                "{} places on walls of given points have no point within 1.5"
                " spacings, the first at ({:.6g} {:.6g} {:.6g}).\n    Give"
                " points about one spacing apart everywhere.",
                seeded.uncovered.size(), p.x, p.y, p.z
            )
        );
    }
}

} // namespace gpuFsi
