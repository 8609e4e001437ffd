#include "seeding/solidOverlap.H"

#include <fmt/format.h>

namespace gpuFsi
{

namespace
{

//- Centres of the cells, then the nodes
std::vector<vector> places(const solidBody& body)
{
    std::vector<vector> result;
    const int n = 1 << body.lattice.dimensions();
    for (const auto& cell : body.mesh.cells)
    {
        const vector& from = body.mesh.points[cell[0]];
        vector sum{0, 0, 0};
        for (int c = 1; c < n; ++c)
        {
            sum += body.mesh.offset(body.mesh.points[cell[c]], from);
        }
        result.push_back(from + (1.0/n)*sum);
    }
    const auto& x = body.mesh.points;
    result.insert(result.end(), x.begin(), x.end());
    return result;
}

//- Deeper than what rounding and facets make of two surfaces that touch
bool deep(const region& shape, const vector& p, double limit)
{
    const auto on = shape.nearest(p);
    return on && magnitude(p - on->position) > limit;
}

} // namespace

void checkOverlap
(
    const std::vector<solidInput>& solids,
    const std::vector<solidBody>& bodies
)
{
    for (std::size_t a = 0; a < solids.size(); ++a)
    {
        const std::vector<vector> x = places(bodies[a]);
        for (std::size_t b = 0; b < solids.size(); ++b)
        {
            if (a == b)
            {
                continue;
            }
            const auto in = solids[b].shape->contains(x, 0);
            const double limit = 1e-3*bodies[b].lattice.longestEdge();
            for (std::size_t i = 0; i < x.size(); ++i)
            {
                if (in[i] && deep(*solids[b].shape, x[i], limit))
                {
                    throw userError
                    (
                        fmt::format
                        (
                            "Solids {} and {} overlap, as at"
                            " ({:.6g} {:.6g} {:.6g})",
                            solids[a].name, solids[b].name, x[i].x, x[i].y,
                            x[i].z
                        ),
                        solids[b].shape->where(),
                        "Move them apart, or make one solid of them. They"
                        " may touch."
                    );
                }
            }
        }
    }
}

} // namespace gpuFsi
