#include "solid/springNetwork.H"

#include "solid/cellShape.H"
#include "solid/cellSprings.H"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace gpuFsi
{

namespace
{

struct bond
{
    int from;
    int to;
    double length;
    double k;
};


std::vector<vector> cornersOf
(
    const solidMesh& mesh,
    const nearestImage& image,
    std::size_t cell,
    int nCorners
)
{
    std::vector<vector> x(nCorners);
    const vector& origin = mesh.points[mesh.cells[cell][0]];
    for (int a = 0; a < nCorners; ++a)
    {
        x[a] = image.offset(mesh.points[mesh.cells[cell][a]], origin);
    }
    return x;
}


//- k published is a force per volume and length; an edge is shared by
//  2^(D - 1) cells, a face's diagonal by 2^(D - 2), a cell's own by none
std::vector<double> uniformSprings(int D, double volume, double k)
{
    std::vector<double> springs;
    for (int a = 0; a < (1 << D); ++a)
    {
        for (int b = a + 1; b < (1 << D); ++b)
        {
            springs.push_back(k*volume/(1 << (D - 1 - pairClass(a, b))));
        }
    }
    return springs;
}


void addCellBonds
(
    const solidMesh& mesh,
    const std::vector<vector>& x,
    std::size_t cell,
    const std::vector<double>& k,
    std::vector<bond>& bonds
)
{
    std::size_t pair = 0;
    for (std::size_t a = 0; a < x.size(); ++a)
    {
        for (std::size_t b = a + 1; b < x.size(); ++b, ++pair)
        {
            const vector d = x[b] - x[a];
            const int i = mesh.cells[cell][a], j = mesh.cells[cell][b];
            const double L = std::sqrt(dot(d, d));
            bonds.push_back({i, j, L, k[pair]});
            bonds.push_back({j, i, L, k[pair]});
        }
    }
}


void fillBonds(springNetwork& net, std::vector<bond>& bonds)
{
    std::stable_sort
    (
        bonds.begin(), bonds.end(),
        [](const bond& a, const bond& b)
        {
            return a.from != b.from ? a.from < b.from : a.to < b.to;
        }
    );
    net.bondBegin.assign(net.n + 1, 0);
    int last = -1;
    for (const bond& b : bonds)
    {
        if (b.from == last && net.bondTo.back() == b.to)
        {
            net.bondK.back() += b.k;
            continue;
        }
        last = b.from;
        net.bondTo.push_back(b.to);
        net.bondLength.push_back(b.length);
        net.bondK.push_back(b.k);
        ++net.bondBegin[b.from + 1];
    }
    for (int i = 0; i < net.n; ++i)
    {
        net.bondBegin[i + 1] += net.bondBegin[i];
    }
}


//- Slots by particle of a list of particles, -1 left out
void fillRows
(
    int n,
    const std::vector<int>& list,
    std::vector<int>& begin,
    std::vector<int>& slot
)
{
    begin.assign(n + 1, 0);
    for (const int i : list)
    {
        if (i >= 0)
        {
            ++begin[i + 1];
        }
    }
    for (int i = 0; i < n; ++i)
    {
        begin[i + 1] += begin[i];
    }
    std::vector<int> next(begin.begin(), begin.end() - 1);
    slot.resize(begin[n]);
    for (std::size_t s = 0; s < list.size(); ++s)
    {
        if (list[s] >= 0)
        {
            slot[next[list[s]]++] = int(s);
        }
    }
}


bool within(const solidFace& face, const solidMesh& mesh, int part)
{
    return std::all_of
    (
        face.begin(), face.end(),
        [&](int i) { return i < 0 || mesh.part[i] == part; }
    );
}


//- Pressure goes to a list of faces, the others to the particles
void addLoads
(
    const solidMesh& mesh,
    const solidProperties& properties,
    springNetwork& net
)
{
    const int per = net.dimensions == 2 ? 2 : 4;
    std::vector<double> partMass(mesh.parts.size(), 0);
    for (int i = 0; i < net.n; ++i)
    {
        if (mesh.part[i] >= 0)
        {
            partMass[mesh.part[i]] += net.mass[i];
        }
    }
    std::vector<vector> anchor(net.n, vector{0, 0, 0});
    bool anchored = false;
    for (int i = 0; i < net.n; ++i)
    {
        const int p = mesh.part[i];
        if (p >= 0)
        {
            const solidPart& rule = properties.parts[p];
            net.dead[i] += (net.mass[i]/partMass[p])*rule.force;
            anchor[i] = (net.mass[i]/partMass[p])*rule.anchor;
            anchored = anchored || dot(rule.anchor, rule.anchor) > 0;
        }
    }
    if (anchored)
    {
        net.anchor = std::move(anchor);
        net.rest = mesh.points;
    }
    for (const solidFace& face : surfaceFaces(mesh))
    {
        const int p = mesh.part[face[0]];
        if (p < 0 || !within(face, mesh, p))
        {
            continue;
        }
        vector x[4];
        for (int a = 0; a < per; ++a)
        {
            x[a] = net.image.offset
            (
                mesh.points[face[a]], mesh.points[face[0]]
            );
        }
        const vector area = faceArea(x, net.dimensions);
        for (int a = 0; a < per; ++a)
        {
            net.dead[face[a]] +=
                (std::sqrt(dot(area, area))/per)*properties.parts[p].traction;
        }
        if (properties.parts[p].pressure != 0)
        {
            net.faceCorners.insert
            (
                net.faceCorners.end(), face.begin(), face.begin() + per
            );
            net.facePart.push_back(p);
        }
    }
    fillRows(net.n, net.faceCorners, net.faceBegin, net.faceSlot);
}


void sizeFields(const solidMesh& mesh, springNetwork& net)
{
    net.n = int(mesh.size());
    net.dimensions = mesh.dimensions;
    net.image = nearestImage::of(mesh.period);
    net.mass.assign(net.n, 0);
    net.bondDamping.assign(net.n, 0);
    net.drag.assign(net.n, 0);
    net.friction.assign(net.n, 0);
    net.breakStrain.assign(net.n, 0);
    net.dead.assign(net.n, vector{});
    net.springModulus.assign(mesh.names.size(), 0);
}


double volumeOf(const std::vector<vector>& x, int D, std::size_t cell)
{
    const double V = D == 2
      ? cellShape<2>::volume(x.data())
      : cellShape<3>::volume(x.data());
    if (!(V > 0))
    {
        throw userError
        (
            fmt::format("Cell {} of the solids has the volume {:g}", cell, V),
            {},
            "Seed the solids again: a cell's volume must be positive."
        );
    }
    return V;
}


void setDamping
(
    const solidMesh& mesh,
    const solidProperties& properties,
    springNetwork& net
)
{
    for (int i = 0; i < net.n; ++i)
    {
        const solidMaterial& m = properties.materials[mesh.solid[i]];
        net.bondDamping[i] = m.dashpot;
        net.drag[i] = m.viscous*net.mass[i];
        net.friction[i] = m.friction*net.mass[i]/m.rho;
        net.breakStrain[i] = m.breakStrain;
        net.breaks = net.breaks || m.breakStrain > 0;
    }
}

} // namespace


springNetwork springNetwork::of
(
    const solidMesh& mesh,
    const solidProperties& properties
)
{
    springNetwork net;
    sizeFields(mesh, net);
    const int D = net.dimensions;
    std::vector<bond> bonds;
    std::vector<double> solidVolume(mesh.names.size(), 0);
    for (std::size_t c = 0; c < mesh.cells.size(); ++c)
    {
        const std::vector<vector> x =
            cornersOf(mesh, net.image, c, net.nCorners());
        const double V = volumeOf(x, D, c);
        const int solid = mesh.solid[mesh.cells[c][0]];
        const solidMaterial& m = properties.materials[solid];

        const cellSprings springs = m.uniform
          ? cellSprings{uniformSprings(D, V, m.k), 0}
          : isotropicSprings(x, D, V, m.mu);
        addCellBonds(mesh, x, c, springs.k, bonds);
        net.nClipped += springs.nClipped;
        net.volume.push_back(V);
        net.cellKappa.push_back(m.kappa);
        net.stiffened = net.stiffened || m.kappa != 0;
        solidVolume[solid] += V;
        std::size_t pair = 0;
        for (int a = 0; a < net.nCorners(); ++a)
        {
            const int i = mesh.cells[c][a];
            net.corners.push_back(i);
            net.restGradient.push_back
            (
                D == 2 ? cellShape<2>::gradient(x.data(), a)
                  : cellShape<3>::gradient(x.data(), a)
            );
            net.mass[i] += m.rho*V/net.nCorners();
            for (int b = a + 1; b < net.nCorners(); ++b, ++pair)
            {
                const vector d = x[b] - x[a];
                net.springModulus[solid] +=
                    springs.k[pair]*dot(d, d)/(D == 2 ? 8 : 15);
            }
        }
    }
    for (std::size_t s = 0; s < mesh.names.size(); ++s)
    {
        net.springModulus[s] /= solidVolume[s] > 0 ? solidVolume[s] : 1;
    }
    fillBonds(net, bonds);
    fillRows(net.n, net.corners, net.cellBegin, net.cellSlot);
    setDamping(mesh, properties, net);
    addLoads(mesh, properties, net);
    return net;
}


double springNetwork::gershgorin() const
{
    std::vector<double> row(n, 0);
    for (int i = 0; i < n; ++i)
    {
        for (int b = bondBegin[i]; b < bondBegin[i + 1]; ++b)
        {
            row[i] += bondK[b]
               *(1/mass[i] + 1/std::sqrt(mass[i]*mass[bondTo[b]]));
        }
    }
    for (std::size_t i = 0; i < anchor.size(); ++i)
    {
        const vector& k = anchor[i];
        row[i] += std::max({k.x, k.y, k.z})/mass[i];
    }
    for (std::size_t s = 0; stiffened && s < corners.size(); ++s)
    {
        const std::size_t cell = s/nCorners();
        const double kappa = std::max(cellKappa[cell], 0.0);
        const auto length = [&](std::size_t t)
        {
            return std::sqrt(dot(restGradient[t], restGradient[t])
                /mass[corners[t]]);
        };
        for (int b = 0; b < nCorners(); ++b)
        {
            row[corners[s]] += kappa/volume[cell]
               *length(s)*length(cell*nCorners() + b);
        }
    }
    return *std::max_element(row.begin(), row.end());
}

} // namespace gpuFsi
