#include "seeding/solidBody.H"

#include "base/sum.H"

#include <cmath>

namespace gpuFsi
{

solidBody::solidBody
(
    const solidLattice& l,
    const region& shape,
    const vector& period
)
:
    lattice(l),
    kept_(shape.contains(l.centres(), 0))
{
    mesh.dimensions = l.dimensions();
    mesh.period = period;
    number();
}


void solidBody::drop(const std::vector<std::size_t>& cells)
{
    for (const std::size_t cell : cells)
    {
        kept_[cells_[cell]] = 0;
    }
    number();
}


void solidBody::number()
{
    std::vector<int> numbers(lattice.nNodes(), -1);
    std::vector<int> before(lattice.nNodes(), -1);
    const std::vector<vector> points = std::move(mesh.points);
    for (std::size_t i = 0; i < places.size(); ++i)
    {
        before[places[i]] = int(i);
    }
    const int nCorners = 1 << lattice.dimensions();
    cells_.clear();
    for (std::size_t cell = 0; cell < kept_.size(); ++cell)
    {
        if (kept_[cell])
        {
            cells_.push_back(cell);
            const auto corners = lattice.corners(cell);
            for (int c = 0; c < nCorners; ++c)
            {
                numbers[corners[c]] = 0;
            }
        }
    }
    places.clear();
    mesh.points = {};
    for (std::size_t i = 0; i < numbers.size(); ++i)
    {
        if (numbers[i] == 0)
        {
            numbers[i] = int(places.size());
            places.push_back(i);
            mesh.points.push_back
            (
                before[i] < 0 ? lattice.node(i) : points[before[i]]
            );
        }
    }
    mesh.cells.clear();
    faces.clear();
    for (const std::size_t cell : cells_)
    {
        const auto corners = lattice.corners(cell);
        std::array<int, 8> nodes;
        nodes.fill(-1);
        for (int c = 0; c < nCorners; ++c)
        {
            nodes[c] = numbers[corners[c]];
        }
        mesh.cells.push_back(nodes);
        addFaces(cell, nodes);
    }
}


void solidBody::addFaces
(
    std::size_t cell,
    const std::array<int, 8>& corners
)
{
    for (int f = 0; f < 2*lattice.dimensions(); ++f)
    {
        const long beyond = lattice.neighbour(cell, f/2, f % 2);
        if (beyond >= 0 && kept_[beyond])
        {
            continue;
        }
        solidFace face{{-1, -1, -1, -1}, f/2};
        for (int i = 0; i < (lattice.dimensions() == 2 ? 2 : 4); ++i)
        {
            face.nodes[i] = corners
            [
                lattice.dimensions() == 2 ? quadEdges[f][i] : hexFaces[f][i]
            ];
        }
        faces.push_back(face);
    }
}


vector solidBody::areaVector(const solidFace& f) const
{
    const auto x = [&](int i) { return mesh.points[f.nodes[i]]; };
    if (lattice.dimensions() == 2)
    {
        const vector along = mesh.offset(x(1), x(0));
        return {along.y, -along.x, 0};
    }
    return 0.5*cross(mesh.offset(x(2), x(0)), mesh.offset(x(3), x(1)));
}


std::vector<surfacePoint> solidBody::surface() const
{
    const int nShares = lattice.dimensions() == 2 ? 2 : 4;
    std::vector<surfacePoint> points(mesh.size(), {{}, {0, 0, 0}, 0, -1});
    for (const solidFace& f : faces)
    {
        const vector a = (1.0/nShares)*areaVector(f);
        for (int i = 0; i < nShares; ++i)
        {
            surfacePoint& p = points[f.nodes[i]];
            p.node = f.nodes[i];
            p.normal += a;
            p.area += magnitude(a);
        }
    }
    std::vector<surfacePoint> result;
    for (surfacePoint& p : points)
    {
        const double length = magnitude(p.normal);
        if (p.node < 0)
        {
            continue;
        }
        p.position = mesh.points[p.node];
        // Where its faces cancel, as both sides of a sheet do, any will do
        p.normal = length > 0 ? (1/length)*p.normal : vector{1, 0, 0};
        result.push_back(p);
    }
    return result;
}


double solidBody::volume() const
{
    return pairwiseSum(0, mesh.cells.size(), [&](std::size_t i)
    {
        return mesh.volume(mesh.cells[i]);
    });
}

} // namespace gpuFsi
