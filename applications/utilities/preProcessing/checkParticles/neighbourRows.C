#include "neighbourRows.H"

#include "neighbours/neighbourList.H"
#include "stepping/hostParticles.H"

#include <cmath>

using namespace gpuFsi;

namespace
{

template<int D>
class rowsOf
:
    public neighbourRows
{
public:

    rowsOf(const checkedCase& c, const checkedTime& t)
    :
        space_(frame::of(c.space)),
        nWalls_(t.state.walls.size()),
        perH_((1/c.space.spacing)*space_.quantum<double>()),
        unit_
        (
            finder<double, D>::unit*c.space.spacing/c.schemes.searchRadius
        ),
        list_(c.space, space_, c.schemes.searchRadius, false)
    {
        hostParticles<cpuBackend, double> host
        (
            space_, c.space, hostState(t.state), nullptr
        );
        host.upload(particles_);
        list_.searchCells(particles_);
        storage_.resize(host.order().size());
        for (std::size_t m = 0; m < storage_.size(); ++m)
        {
            storage_[host.order()[m]] = int(m);
        }
    }

    int nDirections() const override { return gpuFsi::nDirections<D>; }

    std::vector<neighbourEntry> of(std::size_t fluid) const override
    {
        const int i = storage_[nWalls_ + fluid];
        std::vector<neighbourEntry> row;
        for (int k = 0; k < nDirections(); ++k)
        {
            const int j = list_.view().at(k, int(i));
            if (j != i)
            {
                row.push_back(entry(i, j, k));
            }
        }
        return row;
    }

private:

    neighbourEntry entry(int i, int j, int direction) const
    {
        using bits = std::uint64_t;
        const auto* place = particles_.presentPlace();
        const auto along = [](auto b, auto a)
        {
            return double(std::int64_t(bits(b) - bits(a)));
        };
        const vector e
        {
            perH_.x*along(place[j].x, place[i].x),
            perH_.y*along(place[j].y, place[i].y),
            D == 3 ? perH_.z*along(place[j].z, place[i].z) : 0
        };
        const offset o
        {
            int(std::lround(unit_*e.x)), int(std::lround(unit_*e.y)),
            int(std::lround(unit_*e.z))
        };
        return
        {
            e, std::sqrt(dot(e, e)), particles_.id.data()[j],
            directionOf<D>(o) == direction
        };
    }

    const frame space_;
    const std::size_t nWalls_;
    const vector perH_;
    const double unit_;
    neighbourList<cpuBackend, double, D> list_;
    particleStore<cpuBackend, double> particles_;
    std::vector<int> storage_;    // by id
};

} // namespace


std::unique_ptr<neighbourRows> neighbourRows::make
(
    const checkedCase& c,
    const checkedTime& t
)
{
    if (c.space.dimensions == 3)
    {
        return std::make_unique<rowsOf<3>>(c, t);
    }
    return std::make_unique<rowsOf<2>>(c, t);
}
