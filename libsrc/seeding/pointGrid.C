#include "seeding/pointGrid.H"

namespace gpuFsi
{

pointGrid::pointGrid(const lattice& l, double cellSize)
:
    lattice_(l)
{
    long total = 1;
    for (int axis = 0; axis < 3; ++axis)
    {
        const double length = component(l.hi(), axis) - component(l.lo(), axis);
        n_[axis] = std::clamp(long(length/cellSize), 1L, l.n(axis));
        size_[axis] = length/n_[axis];
        total *= n_[axis];
    }
    head_.assign(total, -1);
}


void pointGrid::insert(const vector& p)
{
    long& head = head_[index(cell(p))];
    next_.push_back(head);
    head = long(points_.size());
    points_.push_back(p);
}


std::array<long, 3> pointGrid::cell(const vector& p) const
{
    std::array<long, 3> c;
    for (int axis = 0; axis < 3; ++axis)
    {
        const double x = component(p, axis) - component(lattice_.lo(), axis);
        c[axis] = std::clamp(long(std::floor(x/size_[axis])), 0L, n_[axis] - 1);
    }
    return c;
}


long pointGrid::index(const std::array<long, 3>& cell) const
{
    long c = 0;
    for (int axis = 2; axis >= 0; --axis)
    {
        // A periodic cell may lie up to one period off the mesh
        c = c*n_[axis] + (cell[axis] % n_[axis] + n_[axis]) % n_[axis];
    }
    return c;
}

} // namespace gpuFsi
