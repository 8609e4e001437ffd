#include "checks.H"

#include "base/log.H"
#include "particles/stateIO.H"

using namespace gpuFsi;

//- Leaves the fluid particles of those ids
static void keepOnly(particleSet& set, const std::vector<int>& ids)
{
    for (std::size_t i = 0; i < ids.size(); ++i)
    {
        set.positions[i] = set.positions[ids[i]];
        set.U[i] = set.U[ids[i]];
        set.deltaRho[i] = set.deltaRho[ids[i]];
        set.mass[i] = set.mass[ids[i]];
    }
    set.positions.resize(ids.size());
    set.U.resize(ids.size());
    set.deltaRho.resize(ids.size());
    set.mass.resize(ids.size());
}


void checkPlaces(const checkedCase& c, checkedTime& t, findings& found)
{
    info("Checking places...");
    particleSet& fluid = t.state.fluid;
    std::size_t first = 0, outside = 0;
    for (std::size_t i = 0; i < fluid.size(); ++i)
    {
        if (isInside(fluid.positions[i], c.space))
        {
            t.fluidId.push_back(int(i));
        }
        else if (outside++ == 0)
        {
            first = i;
        }
    }
    if (outside == 0)
    {
        found.good("Particles inside the domain");
        return;
    }
    const vector& x = fluid.positions[first];
    found.bad
    (
        fmt::format
        (
            "{} particles outside the domain, the first fluid {} at "
            "({:.4g} {:.4g} {:.4g})", outside, first, x.x, x.y, x.z
        )
    );
    keepOnly(fluid, t.fluidId);
}
