#include "solid/contactSeeds.H"

#include "solid/contactPasses.H"

#include <fmt/format.h>

namespace gpuFsi
{

namespace
{

//- The surface as seeded, without gap
contactView seeded
(
    const solidMesh& mesh,
    const contactWalls& walls,
    const contactReach& reach,
    const contactSurface& s,
    const contactCandidates& near
)
{
    contactView c{};
    c.image = s.image;
    c.node = s.node.data();
    c.faceCorners = s.faceCorners.data();
    c.slotBegin = s.slotBegin.data();
    c.slot = s.slot.data();
    c.faceBegin = near.faceBegin.data();
    c.faceList = near.face.data();
    c.wallPoint = walls.points.data();
    c.wallNormal = walls.normals.data();
    c.wallArea = walls.area.data();
    c.wallPatch = walls.patch.data();
    c.depth = reach.depth;
    c.wallReach = reach.along;
    c.x = mesh.points.data();
    return c;
}


//- The least height over a wall, m; at most `most`
double heightOverWalls
(
    const contactView& c,
    const contactCandidates& near,
    int n,
    const vector& normal,
    double most
)
{
    for (int k = near.wallBegin[n]; k < near.wallBegin[n + 1]; ++k)
    {
        const wallPlane p(c, c.node[n], near.wall[k], 0);
        if (p.weight > 0 && !looksAlike(p.normal, normal))
        {
            most = std::min(most, p.depth);
        }
    }
    return most;
}


//- The same over faces of other solids
template<int D>
double heightOverFaces
(
    const contactView& c,
    int n,
    const vector& normal,
    double most
)
{
    const nearestFace<D> found(c, n, normal);
    vector out;
    return found.face < 0 ? most : std::min(most, found.depthInto(0, out));
}


template<int D>
int fit
(
    const contactView& c,
    const contactCandidates& near,
    double gap,
    contactSurface& s
)
{
    int builtIn = 0;
    for (int n = 0; n < s.nNodes(); ++n)
    {
        const vector normal = nodeNormal<D>(c, n);
        const double wall = heightOverWalls(c, near, n, normal, gap);
        const bool behind = wall < -1e-3*s.spacing[s.solid[n]];
        builtIn += behind && !s.held[n];
        s.held[n] = s.held[n] || behind;
        const double face = heightOverFaces<D>(c, n, normal, gap);
        s.gap.push_back(std::max(0.0, std::min(wall, face)));
    }
    return builtIn;
}

//- A length given in another unit makes all touch all
void refuseFar
(
    const char* name,
    double length,
    double spacing,
    const contactProperties& p
)
{
    if (length > 10*spacing)
    {
        throw userError
        (
            fmt::format
            (
                "{} is {:g} m, more than 10 times the largest spacing, {:g} m",
                name, length, spacing
            ),
            p.where,
            "Lengths are in m: give a " + std::string(name)
          + " of about a spacing, or none."
        );
    }
}

} // namespace


contactReach contactReach::of
(
    const contactSurface& s,
    const contactWalls& walls,
    const contactProperties& p
)
{
    const double gap = p.gap.value_or(0.5*walls.fluidSpacing);
    // Round the edge of a wall of coarser particles these must be seen, too
    const double h =
        std::max(s.largestSpacing(), walls.empty() ? 0 : walls.spacing);
    refuseFar("gap", p.gap.value_or(0), std::max(h, walls.fluidSpacing), p);
    refuseFar("margin", p.margin, h, p);
    return {2*h + gap, 1.5*walls.spacing, gap};
}


int fitToSeeds
(
    const solidMesh& mesh,
    const contactWalls& walls,
    const contactReach& reach,
    contactSurface& s
)
{
    const contactCandidates near = contactSearch(s, walls).find
    (
        mesh.points, walls.points, reach.depth, reach.toWalls()
    );
    const contactView c = seeded(mesh, walls, reach, s, near);
    return s.dimensions == 2
      ? fit<2>(c, near, reach.gap, s) : fit<3>(c, near, reach.gap, s);
}

} // namespace gpuFsi
