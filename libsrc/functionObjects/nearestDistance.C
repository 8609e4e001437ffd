#include "functionObjects/nearestDistance.H"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace gpuFsi
{

namespace
{

using triple = std::array<double, 3>;

//- Points sorted into cells, about one a cell; a search looks at shells of
//  cells around a point until no farther one can be nearer
class cells
{
public:

    cells(const hostState& state, const domain& d)
    :
        axes_(state.dimensions),
        periodic_(d.periodic)
    {
        points_.reserve(state.fluid.size() + state.walls.size());
        append(state.fluid);
        append(state.walls);

        triple hi;
        lo_ = hi = points_.empty() ? triple{} : points_[0];
        for (const triple& p : points_)
        {
            for (int a = 0; a < axes_; ++a)
            {
                lo_[a] = std::min(lo_[a], p[a]);
                hi[a] = std::max(hi[a], p[a]);
            }
        }
        const triple dLo{d.lo.x, d.lo.y, d.lo.z};
        const triple dHi{d.hi.x, d.hi.y, d.hi.z};
        for (int a = 0; a < axes_; ++a)
        {
            if (periodic_[a])
            {
                lo_[a] = dLo[a];
                hi[a] = dHi[a];
            }
            length_[a] = hi[a] - lo_[a];
            n_[a] = std::clamp(int(length_[a]/state.h), 1, 1024);
            size_[a] = n_[a] > 1 ? length_[a]/n_[a] : state.h;
        }
        fill();
    }

    //- Of point i to any other
    double nearest(std::size_t i) const
    {
        const triple p = points_[i];
        const std::array<int, 3> centre = cell(p);
        double best2 = ownImage();
        int last = 0;
        double width = std::numeric_limits<double>::max();
        for (int a = 0; a < axes_; ++a)
        {
            last = std::max(last, periodic_[a] ? n_[a]/2 : n_[a] - 1);
            width = std::min(width, size_[a]);
        }
        for (int shell = 0; shell <= last; ++shell)
        {
            // Beyond shell s - 1 nothing is nearer than s - 1 cells
            const double clear = (shell - 1)*width;
            if (shell > 0 && clear > 0 && clear*clear > best2)
            {
                break;
            }
            visit(centre, shell, [&](std::size_t j)
            {
                if (j != i)
                {
                    best2 = std::min(best2, distance2(p, points_[j]));
                }
            });
        }
        return std::sqrt(best2);
    }

private:

    void append(const particleSet& set)
    {
        for (const vector& p : set.positions)
        {
            points_.push_back({p.x, p.y, p.z});
        }
    }

    void fill()
    {
        begin_.assign(std::size_t(n_[0])*n_[1]*n_[2] + 1, 0);
        for (const triple& p : points_)
        {
            ++begin_[index(cell(p)) + 1];
        }
        for (std::size_t c = 1; c < begin_.size(); ++c)
        {
            begin_[c] += begin_[c - 1];
        }
        std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
        order_.resize(points_.size());
        for (std::size_t i = 0; i < points_.size(); ++i)
        {
            order_[next[index(cell(points_[i]))]++] = i;
        }
    }

    std::array<int, 3> cell(const triple& p) const
    {
        std::array<int, 3> c{};
        for (int a = 0; a < axes_; ++a)
        {
            const int at = int(std::floor((p[a] - lo_[a])/size_[a]));
            c[a] = periodic_[a]
              ? (at % n_[a] + n_[a]) % n_[a] : std::clamp(at, 0, n_[a] - 1);
        }
        return c;
    }

    std::size_t index(const std::array<int, 3>& c) const
    {
        return c[0] + std::size_t(n_[0])*(c[1] + std::size_t(n_[1])*c[2]);
    }

    template<class Offer>
    void visit
    (
        const std::array<int, 3>& centre,
        int shell,
        const Offer& offer
    ) const
    {
        const int deep = axes_ == 3 ? shell : 0;
        for (int k = -deep; k <= deep; ++k)
        for (int j = -shell; j <= shell; ++j)
        for (int i = -shell; i <= shell; ++i)
        {
            std::array<int, 3> c{i, j, k};
            if (std::max({std::abs(i), std::abs(j), std::abs(k)}) < shell)
            {
                continue;
            }
            bool inside = true;
            for (int a = 0; a < axes_; ++a)
            {
                c[a] += centre[a];
                if (periodic_[a])
                {
                    c[a] = (c[a] % n_[a] + n_[a]) % n_[a];
                }
                inside = inside && c[a] >= 0 && c[a] < n_[a];
            }
            if (!inside)
            {
                continue;
            }
            const std::size_t at = index(c);
            for (std::size_t m = begin_[at]; m < begin_[at + 1]; ++m)
            {
                offer(order_[m]);
            }
        }
    }

    //- The particle's own image is a neighbour, too
    double ownImage() const
    {
        double least = std::numeric_limits<double>::infinity();
        for (int a = 0; a < axes_; ++a)
        {
            if (periodic_[a])
            {
                least = std::min(least, length_[a]*length_[a]);
            }
        }
        return least;
    }

    double distance2(const triple& p, const triple& q) const
    {
        double sum = 0;
        for (int a = 0; a < axes_; ++a)
        {
            double d = q[a] - p[a];
            if (periodic_[a])
            {
                d -= length_[a]*std::round(d/length_[a]);
            }
            sum += d*d;
        }
        return sum;
    }

    int axes_;
    std::array<bool, 3> periodic_;
    std::vector<triple> points_;
    triple lo_{}, length_{}, size_{1, 1, 1};
    std::array<int, 3> n_{1, 1, 1};
    std::vector<std::size_t> begin_;    // of each cell, into order_
    std::vector<std::size_t> order_;
};

} // namespace


std::vector<double> nearestDistance(const hostState& state, const domain& d)
{
    const cells all(state, d);
    std::vector<double> distance(state.fluid.size());
    #pragma omp parallel for schedule(dynamic, 256)
    for (std::size_t i = 0; i < distance.size(); ++i)
    {
        distance[i] = all.nearest(i)/state.h;
    }
    return distance;
}

} // namespace gpuFsi
