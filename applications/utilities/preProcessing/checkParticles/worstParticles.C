#include "worstParticles.H"

#include "coupling/wallAcceleration.H"
#include "limits/stencil.H"
#include "solid/springNetwork.H"

#include <algorithm>
#include <cmath>

using namespace gpuFsi;

namespace
{

//- Speed of sound, m/s
double soundSpeed(const fluidProperties& fluid, double deltaRho)
{
    return fluid.eos == fluidProperties::state::Tait
      ? fluid.c*std::pow(1 + deltaRho/fluid.rho0, 0.5*(fluid.gamma - 1))
      : fluid.c;
}

//- Of all fluid particles, m/s
vector meanVelocity(const particleSet& fluid)
{
    vector sum{};
    for (const vector& u : fluid.U)
    {
        sum += u;
    }
    return (1/double(std::max<std::size_t>(1, fluid.size())))*sum;
}

double greatestSpeed(const hostState& state)
{
    const vector mean = meanVelocity(state.fluid);
    double greatest = 0;
    for (const particleSet* set : {&state.fluid, &state.walls})
    {
        for (const vector& u : set->U)
        {
            const vector d = u - mean;
            greatest = std::max(greatest, std::sqrt(dot(d, d)));
        }
    }
    return greatest;
}

//- How fast neighbours come near, over their distance, 1/s
double approachOf
(
    const hostState& state,
    std::size_t i,
    const std::vector<neighbourEntry>& row
)
{
    double most = 0;
    for (const neighbourEntry& n : row)
    {
        const std::size_t walls = state.walls.size(), id = n.id;
        const vector& uj =
            id < walls ? state.walls.U[id] : state.fluid.U[id - walls];
        const double closing = -dot(uj - state.fluid.U[i], n.e);
        most = std::max(most, closing/(n.u*n.u*state.h));
    }
    return most;
}

//- Rounding alone raises nothing
bool raise(double& most, double value)
{
    const bool more = value > most*(1 + 1e-9);
    most = more ? value : most;
    return more;
}

} // namespace


worstParticles::worstParticles
(
    const checkedCase& c,
    const checkedTime& t,
    const neighbourRows* rows
)
{
    lattice_.flow =
    {
        c.space.dimensions, c.space.spacing, rows ? c.fluid.c : 0,
        rows ? c.fluid.mu/c.fluid.rho0 : 0
    };
    lattice_.rho = c.fluid.rho0;
    const vector g = c.fluid.g.at(t.state.time);
    lattice_.force = rows ? std::sqrt(dot(g, g)) : 0;
    if (rows)
    {
        lattice_.relativeSpeed = greatestSpeed(t.state);
        findFluid(c, t, *rows);
    }
    if (c.solids)
    {
        findSolid(c, t);
    }
}


void worstParticles::findFluid
(
    const checkedCase& c,
    const checkedTime& t,
    const neighbourRows& rows
)
{
    const stencilSums even =
        stencilSums::of(latticeStencil(c.schemes, c.space.dimensions));
    const double h = c.space.spacing;
    double sound = 0, diffusion = 0, near = 0, wall = HUGE_VAL;
    for (std::size_t i = 0; i < t.state.fluid.size(); ++i)
    {
        const std::vector<neighbourEntry> row = rows.of(i);
        if (row.empty())
        {
            continue;
        }
        stencil all;
        double least = row[0].u;
        for (const neighbourEntry& n : row)
        {
            all.push_back({n.e, n.u});
            least = std::min(least, n.u);
            if (std::size_t(n.id) < t.state.walls.size())
            {
                wall = std::min(wall, n.u);
            }
        }
        weigh(all, c.schemes, c.space.dimensions);
        const stencilSums own = stencilSums::of(all);
        const double deltaRho = t.state.fluid.deltaRho[i];
        const flowScales f
        {
            c.space.dimensions, h, soundSpeed(c.fluid, deltaRho),
            c.fluid.mu/(c.fluid.rho0 + deltaRho)
        };
        if (raise(sound, f.c*own.sound))
        {
            fluid[0] = i;
            sound_ = f;
            sound_.h = h*even.sound/own.sound;
        }
        if (raise(diffusion, f.nu*own.diffusion))
        {
            fluid[1] = i;
            viscosity_ = f;
            viscosity_.h = h*std::sqrt(even.diffusion/own.diffusion);
        }
        if (raise(approach_, approachOf(t.state, i, row)))
        {
            fluid[2] = i;
        }
        if (raise(near, 1/least))
        {
            fluid[3] = i;
            nearest_ = h*least;
        }
    }
    lattice_.flow.wallGap = wall < HUGE_VAL ? wall : 0;
}


void worstParticles::findSolid(const checkedCase& c, const checkedTime& t)
{
    const springNetwork net =
        springNetwork::of(c.solids->mesh, c.solids->properties);
    double stiffness = 0, lightness = 0;
    for (int i = 0; i < net.n; ++i)
    {
        double k = 0;
        for (int b = net.bondBegin[i]; b < net.bondBegin[i + 1]; ++b)
        {
            k += net.bondK[b];
        }
        if (raise(stiffness, k/net.mass[i]))
        {
            stiffest = i;
        }
    }
    const std::vector<double> yielding =
        yieldingMasses(c.solids->mesh, c.solids->properties, net.mass);
    for (std::size_t i = 0; i < t.state.wallNode.size(); ++i)
    {
        const int node = t.state.wallNode[i];
        if (node >= 0 && raise(lightness, t.state.area[i]/yielding[node]))
        {
            lightestNode = node;
        }
    }
}


std::vector<termLimit> worstParticles::limits
(
    const particleSchemes& schemes,
    const solidScales& solid
) const
{
    caseScales local = lattice_;
    local.solid = solid;
    std::vector<termLimit> all = termLimits(schemes, local);
    if (lattice_.flow.c > 0)
    {
        all[0].deltaT = acousticLimit(schemes, sound_);
        all[1].deltaT = viscousLimit(schemes, viscosity_);
        all[2].deltaT = convectiveLimit(1, approach_);
        all[3].deltaT = bodyForceLimit(nearest_, lattice_.force);
    }
    return all;
}


caseScales worstParticles::wholeCase(const solidScales& solid) const
{
    caseScales whole = lattice_;
    whole.solid = solid;
    return whole;
}
