#include "seeding/thinning.H"

#include "seeding/pointGrid.H"

#include <cmath>
#include <limits>
#include <tuple>

namespace gpuFsi
{

namespace
{

auto place(const wallParticle& p)
{
    return std::make_tuple
    (
        p.patch, p.position.z, p.position.y, p.position.x
    );
}

//- Nearest accepted particle, but no solid's node: of the same side of the
//  same wall if there is one, else of any wall
long heir
(
    const wallParticle& p,
    const std::vector<wallParticle>& accepted,
    const pointGrid& grid,
    double h
)
{
    for (const double radius : {0.7*h, 1.5*h})
    {
        for (const bool sameWall : {true, false})
        {
            // Equally near ones: the lower number, whatever the order of visit
            std::pair<double, long> best
            {
                std::numeric_limits<double>::infinity(), -1
            };
            const auto visit = [&](std::size_t q, double d2)
            {
                const bool same =
                    accepted[q].patch == p.patch
                 && dot(accepted[q].normal, p.normal) > 0;
                if ((same || !sameWall) && accepted[q].node < 0)
                {
                    best = std::min(best, std::make_pair(d2, long(q)));
                }
            };
            grid.within(p.position, radius, visit);
            if (best.second >= 0 && (sameWall || radius > h))
            {
                return best.second;
            }
        }
    }
    return -1;
}

} // namespace

thinnedWalls thin
(
    const lattice& l,
    std::vector<wallCandidate> candidates
)
{
    // Alignments that differ by round-off alone are ties
    const auto rank = [](const wallCandidate& c)
    {
        return std::make_tuple
        (
            -std::llround(1e9*c.alignment), place(c.particle)
        );
    };
    std::sort
    (
        candidates.begin(),
        candidates.end(),
        [&](const wallCandidate& a, const wallCandidate& b)
        {
            return rank(a) < rank(b);
        }
    );

    const double h = l.h();
    pointGrid grid(l, h);
    thinnedWalls result;
    std::vector<wallParticle>& accepted = result.particles;
    std::vector<wallParticle> rejected;
    for (const wallCandidate& c : candidates)
    {
        const wallParticle& p = c.particle;
        const bool node = p.node >= 0;
        bool free = !c.areaOnly;
        const auto visit = [&](std::size_t q, double d2)
        {
            const bool back = dot(accepted[q].normal, p.normal) < -0.5;
            const double least =
                accepted[q].node >= 0 ? (node ? 0 : 0.5*h)
              : back ? 0.25*h
              : accepted[q].patch == p.patch ? 0.7*h
              : 0.5*h;
            free = free && d2 >= least*least;
        };
        grid.within(p.position, 0.7*h, visit);
        if (free)
        {
            grid.insert(p.position);
            accepted.push_back(p);
        }
        else
        {
            rejected.push_back(p);
        }
    }
    for (const wallParticle& p : rejected)
    {
        const long to = heir(p, accepted, grid, h);
        if (to < 0)
        {
            result.uncovered.push_back(p.position);
            continue;
        }
        accepted[to].area += p.area;
    }
    std::sort
    (
        accepted.begin(),
        accepted.end(),
        [](const wallParticle& a, const wallParticle& b)
        {
            return place(a) < place(b);
        }
    );
    return result;
}

} // namespace gpuFsi
