#include "implicitSurface.H"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace gpuFsi
{

namespace
{

class marcher
{
public:

    marcher
    (
        const std::function<double(const vector&)>& f,
        const vector& lo,
        const vector& hi,
        double edge
    )
    :
        f_(f),
        lo_(lo),
        edge_(edge)
    {
        const vector size = (1/edge)*(hi - lo);
        n_ =
        {
            long(std::ceil(size.x)) + 1,
            long(std::ceil(size.y)) + 1,
            long(std::ceil(size.z)) + 1
        };
        value_.resize(std::size_t(n_[0])*n_[1]*n_[2]);
        for (std::size_t i = 0; i < value_.size(); ++i)
        {
            value_[i] = f_(point(long(i)));
        }
    }

    shapeSurface run()
    {
        for (long k = 0; k + 1 < n_[2]; ++k)
        {
            for (long j = 0; j + 1 < n_[1]; ++j)
            {
                for (long i = 0; i + 1 < n_[0]; ++i)
                {
                    cube(index(i, j, k));
                }
            }
        }
        return std::move(result_);
    }

private:

    long index(long i, long j, long k) const
    {
        return i + n_[0]*(j + n_[1]*k);
    }

    vector point(long m) const
    {
        return
        {
            lo_.x + edge_*(m % n_[0]),
            lo_.y + edge_*(m/n_[0] % n_[1]),
            lo_.z + edge_*(m/(n_[0]*n_[1]))
        };
    }

    bool inside(long m) const { return value_[m] < 0; }

    //- Paths along the axes, in every order, from corner 0 to the opposite one
    void cube(long m)
    {
        const std::array<long, 3> step{1, n_[0], n_[0]*n_[1]};
        std::array<int, 3> order{0, 1, 2};
        do
        {
            std::array<long, 4> corner{m, m, m, m};
            for (int a = 0; a < 3; ++a)
            {
                corner[a + 1] = corner[a] + step[order[a]];
            }
            tetrahedron(corner);
        }
        while (std::next_permutation(order.begin(), order.end()));
    }

    void tetrahedron(const std::array<long, 4>& corner)
    {
        std::vector<long> in, out;
        for (const long c : corner)
        {
            (inside(c) ? in : out).push_back(c);
        }
        if (in.empty() || out.empty())
        {
            return;
        }
        std::vector<int> p;
        if (in.size() == 2)
        {
            p =
            {
                cut(in[0], out[0]), cut(in[0], out[1]),
                cut(in[1], out[1]), cut(in[1], out[0])
            };
        }
        else
        {
            for (const long a : in)
            {
                for (const long b : out)
                {
                    p.push_back(cut(a, b));
                }
            }
        }
        const vector outwards = point(out[0]) - point(in[0]);
        for (std::size_t c = 2; c < p.size(); ++c)
        {
            triangle(p[0], p[c - 1], p[c], outwards);
        }
    }

    void triangle(int a, int b, int c, const vector& outwards)
    {
        const std::vector<vector>& x = result_.points;
        const vector normal = cross(x[b] - x[a], x[c] - x[a]);
        if (dot(normal, outwards) < 0)
        {
            std::swap(b, c);
        }
        result_.triangles.push_back({a, b, c});
    }

    //- Bisection between a grid point inside and one outside
    int cut(long in, long out)
    {
        const auto key = std::minmax(in, out);
        const auto found = number_.find(key);
        if (found != number_.end())
        {
            return found->second;
        }
        const vector from = point(in), along = point(out) - from;
        double low = 0.02, high = 0.98;
        for (int i = 0; i < 20; ++i)
        {
            const double middle = 0.5*(low + high);
            (f_(from + middle*along) < 0 ? low : high) = middle;
        }
        number_[key] = int(result_.points.size());
        result_.points.push_back(from + low*along);
        return number_[key];
    }

    const std::function<double(const vector&)>& f_;
    vector lo_;
    double edge_;
    std::array<long, 3> n_;
    std::vector<double> value_;
    std::map<std::pair<long, long>, int> number_;
    shapeSurface result_;
};

} // namespace

shapeSurface makeImplicit
(
    const std::function<double(const vector&)>& f,
    const vector& lo,
    const vector& hi,
    double edge
)
{
    return marcher(f, lo, hi, edge).run();
}

} // namespace gpuFsi
