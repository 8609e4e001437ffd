#include "seeding/solidLattice.H"

#include <algorithm>
#include <cmath>

namespace gpuFsi
{

long solidLattice::fitted(double length, double spacing, bool around)
{
    const long n = std::lround(length/spacing);
    // The nearest image of a neighbour is itself from three cells on
    return n < (around ? 3 : 1) ? 0 : n;
}


solidLattice::solidLattice
(
    int dimensions,
    const box& bounds,
    const std::array<bool, 3>& around,
    double spacing
)
:
    dimensions_(dimensions),
    lo_(bounds.first),
    hi_(bounds.second),
    around_(around)
{
    for (int axis = 0; axis < dimensions; ++axis)
    {
        const double length = component(hi_, axis) - component(lo_, axis);
        n_[axis] = fitted(length, spacing, around[axis]);
        edge_[axis] = length/n_[axis];
    }
    if (dimensions == 2)
    {
        lo_.z = hi_.z = 0;
        around_[2] = true;
    }
}


double solidLattice::cellVolume() const
{
    return edge_[0]*edge_[1]*edge_[2];
}


double solidLattice::longestEdge() const
{
    return *std::max_element(edge_.begin(), edge_.begin() + dimensions_);
}


std::size_t solidLattice::nNodes() const
{
    return std::size_t(nNodes(0))*nNodes(1)*nNodes(2);
}


std::array<long, 3> solidLattice::place(std::size_t cell) const
{
    const std::size_t row = cell/n_[0];
    return {long(cell % n_[0]), long(row % n_[1]), long(row/n_[1])};
}


std::vector<vector> solidLattice::centres() const
{
    std::vector<vector> result(nCells());
    for (std::size_t cell = 0; cell < result.size(); ++cell)
    {
        const auto i = place(cell);
        result[cell] = lo_;
        for (int axis = 0; axis < dimensions_; ++axis)
        {
            component(result[cell], axis) += (i[axis] + 0.5)*edge_[axis];
        }
    }
    return result;
}


long solidLattice::nodeIndex(std::size_t node, int axis) const
{
    const std::size_t row = node/nNodes(0);
    return axis == 0 ? node % nNodes(0)
        : axis == 1 ? row % nNodes(1)
        : row/nNodes(1);
}


vector solidLattice::node(std::size_t node) const
{
    vector p = lo_;
    for (int axis = 0; axis < dimensions_; ++axis)
    {
        const long i = nodeIndex(node, axis);
        // The last one lies on the bound to the digit
        component(p, axis) = i == n_[axis]
            ? component(hi_, axis)
            : component(lo_, axis) + i*edge_[axis];
    }
    return p;
}


std::array<std::size_t, 8> solidLattice::corners(std::size_t cell) const
{
    const auto i = place(cell);
    std::array<std::size_t, 8> result{};
    for (int corner = 0; corner < (1 << dimensions_); ++corner)
    {
        std::array<long, 3> q{};
        for (int axis = 0; axis < dimensions_; ++axis)
        {
            q[axis] = (i[axis] + (corner >> axis & 1)) % nNodes(axis);
        }
        result[corner] =
            (std::size_t(q[2])*nNodes(1) + q[1])*nNodes(0) + q[0];
    }
    return result;
}


long solidLattice::neighbour(std::size_t cell, int axis, int side) const
{
    auto i = place(cell);
    i[axis] += side ? 1 : -1;
    if (around_[axis])
    {
        i[axis] = (i[axis] + n_[axis]) % n_[axis];
    }
    return i[axis] < 0 || i[axis] >= n_[axis]
        ? -1
        : (i[2]*n_[1] + i[1])*n_[0] + i[0];
}

} // namespace gpuFsi
