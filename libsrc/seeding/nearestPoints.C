#include "seeding/nearestPoints.H"

#include "seeding/lattice.H"

#include <algorithm>
#include <numeric>

namespace gpuFsi
{

struct nearestPoints::search
{
    const vector& p;
    std::size_t k;
    found& heap;    // the farthest on top

    void offer(double d2, std::size_t number)
    {
        const auto candidate = std::make_pair(d2, number);
        if (heap.size() == k)
        {
            if (!(candidate < heap.front()))
            {
                return;
            }
            std::pop_heap(heap.begin(), heap.end());
            heap.pop_back();
        }
        heap.push_back(candidate);
        std::push_heap(heap.begin(), heap.end());
    }

    bool reaches(double d) const
    {
        return heap.size() < k || d*d <= heap.front().first;
    }
};


nearestPoints::nearestPoints(const std::vector<vector>& points)
:
    points_(points),
    order_(points.size())
{
    std::iota(order_.begin(), order_.end(), 0);
    build(0, order_.size(), 0);
}


void nearestPoints::build(std::size_t begin, std::size_t end, int axis)
{
    if (end - begin < 2)
    {
        return;
    }
    const std::size_t middle = begin + (end - begin)/2;
    std::nth_element
    (
        order_.begin() + begin,
        order_.begin() + middle,
        order_.begin() + end,
        [&](std::size_t a, std::size_t b)
        {
            return component(points_[a], axis) < component(points_[b], axis);
        }
    );
    build(begin, middle, (axis + 1) % 3);
    build(middle + 1, end, (axis + 1) % 3);
}


void nearestPoints::find(const vector& p, std::size_t k, found& result) const
{
    result.clear();
    search s{p, k, result};
    visit(0, order_.size(), 0, s);
    std::sort_heap(result.begin(), result.end());
}


void nearestPoints::visit
(
    std::size_t begin,
    std::size_t end,
    int axis,
    search& s
) const
{
    if (begin >= end)
    {
        return;
    }
    const std::size_t middle = begin + (end - begin)/2;
    const vector& q = points_[order_[middle]];
    const vector d = q - s.p;
    s.offer(dot(d, d), order_[middle]);
    const double beyond = component(d, axis);
    const int next = (axis + 1) % 3;
    if (beyond > 0)
    {
        visit(begin, middle, next, s);
    }
    else
    {
        visit(middle + 1, end, next, s);
    }
    if (s.reaches(beyond))
    {
        if (beyond > 0)
        {
            visit(middle + 1, end, next, s);
        }
        else
        {
            visit(begin, middle, next, s);
        }
    }
}

} // namespace gpuFsi
