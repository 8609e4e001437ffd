// The acoustic pulse by the area-weight schemes against the exact solution:
// relative L2 error of rho - rho0 over r < 6 at t = 1.2.

#include "common/fluids.H"
#include "common/lattice.H"
#include "exact/exactSolution.H"

#include <fmt/format.h>
#include <gtest/gtest.h>

using namespace gpuFsi;

namespace
{

struct variant
{
    bool hermite;
    double laplacianFactor;
    double displace;
    double amplitude;
};

double errorOf(int n, double dt, const variant& v)
{
    const domain d = periodicBox(n, 3, 15);
    const fluidProperties fluid = publishedFluid();
    particleSchemes schemes = defaultSchemes(d);
    schemes.areaWeights = particleSchemes::weight::moment;
    schemes.time = particleSchemes::timeScheme::RK2;
    schemes.faces = v.hermite ? particleSchemes::face::hermite
      : particleSchemes::face::linear;
    schemes.laplacianFactor = v.laplacianFactor;
    const auto solver = fluidSolver::make
    (
        "cpu", "double", d, fluid, schemes,
        latticeState(d, v.amplitude, 5, v.displace)
    );
    const int steps = int(std::lround(1.2/dt));
    for (int k = 0; k < steps; ++k)
    {
        solver->step(k*dt, dt);
        if (solver->maintenanceDue())
        {
            solver->maintain();
        }
    }
    const hostState s = solver->download();

    fluidConstants constants;
    constants.c = fluid.c;
    constants.nu = fluid.mu;
    const auto exact = exactSolution::make
    (
        "acousticPulse",
        dictionary::fromString
        (
            fmt::format("amplitude {:.17g}; width 5;", v.amplitude)
        ),
        constants
    );
    std::vector<vector> points;
    std::vector<double> found;
    for (std::size_t i = 0; i < s.fluid.size(); ++i)
    {
        const vector& x = s.fluid.positions[i];
        if (dot(x, x) < 36)
        {
            points.push_back(x);
            found.push_back(s.fluid.deltaRho[i]);
        }
    }
    const auto expected = exact->scalar("deltaRho", points, 1.2);
    double e = 0, size = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        e += (found[i] - expected[i])*(found[i] - expected[i]);
        size += expected[i]*expected[i];
    }
    const double result = std::sqrt(e/size);
    std::printf("h = 15/%d, %s, displaced %g, amplitude %g: %.5f\n", n,
        v.hermite ? "hermite" : "linear", v.displace, v.amplitude, result);
    return result;
}

} // namespace

TEST(pulse, displacedParticles)
{
    EXPECT_LE(errorOf(48, 0.02, {false, 1, 0.2, 0.01}), 0.0065);
    EXPECT_LE(errorOf(48, 0.02, {true, 1, 0.2, 0.01}), 0.0030);
}

TEST(pulse, linearFacesOnTheLattice)
{
    const double a = errorOf(32, 0.02, {false, 1, 0, 0.01});
    const double b = errorOf(48, 0.02, {false, 1, 0, 0.01});
    EXPECT_GE(std::log(a/b)/std::log(1.5), 1.9);
}

TEST(pulse, hermiteFacesOnTheLattice)
{
    // dt/h^2 fixed
    const variant v{true, 4.0/3, 0, 1e-5};
    const double a = errorOf(32, 0.02, v);
    EXPECT_LE(a, 0.0013);
    EXPECT_LE(errorOf(48, 0.02*32*32/48/48, v), 0.00028);
    const double b = errorOf(64, 0.005, v);
    EXPECT_GE(std::log2(a/b), 3.7);
}
