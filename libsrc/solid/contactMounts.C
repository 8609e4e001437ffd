#include "solid/contactMounts.H"

#include "solid/contactPasses.H"

namespace gpuFsi
{

contactReach contactReach::of
(
    const contactSurface& s,
    const contactWalls& walls,
    const contactProperties& p
)
{
    return {2*s.largestSpacing() + p.gap, 1.5*walls.spacing};
}


//- The surface as seeded, without gap
static contactView seeded
(
    const solidMesh& mesh,
    const contactWalls& walls,
    const contactReach& reach,
    const contactSurface& s
)
{
    contactView c{};
    c.image = s.image;
    c.node = s.node.data();
    c.faceCorners = s.faceCorners.data();
    c.slotBegin = s.slotBegin.data();
    c.slot = s.slot.data();
    c.wallPoint = walls.points.data();
    c.wallNormal = walls.normals.data();
    c.wallArea = walls.area.data();
    c.wallPatch = walls.patch.data();
    c.depth = reach.depth;
    c.wallReach = reach.along;
    c.x = mesh.points.data();
    return c;
}


int markMounted
(
    const solidMesh& mesh,
    const contactWalls& walls,
    const contactReach& reach,
    contactSurface& s
)
{
    contactSearch search(s, walls);
    const contactCandidates near =
        search.find(mesh.points, walls.points, 0, reach.toWalls());
    const contactView c = seeded(mesh, walls, reach, s);
    int mounted = 0;
    for (int n = 0; n < s.nNodes(); ++n)
    {
        const vector normal = s.dimensions == 2
          ? nodeNormal<2>(c, n) : nodeNormal<3>(c, n);
        bool behind = false;
        for (int k = near.wallBegin[n]; k < near.wallBegin[n + 1]; ++k)
        {
            const wallPlane p(c, s.node[n], near.wall[k]);
            behind = behind
             ||
                (
                    p.weight > 0 && !looksAlike(p.normal, normal)
                 && p.depth < -1e-3*s.spacing[s.solid[n]]
                );
        }
        mounted += behind && !s.held[n];
        s.held[n] = s.held[n] || behind;
    }
    return mounted;
}

} // namespace gpuFsi
