// The energy ledger of fluid and solids: conservation is the oracle.

#include "barColumn.H"
#include "periodicBar.H"

#include "functionObjects/internalEnergy.H"

#include <fmt/format.h>
#include <gtest/gtest.h>

using namespace gpuFsi;

namespace
{

double fluidEnergy(const hostState& s, const fluidProperties& fluid)
{
    const auto energy = internalEnergy
    (
        s.fluid.deltaRho, s.rho0,
        [&](double rho) { return fluid.pressure(rho); }
    );
    double sum = 0;
    for (std::size_t i = 0; i < s.fluid.size(); ++i)
    {
        const vector& u = s.fluid.U[i];
        sum += s.fluid.mass[i]*(dot(u, u)/2 + energy[i]);
    }
    return sum;
}

//- Put into the fluid by all terms of its ledger
double booked(const fluidWorks& w)
{
    return w.boundary - w.viscousLoss - w.momentumLoss - w.densityLoss
      + w.shifting + w.body + w.staggering;
}

void march(fluidSolver& solver, int steps, double dt)
{
    for (int k = 0; k < steps; ++k)
    {
        solver.step(k*dt, dt);
        if (solver.maintenanceDue())
        {
            solver.maintain();
        }
    }
}

vector sumOf(const std::vector<vector>& values)
{
    vector sum{0, 0, 0};
    for (const vector& v : values)
    {
        sum += v;
    }
    return sum;
}

void stir(hostState& s)
{
    for (std::size_t i = 0; i < s.fluid.size(); ++i)
    {
        const vector& x = s.fluid.positions[i];
        const double slant = 0.01*std::sin(2*M_PI*x.y/0.3125);    // across
        s.fluid.U[i] =
        {
            0.05*std::sin(3*x.x) + slant, 0.05*std::cos(6*x.x) + slant, 0
        };
        s.fluid.deltaRho[i] = 0.02*std::cos(3*x.x);
    }
}

//- Between a wall that moves, x = 0, and a bar held at both ends
barColumn heldColumn(double mu, const std::string& motion)
{
    barColumn s;
    s.fluid = publishedFluid(mu);
    s.fluid.motions.resize(2);
    s.fluid.motions[0] = wallMotion::make(dictionary::fromString(motion));
    s.solids.properties = material
    (
        s.solids.mesh,
        "E 200; nu 0.3; parts { left { type fixed; } right { type fixed; } }"
    );
    return s;
}

//- Of a belt at x = 0 with speed V, in steady Couette flow
barColumn beltColumn(double V)
{
    barColumn s = heldColumn
    (
        0.1, fmt::format("type sliding; velocity (0 {} 0);", V)
    );
    for (std::size_t i = 0; i < s.state.fluid.size(); ++i)
    {
        s.state.fluid.U[i] = {0, V*(1 - s.state.fluid.positions[i].x), 0};
    }
    return s;
}

} // namespace


//- Each term by itself; together what the fluid has gained
TEST(ledger, everyJouleOfTheFluidHasAName)
{
    using scheme = particleSchemes::timeScheme;
    for (const scheme time : {scheme::Euler, scheme::symplecticEuler,
        scheme::RK2})
    {
        for (const bool rich : {false, true})
        {
            barColumn s;
            s.schemes.time = time;
            stir(s.state);
            if (rich)
            {
                s.fluid = publishedFluid(0.01);
                s.fluid.g = vector{0.1, 0.2, 0};
                s.schemes.faces = particleSchemes::face::hermite;
                s.schemes.laplacianFactor = 4.0/3;
                s.schemes.dissipation = 0.2;
                s.schemes.shifting = 0.5;
            }
            const auto solver = s.solver();
            solver->keepLedger();
            march(*solver, 50, 0.005);
            const hostState after = solver->download();
            const double gained =
                fluidEnergy(after, s.fluid) - fluidEnergy(s.state, s.fluid);
            const double total = fluidEnergy(after, s.fluid);
            EXPECT_NEAR(gained, booked(after.works), 1e-6*total)
                << "scheme " << int(time) << " rich " << rich;
            EXPECT_EQ(after.works.viscousLoss > 0, rich);
            EXPECT_EQ(after.works.momentumLoss != 0, rich);
            EXPECT_EQ(after.works.shifting != 0, rich);
        }
    }
}


//- A steady linear profile: mu (V/L)^2 is lost, and the belt puts it in
TEST(ledger, beltsFeedWhatViscosityTakes)
{
    const double V = 0.1, dt = 1e-4;
    const int steps = 20;
    const barColumn s = beltColumn(V);
    const auto solver = s.solver();
    solver->keepLedger();
    march(*solver, steps, dt);
    const fluidWorks w = solver->download().works;
    const double across = s.across*s.space.spacing;
    const double exact = 0.1*V*V*across*steps*dt;
    EXPECT_NEAR(w.viscousLoss, exact, 1e-6*exact);
    EXPECT_NEAR(w.walls, exact, 1e-6*exact);
    EXPECT_NEAR(w.boundary, exact, 1e-6*exact);
}


//- The fluid's sums over a driven wall against pressure times area at the wall
TEST(ledger, pistonsAreMeasuredOnBothSides)
{
    const barColumn s = heldColumn
    (
        0, "type oscillation; amplitude (0.001 0 0); omega 0.5; phase -1.57;"
    );
    const auto solver = s.solver();
    solver->keepLedger();
    march(*solver, 150, 0.02);
    const fluidWorks w = solver->download().works;
    EXPECT_GT(w.walls, 0);
    EXPECT_NEAR(w.boundary, w.walls, 0.02*w.walls);
}


//- With the reaction the forces of fluid and solid cancel to round-off
TEST(ledger, facesAndLoadsAreCompared)
{
    using law = couplingProperties::law;
    for (const law force : {law::surface, law::reaction})
    {
        periodicBar s;
        s.solids.coupling.force = force;
        stir(s.state);
        const auto solver = s.solver();
        solver->keepLedger();
        const double before = s.momentum(solver->download()).x;
        march(*solver, 100, 0.005);
        const hostState after = solver->download();
        const double onFluid = after.works.faceForce.x;
        const double onSolid = sumOf(after.solid.load).x;
        const double drift = s.momentum(after).x - before;
        const double most = s.sumOfForces(after);
        fmt::print
        (
            "{}: net of faces and loads {:.2e} of the forces' sum, drift of "
            "momentum {:.2e} of the fluid's\n",
            force == law::surface ? "surface" : "reaction",
            (onFluid + onSolid)/most, drift/s.fluidMomentum(s.state)
        );
        EXPECT_GT(most, 0);
        const double share = force == law::reaction ? 1e-13 : 1;
        EXPECT_NEAR(onFluid + onSolid, 0, share*most);
        EXPECT_NEAR(drift, 0, 0.1*s.fluidMomentum(s.state));
    }
}


//- Watching changes nothing
TEST(ledger, aRunIsTheSameWithIt)
{
    barColumn s;
    s.schemes.dissipation = 0.2;
    stir(s.state);
    const auto plain = s.solver(), watched = s.solver();
    watched->keepLedger();
    EXPECT_GT(watched->bytes(), plain->bytes());
    march(*plain, 20, 0.005);
    march(*watched, 20, 0.005);
    const hostState a = plain->download(), b = watched->download();
    EXPECT_EQ(a.fluid.deltaRho, b.fluid.deltaRho);
    EXPECT_FALSE(a.works.kept);
    for (std::size_t i = 0; i < a.solid.size(); ++i)
    {
        EXPECT_EQ(a.solid.positions[i].x, b.solid.positions[i].x);
    }
}


TEST(ledger, needsAreaWeights)
{
    barColumn s;
    s.schemes = defaultSchemes(s.space);
    EXPECT_THROW(s.solver()->keepLedger(), userError);
}
