#include "stepping/hostRecords.H"

#include <algorithm>

namespace gpuFsi
{

template<class Real>
void toRecords
(
    const frame& space,
    const particleSet& walls,
    const hostState& s,
    const int* order,
    std::size_t nWalls,
    const hostRecords<Real>& to
)
{
    #pragma omp parallel for schedule(static)
    for (std::size_t m = 0; m < to.n; ++m)
    {
        const std::size_t k = order[m];
        const bool wall = k < walls.size();
        const particleSet& set = wall ? walls : s.fluid;
        const std::size_t i = wall ? k : k - walls.size();
        const vector& u = set.U[i];
        to.place[m] = space.place<Real>(set.positions[i], Real(set.deltaRho[i]));
        to.velocity[m] = {Real(u.x), Real(u.y), Real(u.z), 0};
        const std::vector<int>& ids = wall ? s.wallId : s.fluidId;
        to.id[m] = int(wall ? 0 : nWalls) + (s.partial ? ids[i] : int(i));
    }
}


//- Where a particle stands in a state
static std::size_t indexOf(const hostState& s, bool wall, int id)
{
    if (!s.partial)
    {
        return id;
    }
    const std::vector<int>& ids = wall ? s.wallId : s.fluidId;
    return std::lower_bound(ids.begin(), ids.end(), id) - ids.begin();
}


template<class Real>
void fromRecords
(
    const frame& space,
    const hostRecords<Real>& from,
    const double* mass,
    std::size_t nWalls,
    hostState& s
)
{
    #pragma omp parallel for schedule(static)
    for (std::size_t m = 0; m < from.n; ++m)
    {
        const bool wall = std::size_t(from.id[m]) < nWalls;
        particleSet& set = wall ? s.walls : s.fluid;
        const std::size_t i =
            indexOf(s, wall, from.id[m] - int(wall ? 0 : nWalls));
        const velocity4<Real>& u = from.velocity[m];
        set.positions[i] = space.position(from.place[m]);
        set.U[i] = {u.x, u.y, u.z};
        set.deltaRho[i] = from.place[m].deltaRho;
        if (mass && !wall)
        {
            set.mass[i] = mass[m];
        }
    }
}


template void toRecords
(
    const frame&, const particleSet&, const hostState&, const int*,
    std::size_t, const hostRecords<float>&
);
template void fromRecords
(
    const frame&, const hostRecords<float>&, const double*, std::size_t,
    hostState&
);
template void toRecords
(
    const frame&, const particleSet&, const hostState&, const int*,
    std::size_t, const hostRecords<double>&
);
template void fromRecords
(
    const frame&, const hostRecords<double>&, const double*, std::size_t,
    hostState&
);

} // namespace gpuFsi
