#include "solid/contactSurface.H"

#include <algorithm>
#include <cmath>

namespace gpuFsi
{

namespace
{

void addFaces(const solidMesh& mesh, contactSurface& s)
{
    for (const solidFace& f : surfaceFaces(mesh))
    {
        s.faceCorners.insert
        (
            s.faceCorners.end(), f.begin(), f.begin() + s.corners()
        );
        s.faceSolid.push_back(mesh.solid[f[0]]);
    }
}


//- Slots of each particle of the solids
std::vector<std::vector<int>> slotsOf(const contactSurface& s, std::size_t n)
{
    std::vector<std::vector<int>> slots(n);
    for (std::size_t k = 0; k < s.faceCorners.size(); ++k)
    {
        slots[s.faceCorners[k]].push_back(int(k));
    }
    return slots;
}


double shareOfArea
(
    const solidMesh& mesh,
    const contactSurface& s,
    const std::vector<int>& slots
)
{
    const int N = s.corners();
    vector sum{0, 0, 0};
    for (const int slot : slots)
    {
        const int* corner = &s.faceCorners[slot/N*N];
        vector x[4]{};
        for (int a = 0; a < N; ++a)
        {
            x[a] = s.image.offset
            (
                mesh.points[corner[a]], mesh.points[corner[0]]
            );
        }
        sum += (1.0/N)*faceArea(x, s.dimensions);
    }
    return std::sqrt(dot(sum, sum));
}


bool isHeld(const solidMesh& mesh, const solidProperties& p, int i)
{
    const solidPart::type kind = mesh.part[i] >= 0
      ? p.parts[mesh.part[i]].kind : solidPart::type::free;
    return kind == solidPart::type::fixed || kind == solidPart::type::driven;
}


void addNodes
(
    const solidMesh& mesh,
    const solidProperties& properties,
    contactSurface& s
)
{
    const auto slots = slotsOf(s, mesh.size());
    s.slotBegin.push_back(0);
    for (std::size_t i = 0; i < slots.size(); ++i)
    {
        if (!slots[i].empty())
        {
            s.node.push_back(int(i));
            s.solid.push_back(mesh.solid[i]);
            s.area.push_back(shareOfArea(mesh, s, slots[i]));
            s.held.push_back(isHeld(mesh, properties, int(i)));
            s.slot.insert(s.slot.end(), slots[i].begin(), slots[i].end());
            s.slotBegin.push_back(int(s.slot.size()));
        }
    }
}


//- h/M by solid, m/Pa
std::vector<double> compliances
(
    const solidMesh& mesh,
    const solidProperties& properties,
    const springNetwork& net,
    contactSurface& s
)
{
    std::vector<double> volume(s.nSolids, 0), count(s.nSolids, 0);
    for (std::size_t c = 0; c < mesh.cells.size(); ++c)
    {
        const int solid = mesh.solid[mesh.cells[c][0]];
        volume[solid] += net.volume[c];
        count[solid] += 1;
    }
    std::vector<double> each(s.nSolids);
    for (int k = 0; k < s.nSolids; ++k)
    {
        s.spacing.push_back
        (
            count[k] > 0 ? std::pow(volume[k]/count[k], 1.0/s.dimensions) : 0
        );
        each[k] = s.spacing[k]
           /(3*net.springModulus[k] + properties.materials[k].kappa);
    }
    return each;
}

} // namespace


contactSurface contactSurface::of
(
    const solidMesh& mesh,
    const solidProperties& properties,
    const springNetwork& net
)
{
    contactSurface s;
    s.dimensions = mesh.dimensions;
    s.image = nearestImage::of(mesh.period);
    s.nSolids = int(mesh.names.size());
    addFaces(mesh, s);
    addNodes(mesh, properties, s);
    const std::vector<double> compliance =
        compliances(mesh, properties, net, s);
    const double factor = properties.contact.stiffness;
    for (const double a : compliance)
    {
        s.wallStiffness.push_back(2*factor/a);
        for (const double b : compliance)
        {
            s.stiffness.push_back(factor/(a + b));
        }
    }
    return s;
}


double contactSurface::largestSpacing() const
{
    return *std::max_element(spacing.begin(), spacing.end());
}


double contactSurface::addedSquare
(
    const springNetwork& net,
    double atOnce
) const
{
    std::vector<double> most(nSolids, 0);
    for (int n = 0; n < nNodes(); ++n)
    {
        most[solid[n]] = std::max(most[solid[n]], area[n]/net.mass[node[n]]);
    }
    double pairs = 0, wall = 0;
    for (int a = 0; a < nSolids; ++a)
    {
        wall = std::max(wall, atOnce*wallStiffness[a]*most[a]);
        for (int b = 0; b < nSolids; ++b)
        {
            const double row = std::max(most[a], most[b])
              + std::sqrt(most[a]*most[b]);
            pairs = a == b
              ? pairs : std::max(pairs, 2*stiffness[a*nSolids + b]*row);
        }
    }
    return pairs + wall;
}

} // namespace gpuFsi
