#include "seeding/solidSnapping.H"

#include "seeding/solidProjection.H"

#include <algorithm>
#include <cmath>

namespace gpuFsi
{

namespace
{

constexpr double leastVolume = 0.15;     // of a whole cell
constexpr double leastCorner = -0.3;     // flat corners may be a little hollow
constexpr double farthest = 1.5;         // edges, of a node from its place
constexpr double damping = 0.5;
constexpr int nSweeps = 5;
constexpr int nRounds = 10;
constexpr int nRings = 2;                // of cells around nodes that moved

class snapper
{
public:

    snapper(solidBody& body, const region& shape)
    :
        body_(body),
        lattice_(body.lattice),
        x_(body.mesh.points),
        project_(shape, body.lattice)
    {}

    snapped run()
    {
        snapped result;
        for (int round = 0; round < nRounds; ++round)
        {
            snapSurface();
            findActive();
            findEdges();
            for (int sweep = 0; sweep < nSweeps; ++sweep)
            {
                smooth();
            }
            const auto bad = badCells();
            if (bad.empty())
            {
                break;
            }
            result.nDropped += bad.size();
            body_.drop(bad);
        }
        for (auto bad = badCells(); !bad.empty(); bad = badCells())
        {
            result.nDropped += bad.size();
            body_.drop(bad);
        }
        result.nOff = std::count(off_.begin(), off_.end(), 1);
        return result;
    }

private:

    void snapSurface()
    {
        faceAxes_.assign(x_.size(), 0);
        for (const solidFace& f : body_.faces)
        {
            for (const int node : f.nodes)
            {
                if (node >= 0)
                {
                    faceAxes_[node] |= 1 << f.axis;
                }
            }
        }
        freedom_.assign(x_.size(), {});
        active_.assign(x_.size(), 0);
        off_.assign(x_.size(), 0);
        const double edge = lattice_.longestEdge();
        for (std::size_t i = 0; i < x_.size(); ++i)
        {
            if (!faceAxes_[i])
            {
                continue;
            }
            auto& f = freedom_[i];
            f = project_.freedomOf(body_.places[i], x_[i], faceAxes_[i]);
            if (f.stays || !f.project)
            {
                continue;
            }
            const auto to = project_(x_[i], f);
            if (!to || magnitude(*to - x_[i]) > farthest*edge)
            {
                f.stays = true;
                off_[i] = 1;
                continue;
            }
            active_[i] = magnitude(*to - x_[i]) > 1e-9*edge;
            x_[i] = *to;
        }
    }

    //- Rings of cells around the nodes that moved
    void findActive()
    {
        for (int ring = 0; ring < nRings; ++ring)
        {
            const auto before = active_;
            for (const auto& cell : body_.mesh.cells)
            {
                const int n = nCorners();
                const bool any = std::any_of
                (
                    cell.begin(), cell.begin() + n,
                    [&](int node) { return before[node]; }
                );
                for (int c = 0; c < n && any; ++c)
                {
                    active_[cell[c]] = 1;
                }
            }
        }
    }

    //- Pairs (node that may move, neighbour): along the surface on it
    void findEdges()
    {
        edges_.clear();
        const auto join = [&](int a, int b, bool surface)
        {
            for (const auto& [from, to] : {std::pair(a, b), std::pair(b, a)})
            {
                const bool moves = active_[from] && !freedom_[from].stays;
                if (moves && surface == (faceAxes_[from] != 0))
                {
                    edges_.emplace_back(from, to);
                }
            }
        };
        for (const auto& cell : body_.mesh.cells)
        {
            for (int c = 0; c < nCorners(); ++c)
            {
                for (int axis = 0; axis < lattice_.dimensions(); ++axis)
                {
                    if (!(c >> axis & 1))
                    {
                        join(cell[c], cell[c | 1 << axis], false);
                    }
                }
            }
        }
        const int n = lattice_.dimensions() == 2 ? 2 : 4;
        for (const solidFace& f : body_.faces)
        {
            for (int i = 0; i < (n == 2 ? 1 : n); ++i)
            {
                join(f.nodes[i], f.nodes[(i + 1) % n], true);
            }
        }
        std::sort(edges_.begin(), edges_.end());
        edges_.erase
        (
            std::unique(edges_.begin(), edges_.end()), edges_.end()
        );
    }

    //- All at once, so that a symmetric solid stays so
    void smooth()
    {
        std::vector<vector> next = x_;
        for (auto e = edges_.begin(); e != edges_.end(); )
        {
            const int i = e->first;
            vector sum{0, 0, 0};
            int n = 0;
            for (; e != edges_.end() && e->first == i; ++e, ++n)
            {
                sum += body_.mesh.offset(x_[e->second], x_[i]);
            }
            const auto& f = freedom_[i];
            for (int axis = 0; axis < 3; ++axis)
            {
                component(sum, axis) *= !f.fixed[axis];
            }
            const vector to = x_[i] + (damping/n)*sum;
            const bool surface = faceAxes_[i] && f.project;
            next[i] = surface ? project_(to, f).value_or(x_[i]) : to;
        }
        x_ = next;
    }

    std::vector<std::size_t> badCells() const
    {
        const double whole = lattice_.cellVolume();
        std::vector<std::size_t> bad;
        for (std::size_t i = 0; i < body_.mesh.cells.size(); ++i)
        {
            const auto& cell = body_.mesh.cells[i];
            bool good = body_.mesh.volume(cell) >= leastVolume*whole;
            for (int c = 0; c < nCorners() && good; ++c)
            {
                good = corner(cell, c) >= leastCorner*whole;
            }
            if (!good)
            {
                bad.push_back(i);
            }
        }
        return bad;
    }

    //- Volume that the edges at a corner span
    double corner(const std::array<int, 8>& cell, int c) const
    {
        std::array<vector, 3> edge{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
        for (int axis = 0; axis < lattice_.dimensions(); ++axis)
        {
            const double sign = c >> axis & 1 ? -1 : 1;
            edge[axis] = sign*body_.mesh.offset
            (
                x_[cell[c ^ 1 << axis]], x_[cell[c]]
            );
        }
        return dot(cross(edge[0], edge[1]), edge[2]);
    }

    int nCorners() const { return 1 << lattice_.dimensions(); }

    solidBody& body_;
    const solidLattice& lattice_;
    std::vector<vector>& x_;
    solidProjection project_;
    std::vector<int> faceAxes_;
    std::vector<solidProjection::freedom> freedom_;
    std::vector<char> active_;
    std::vector<char> off_;
    std::vector<std::pair<int, int>> edges_;
};

} // namespace

snapped snap(solidBody& body, const region& shape)
{
    return snapper(body, shape).run();
}

} // namespace gpuFsi
