// The cuda backend against the cpu backend in double precision.

#include "common/column.H"
#include "common/fluids.H"
#include "common/lattice.H"
#include "common/needsGpu.H"
#include "common/vortex.H"

#include <cmath>
#include <cstring>

using namespace gpuFsi;

namespace
{

struct scene
{
    domain space;
    fluidProperties fluid;
    particleSchemes schemes;
    hostState state;
    double dt;
};

//- sorts: how often the bulk was stored anew
hostState run
(
    const scene& s,
    const char* backend,
    const char* precision,
    long* sorts = nullptr
)
{
    const auto solver = fluidSolver::make
    (
        backend, precision, s.space, s.fluid, s.schemes, s.state
    );
    for (int k = 0; k < 60; ++k)
    {
        solver->step(k*s.dt, s.dt);
        if (solver->maintenanceDue())
        {
            solver->maintain();
        }
    }
    solver->maintain();
    if (sorts)
    {
        *sorts = solver->nSorts();
    }
    return solver->download();
}

//- Largest difference over the largest value
double difference(const hostState& a, const hostState& b)
{
    double rho = 0, u = 0, worstRho = 0, worstU = 0, worstX = 0;
    for (std::size_t i = 0; i < a.fluid.size(); ++i)
    {
        const vector dU = a.fluid.U[i] - b.fluid.U[i];
        const vector dX = a.fluid.positions[i] - b.fluid.positions[i];
        rho = std::max(rho, std::abs(a.fluid.deltaRho[i]));
        u = std::max(u, std::sqrt(dot(a.fluid.U[i], a.fluid.U[i])));
        worstRho = std::max
        (
            worstRho, std::abs(a.fluid.deltaRho[i] - b.fluid.deltaRho[i])
        );
        worstU = std::max(worstU, std::sqrt(dot(dU, dU)));
        worstX = std::max(worstX, std::sqrt(dot(dX, dX)));
    }
    return std::max({worstRho/rho, worstU/u, worstX});
}

bool sameBytes(const hostState& a, const hostState& b)
{
    const auto same = [](const auto& u, const auto& v)
    {
        return std::memcmp(u.data(), v.data(), u.size()*sizeof(u[0])) == 0;
    };
    return same(a.fluid.positions, b.fluid.positions)
      && same(a.fluid.U, b.fluid.U)
      && same(a.fluid.deltaRho, b.fluid.deltaRho)
      && same(a.walls.deltaRho, b.walls.deltaRho);
}

scene pulse(int dimensions, double displace, double amplitude)
{
    scene s{};
    s.space = periodicBox(dimensions == 3 ? 24 : 60, dimensions, 15);
    s.fluid = publishedFluid();
    s.schemes = defaultSchemes(s.space);
    s.state = latticeState(s.space, amplitude, 5, displace);
    s.dt = 0.02;
    return s;
}

scene piston(particleSchemes::search method)
{
    scene s{};
    s.space = columnDomain(40, 6, 1);
    s.fluid = publishedFluid(0.01);
    s.fluid.g = vector{0.1, 0, 0};
    s.fluid.motions.resize(2);
    s.fluid.motions[0] = wallMotion::make(dictionary::fromString
    (
        "type oscillation; amplitude (0.02 0 0); omega 3; phase 0;", "wall"
    ));
    s.schemes = defaultSchemes(s.space);
    s.schemes.method = method;
    s.schemes.update = particleSchemes::trigger::interval;
    s.schemes.interval = 10;
    s.state = columnState(s.space);
    s.dt = 0.005;
    return s;
}

//- The fastest goes 2.4 spacings in 60 steps
scene vortices(int dimensions)
{
    scene s{};
    s.space = periodicBox(dimensions == 3 ? 24 : 60, dimensions, 1);
    s.fluid = publishedFluid(0.05);
    s.fluid.c = 5;
    s.schemes = defaultSchemes(s.space);
    s.state = vortexState(s.space, 1, 0.2);
    s.dt = 0.04*s.space.spacing;
    return s;
}

} // namespace

TEST(cuda, pulseAgreesWithCpuInDouble)
{
    NEEDS_GPU;
    for (int D : {2, 3})
    {
        for (double displace : {0.0, 0.2})
        {
            const scene s = pulse(D, displace, 0.01);
            EXPECT_LT(difference(run(s, "cuda", "double"),
                run(s, "cpu", "double")), 1e-12) << D << "-D " << displace;
        }
    }
}

TEST(cuda, everyEquationOfStateAgrees)
{
    NEEDS_GPU;
    for (double gamma : {7.0, 1.4})
    {
        scene s = pulse(3, 0.1, 0.1);
        s.fluid.eos = fluidProperties::state::Tait;
        s.fluid.gamma = gamma;
        EXPECT_LT(difference(run(s, "cuda", "double"),
            run(s, "cpu", "double")), 1e-12) << gamma;
    }
}

TEST(cuda, wallsAndBothSearchesAgree)
{
    NEEDS_GPU;
    for (auto method : {particleSchemes::search::cellSearch,
        particleSchemes::search::localUpdate})
    {
        const scene s = piston(method);
        EXPECT_LT(difference(run(s, "cuda", "double"),
            run(s, "cpu", "double")), 1e-12);
    }
}

TEST(cuda, radialRK2Agrees)
{
    NEEDS_GPU;
    std::vector<scene> scenes;
    for (double gamma : {0.0, 7.0, 1.4})
    {
        for (int D : {2, 3})
        {
            scenes.push_back(pulse(D, 0.1, 0.1));
            scenes.back().fluid.eos = gamma > 0
              ? fluidProperties::state::Tait
              : fluidProperties::state::isothermal;
            scenes.back().fluid.gamma = gamma;
        }
    }
    scenes.push_back(piston(particleSchemes::search::cellSearch));
    for (scene& s : scenes)
    {
        s.schemes.time = particleSchemes::timeScheme::RK2;
        EXPECT_LT(difference(run(s, "cuda", "double"),
            run(s, "cpu", "double")), 1e-12);
        EXPECT_TRUE(sameBytes(run(s, "cuda", "single"),
            run(s, "cuda", "single")));
    }
}

TEST(cuda, everyAreaWeightSchemeAgrees)
{
    NEEDS_GPU;
    using schemes = particleSchemes;
    for (auto time : {schemes::timeScheme::Euler,
        schemes::timeScheme::symplecticEuler, schemes::timeScheme::RK2})
    {
        for (int options = 0; options < 8; ++options)
        {
            for (int D : {2, 3})
            {
                scene s = pulse(D, 0.2, 0.1);
                s.schemes.areaWeights = schemes::weight::moment;
                s.schemes.time = time;
                s.schemes.weightExponent = D;
                s.schemes.faces = options & 1
                  ? schemes::face::hermite : schemes::face::linear;
                s.schemes.laplacianFactor = 4.0/3;
                s.dt = 0.005;
                s.schemes.dissipation = options & 2 ? 0.2 : 0;
                s.schemes.shifting = options & 4 ? 0.5 : 0;
                EXPECT_LT(difference(run(s, "cuda", "double"),
                    run(s, "cpu", "double")), 1e-12)
                    << D << "-D options " << options;
            }
        }
    }
}

TEST(cuda, areaWeightsBesideMovingAndSlipWallsAgree)
{
    NEEDS_GPU;
    for (bool slip : {false, true})
    {
        scene s = piston(particleSchemes::search::cellSearch);
        s.fluid.slip = {slip, slip};
        s.schemes.areaWeights = particleSchemes::weight::moment;
        s.schemes.time = particleSchemes::timeScheme::symplecticEuler;
        s.schemes.faces = particleSchemes::face::hermite;
        s.schemes.dissipation = 0.1;
        s.schemes.shifting = 0.5;
        EXPECT_LT(difference(run(s, "cuda", "double"),
            run(s, "cpu", "double")), 1e-12);
    }
}

TEST(cuda, superStepsAgree)
{
    NEEDS_GPU;
    for (int D : {2, 3})
    {
        scene s = pulse(D, 0.2, 0.1);
        s.fluid.mu = 20;
        s.schemes.areaWeights = particleSchemes::weight::moment;
        s.schemes.time = particleSchemes::timeScheme::symplecticEuler;
        s.schemes.superSteps = true;
        EXPECT_LT(difference(run(s, "cuda", "double"),
            run(s, "cpu", "double")), 1e-12) << D;
        EXPECT_TRUE(sameBytes(run(s, "cuda", "single"),
            run(s, "cuda", "single")));
    }
    for (bool slip : {false, true})
    {
        scene s = piston(particleSchemes::search::cellSearch);
        s.fluid.mu = 1;
        s.fluid.slip = {slip, slip};
        s.schemes.areaWeights = particleSchemes::weight::moment;
        s.schemes.time = particleSchemes::timeScheme::symplecticEuler;
        s.schemes.superSteps = true;
        EXPECT_LT(difference(run(s, "cuda", "double"),
            run(s, "cpu", "double")), 1e-12) << slip;
    }
}

//- The same energy, and so the same step to stop at
TEST(cuda, energyIsWatchedAlike)
{
    scene s = pulse(2, 0, 0);
    s.schemes.areaWeights = particleSchemes::weight::moment;
    s.schemes.time = particleSchemes::timeScheme::RK2;
    s.schemes.dissipation = 0;
    s.fluid.mu = 0;
    s.dt = 0.6*s.space.spacing/s.fluid.c;
    for (std::size_t i = 0; i < s.state.fluid.size(); ++i)
    {
        s.state.fluid.U[i] = {0.02*hashed(2*i), 0.02*hashed(2*i + 1), 0};
    }
    const auto stoppedBy = [&](const char* backend) -> std::string
    {
        const auto solver = fluidSolver::make
        (
            backend, "double", s.space, s.fluid, s.schemes, s.state
        );
        solver->watchEnergy();
        try
        {
            for (int k = 0; k < 5000; ++k)
            {
                solver->step(k*s.dt, s.dt);
                if (solver->maintenanceDue())
                {
                    solver->maintain();
                }
            }
        }
        catch (const brokenState& e)
        {
            const std::string what = e.what();
            return what.substr(0, what.find(" Fastest"));
        }
        return "";
    };
    const std::string said = stoppedBy("cpu");
    EXPECT_NE(said.find("kinetic energy"), std::string::npos) << said;
    NEEDS_GPU;
    EXPECT_EQ(said, stoppedBy("cuda"));
}

TEST(cuda, storedAnewAgreesWithCpuAndWithItself)
{
    NEEDS_GPU;
    for (int D : {2, 3})
    {
        for (bool full : {false, true})
        {
            scene s = vortices(D);
            if (full)
            {
                s.schemes.areaWeights = particleSchemes::weight::moment;
                s.schemes.faces = particleSchemes::face::hermite;
                s.schemes.dissipation = 0.2;
                s.schemes.shifting = 0.5;
            }
            const hostState kept = run(s, "cuda", "double");
            s.schemes.sortDistance = 0.4;
            s.schemes.sortWear = 0;
            long sorts = 0, sortsCpu = 0;
            const hostState a = run(s, "cuda", "double", &sorts);
            const hostState b = run(s, "cpu", "double", &sortsCpu);
            EXPECT_GE(sorts, 3);
            EXPECT_EQ(sorts, sortsCpu);
            EXPECT_TRUE(sameBytes(a, kept));
            // Hundreds of steps: round-off grows with the vortices' strain
            EXPECT_LT(difference(a, b), 1e-10)
                << D << "-D " << (full ? "full" : "radial");
        }
    }
}

TEST(cuda, storedAnewBesideMovingWallsKeepsTheBytes)
{
    NEEDS_GPU;
    scene s = piston(particleSchemes::search::cellSearch);
    s.schemes.sortDistance = 0.01;
    s.schemes.sortWear = 0;
    long sorts = 0;
    const hostState a = run(s, "cuda", "double", &sorts);
    EXPECT_GE(sorts, 1);
    s.schemes.sortDistance = 1e9;
    EXPECT_TRUE(sameBytes(a, run(s, "cuda", "double")));
}

TEST(cuda, singleFollowsDouble)
{
    NEEDS_GPU;
    const scene s = pulse(3, 0, 0.01);
    const hostState a = run(s, "cuda", "single");
    const hostState b = run(s, "cpu", "double");
    double worst = 0;
    for (std::size_t i = 0; i < a.fluid.size(); ++i)
    {
        worst = std::max(worst,
            std::abs(a.fluid.deltaRho[i] - b.fluid.deltaRho[i]));
    }
    EXPECT_LT(worst, 1e-5*0.01);
}

TEST(cuda, twoRunsHaveTheSameBytes)
{
    NEEDS_GPU;
    for (const char* precision : {"single", "double"})
    {
        const scene s = pulse(3, 0.2, 0.1);
        EXPECT_TRUE(sameBytes(run(s, "cuda", precision),
            run(s, "cuda", precision)));
        const scene p = piston(particleSchemes::search::localUpdate);
        EXPECT_TRUE(sameBytes(run(p, "cuda", precision),
            run(p, "cuda", precision)));
    }
}

TEST(cuda, breakdownIsReported)
{
    NEEDS_GPU;
    scene s = pulse(3, 0, 0.1);
    s.dt = 20;
    EXPECT_THROW(run(s, "cuda", "single"), brokenState);
}
