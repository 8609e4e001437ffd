// A body force that varies with time: its file, the stages' times, and a
// channel that it swings (Womersley's solution).

#include "common/column.H"
#include "common/fluids.H"
#include "common/lattice.H"
#include "exact/exactSolution.H"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <unistd.h>

using namespace gpuFsi;

namespace
{

namespace fs = std::filesystem;

using scheme = particleSchemes::timeScheme;

constexpr double pi = 3.14159265358979323846;

bodyForce force(const std::string& entries)
{
    const fs::path casePath = fs::temp_directory_path()
        /("bodyForce" + std::to_string(getpid()));
    fs::create_directories(casePath/"constant");
    std::ofstream(casePath/"constant"/"g") << entries;
    const bodyForce g = bodyForce::read(casePath);
    fs::remove_all(casePath);
    return g;
}

bool says(const std::string& value, const std::string& text)
{
    try
    {
        force("value " + value + ";").at(0);
    }
    catch (const userError& e)
    {
        return std::string(e.what()).find(text) != std::string::npos;
    }
    return false;
}

//- radial: the published operators, of Euler and RK2 alone
particleSchemes schemes(const domain& d, scheme time, bool radial = false)
{
    particleSchemes s = defaultSchemes(d);
    s.areaWeights = radial ? particleSchemes::weight::radial
      : particleSchemes::weight::moment;
    s.time = time;
    return s;
}

hostState march
(
    const domain& d,
    const fluidProperties& fluid,
    const particleSchemes& s,
    hostState state,
    double t,
    int n,
    double dt
)
{
    const auto solver =
        fluidSolver::make("cpu", "double", d, fluid, s, std::move(state));
    for (int k = 0; k < n; ++k)
    {
        solver->step(t + k*dt, dt);
        solver->maintain();
    }
    return solver->download();
}

const std::vector<scheme> allSchemes
{
    scheme::Euler, scheme::symplecticEuler, scheme::RK2
};

} // namespace


TEST(bodyForce, numbersAndExpressions)
{
    const bodyForce still = force("value (0 -9.81 0);");
    EXPECT_FALSE(still.varies());
    EXPECT_EQ(still.at(7).y, -9.81);
    EXPECT_FALSE(still.acts(0));
    EXPECT_TRUE(still.acts(1));

    const bodyForce swings = force
    (
        "dimensions [0 1 -2 0 0 0 0]; value (\"2*sin(pi*t)\" 3 \"0\");"
    );
    EXPECT_TRUE(swings.varies());
    EXPECT_NEAR(swings.at(0.5).x, 2, 1e-15);
    EXPECT_NEAR(swings.at(1.5).x, -2, 1e-15);
    EXPECT_EQ(swings.at(1.5).y, 3);
    EXPECT_TRUE(swings.acts(0) && swings.acts(1));
    EXPECT_FALSE(swings.acts(2));

    EXPECT_FALSE(force("value (\"2*3\" \"0\" 0);").varies());
    EXPECT_EQ(force("value (\"2*3\" \"0\" 0);").at(1).x, 6);
    EXPECT_FALSE(bodyForce().acts());
}


TEST(bodyForce, wrongOnesAreNamed)
{
    EXPECT_TRUE(says("(\"x*t\" 0 0)", "depends on x"));
    EXPECT_TRUE(says("(\"t\" 0)", "2 components"));
    EXPECT_TRUE(says("(\"cos(w*t)\" 0 0)", "cannot be read"));
    EXPECT_TRUE(says("\"cos(t)\"", "list"));
    EXPECT_TRUE(says("(cos 0 0)", "(x y z)"));
    EXPECT_TRUE(says("(\"1/t\" 0 0)", "is inf at t = 0"));
}


//- Nothing but the force: v and x of its midpoint sums, errors (w dt)^2/24.
//  36 particles: the last pack of eight is not full.
TEST(bodyForce, swingsAnUnboundedFluid)
{
    domain d = columnDomain(6, 6, 1);
    d.periodic = {true, true, false};
    d.walls.clear();
    hostState state = columnState(d);
    const std::size_t n = state.fluid.size();
    state.walls = {};
    state.normals.clear();
    state.area.clear();
    state.patch.clear();
    state.wallReference.clear();
    state.wallNames.clear();
    fluidProperties fluid = publishedFluid(0.1);
    fluid.g = force("value (0 \"0.01*cos(2*t)\" 0);");
    const double dt = 0.05, t = 0.3;
    for (const scheme time : allSchemes)
    {
        const hostState end =
            march(d, fluid, schemes(d, time), state, t, 20, dt);
        const double v = 0.005*(std::sin(2*(t + 1)) - std::sin(2*t));
        const double x = 0.0025*(std::cos(2*t) - std::cos(2*(t + 1)))
          - 0.005*std::sin(2*t);
        for (std::size_t i = 0; i < n; ++i)
        {
            const double far = x + state.fluid.positions[i].y;
            EXPECT_NEAR(end.fluid.U[i].y, v, 5e-4*0.01);
            EXPECT_NEAR
            (
                std::remainder(end.fluid.positions[i].y - far, d.hi.y), 0,
                2e-5
            );
            EXPECT_NEAR(end.fluid.U[i].x, 0, 1e-12);
        }
    }
}


//- Over one step that of the middle
TEST(bodyForce, swingsRadialInSecondOrder)
{
    const domain d = periodicBox(8, 2, 1);
    fluidProperties fluid = publishedFluid(0.1);
    fluid.g = force("value (0 \"0.01*cos(2*t)\" 0);");
    const double dt = 0.05, t = 0.3;
    const hostState end = march
    (
        d, fluid, schemes(d, scheme::RK2, true), latticeState(d, 0, 1), t, 1, dt
    );
    for (const vector& u : end.fluid.U)
    {
        EXPECT_NEAR(u.y, dt*0.01*std::cos(2*(t + 0.5*dt)), 1e-12);
    }
}


//- One step is that of a steady force: the fluid's of the middle, the walls'
//  hydrostatic density of the end
TEST(bodyForce, oneStepIsThatOfASteadyForce)
{
    const domain d = columnDomain(8, 4, 1);
    const hostState state = columnState(d);
    const double t = 0.4, dt = 0.01;
    fluidProperties fluid = publishedFluid(0.1);
    fluid.motions.resize(2);
    const auto result = [&](const bodyForce& g, scheme time, bool radial)
    {
        fluid.g = g;
        return march(d, fluid, schemes(d, time, radial), state, t, 1, dt);
    };
    const bodyForce law = force("value (\"sin(3*t)\" 0 0);");
    const auto steady = [&](double at) { return bodyForce(law.at(at)); };
    for (const bool radial : {true, false})
    {
        const hostState a = result(law, scheme::Euler, radial);
        const hostState middle =
            result(steady(t + 0.5*dt), scheme::Euler, radial);
        const hostState last = result(steady(t + dt), scheme::Euler, radial);
        EXPECT_GT(a.fluid.U[0].x, 0);
        for (std::size_t i = 0; i < a.fluid.size(); ++i)
        {
            EXPECT_EQ(a.fluid.U[i].x, middle.fluid.U[i].x);
        }
        for (std::size_t i = 0; i < a.walls.size(); ++i)
        {
            EXPECT_NE(a.walls.deltaRho[i], 0);
            EXPECT_NEAR
            (
                a.walls.deltaRho[i], last.walls.deltaRho[i],
                1e-3*std::fabs(a.walls.deltaRho[i])
            );
        }
    }
}


TEST(bodyForce, swingsAChannelAsWomersleyHasIt)
{
    const domain d = columnDomain(24, 4, 1);
    fluidProperties fluid = publishedFluid(0.05);
    fluid.g = force("value (0 \"1e-3*cos(2*pi*t + 0.5)\" 0);");
    fluid.motions.resize(2);
    const dictionary dict = dictionary::fromString
    (
        "length 1; g (0 1e-3 0); omega 6.283185307179586; phase 0.5;"
    );
    fluidConstants constants;
    constants.nu = 0.05;
    const auto exact = exactSolution::make("womersley", dict, constants);
    const double dt = 0.01;
    const auto errorOf = [&](scheme time, bool radial)
    {
        const hostState end = march
        (
            d, fluid, schemes(d, time, radial), columnState(d), 0, 120, dt
        );
        double difference = 0, size = 0;
        const auto U = exact->vectors("U", end.fluid.positions, 1.2);
        for (std::size_t i = 0; i < U.size(); ++i)
        {
            difference += std::pow(end.fluid.U[i].y - U[i].y, 2);
            size += U[i].y*U[i].y;
        }
        return std::sqrt(difference/size);
    };
    for (const scheme time : allSchemes)
    {
        EXPECT_LT(errorOf(time, false), 0.01) << int(time);
    }
    EXPECT_LT(errorOf(scheme::Euler, true), 0.03);
    EXPECT_LT(errorOf(scheme::RK2, true), 0.03);
}
