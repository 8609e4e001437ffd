// The midpoint rule against explicit stepping, exact frequencies and limits.

#include "blocks.H"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstring>
#include <omp.h>

using namespace gpuFsi;

namespace
{

constexpr double pi = 3.14159265358979323846;

double largestOffset
(
    const std::vector<vector>& a,
    const std::vector<vector>& b
)
{
    double largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
    {
        const vector d = a[i] - b[i];
        largest = std::max(largest, std::sqrt(dot(d, d)));
    }
    return largest;
}

//- Everything that exerts a force, for half a second in `steps`
hostSolid everything(int D, const char* stepping, int steps)
{
    const solidMesh mesh = block(D, 6, 2, 2, 0.2, 0.1);
    const solidProperties p = material
    (
        mesh,
        "E 10; nu 0.4; dashpot 0.01; friction 0.5; viscous 0.2; parts {"
        " left { type oscillation; amplitude (0 0.1 0); omega 3; }"
        " right { type pressure; pressure 0.5; ramp 0.7; } }",
        {0.3, -1, 0}, std::string(stepping) + " tolerance 1e-10;"
    );
    solidState s;
    s.load.assign(mesh.size(), vector{0.001, 0, 0});
    const auto solver = elasticSolver::make("cpu", mesh, p, s);
    const double dt = 0.5/steps;
    march(*solver, steps, dt);
    return solver->download();
}

//- A bar of cells nx x 2 clamped left and displaced along its first mode
struct bar
{
    solidMesh mesh;
    std::unique_ptr<elasticSolver> solver;

    bar(int nx, double amplitude, const std::string& stepping, double E = 1)
    :
        mesh(block(2, nx, 3, 0, 1.0/nx, 0, true))
    {
        solidState s;
        s.positions = mesh.points;
        for (vector& x : s.positions)
        {
            x.x += amplitude*std::sin(pi/2*x.x);
        }
        solver = elasticSolver::make
        (
            "cpu", mesh,
            material
            (
                mesh,
                fmt::format("E {}; parts {{ left {{ type fixed; }} }}", E),
                {}, stepping
            ),
            s
        );
    }

    double tip(int nx) const { return solver->positions()[nx].x - 1; }
};

double productsAStep(const std::string& text)
{
    const std::size_t at = text.find(" steps of ");
    return at == std::string::npos ? 0 : std::stod(text.substr(at + 10));
}

} // namespace


TEST(implicitSolid, convergesToTheExplicitInSecondOrder)
{
    for (const int D : {2, 3})
    {
        const hostSolid exact =
            everything(D, "stepping explicit; subSteps 4;", 500);
        double error[2];
        for (const int r : {0, 1})
        {
            const hostSolid s = everything(D, "stepping implicit;", 20 << r);
            error[r] = largestOffset(s.positions, exact.positions);
        }
        RecordProperty
        (
            fmt::format("errors{}D", D),
            fmt::format("{:.3g} {:.3g}", error[0], error[1])
        );
        EXPECT_LT(error[1], 1e-4);
        EXPECT_NEAR(error[0]/error[1], 4, 0.5);
    }
}


//- The midpoint rule turns a mode by 2 atan(w dt/2) a step
TEST(implicitSolid, frequencyOfABar)
{
    const int nx = 32;
    const double w = pi/2*std::sqrt(1.2), dt = 0.2;
    bar b(nx, 1e-6, "stepping implicit;");
    EXPECT_EQ(b.solver->subSteps(dt), 1);
    const double turn = 2*std::atan(w*dt/2);
    for (int k = 1; k <= 50; ++k)
    {
        b.solver->advance((k - 1)*dt, dt);
        EXPECT_NEAR(b.tip(nx), 1e-6*std::cos(k*turn), 2e-8);
    }
}


TEST(implicitSolid, noEnergyGainOverTwentyPeriods)
{
    bar b(16, 0.05, "stepping implicit;");
    const double start = b.solver->energies().elastic;
    double largest = 0;
    for (int k = 0; k < 370; ++k)
    {
        b.solver->advance(0.2*k, 0.2);
        const solidEnergies e = b.solver->energies();
        largest = std::max(largest, e.kinetic + e.elastic);
    }
    const solidEnergies e = b.solver->energies();
    RecordProperty("largest", fmt::format("{:.6f}", largest/start));
    EXPECT_LT(largest, 1.001*start);
    EXPECT_NEAR((e.kinetic + e.elastic)/start, 1, 0.001);
}


//- Verlet's limit is 2/omega; the first mode is followed all the same
TEST(implicitSolid, stiffBarFarBeyondTheExplicitLimit)
{
    const int nx = 400;
    bar b(nx, 1e-6, "", 1e6);
    const double w = pi/2*std::sqrt(1.2e6);
    const double dt = 1000*2/b.solver->omegaMax();
    EXPECT_EQ(b.solver->subSteps(dt), 1);
    const double turn = 2*std::atan(w*dt/2);
    for (int k = 1; k <= 20; ++k)
    {
        b.solver->advance((k - 1)*dt, dt);
        EXPECT_NEAR(b.tip(nx), 1e-6*std::cos(k*turn), 1e-8);
    }
    const double products = productsAStep(b.solver->describe());
    RecordProperty("products", fmt::format("{:.1f}", products));
    EXPECT_GT(products, 0);
    EXPECT_LT(products, 1000);
}


TEST(implicitSolid, staticLimit)
{
    const solidMesh mesh = block(2, 8, 2, 0, 0.125);
    const solidProperties p = material
    (
        mesh,
        "E 1e6; nu 0.3; plane stress; viscous 2000; parts {"
        " left { type slide; normal (1 0 0); }"
        " right { type traction; traction (10 0 0); ramp 0.05; } }",
        {}, "stepping implicit;"
    );
    const auto solver = elasticSolver::make("cpu", mesh, p);
    march(*solver, 150, 0.001);
    const hostSolid s = solver->download();
    EXPECT_NEAR(s.positions[8].x - 1, 1e-5, 2e-9);
    EXPECT_NEAR(s.stress[4][0], 10, 2e-3);
}


TEST(implicitSolid, ledgerCloses)
{
    const solidMesh mesh = block(3, 8, 2, 2, 0.125);
    const solidProperties p = material
    (
        mesh,
        "E 10; nu 0.35; dashpot 0.002; friction 0.1; viscous 0.1; parts {"
        " left { type oscillation; amplitude (0 0.02 0); omega 3; }"
        " right { type pressure; pressure 0.05; ramp 0.5; } }",
        {0, 0, -0.1}, "stepping implicit;"
    );
    double balance[2];
    for (const int r : {0, 1})
    {
        const auto solver = elasticSolver::make("cpu", mesh, p);
        const double dt = 0.02/(1 + r);
        for (int k = 0; k*dt < 1 - 1e-9; ++k)
        {
            solver->advance(k*dt, dt);
        }
        const solidEnergies e = solver->energies();
        balance[r] = std::fabs
        (
            e.kinetic + e.elastic + e.dissipated
          - e.gravity - e.loads - e.driven - e.fluid
        )/std::fabs(e.driven);
    }
    RecordProperty
    (
        "balance", fmt::format("{:.2g} {:.2g}", balance[0], balance[1])
    );
    EXPECT_LT(balance[1], 1e-4);
    EXPECT_LT(balance[1], 0.4*balance[0]);
}


TEST(implicitSolid, sameBytesForAnyNumberOfThreads)
{
    const int threads = omp_get_max_threads();
    std::vector<vector> first;
    for (const int n : {1, 2})
    {
        omp_set_num_threads(n);
        const solidMesh mesh = block(2, 80, 60, 0, 0.1, 0.1);
        const solidProperties p = material
        (
            mesh, "E 1; nu 0.4; parts { left { type fixed; } }", {0, -1, 0},
            "stepping implicit;"
        );
        const auto solver = elasticSolver::make("cpu", mesh, p);
        solver->advance(0, 0.01);
        const std::vector<vector> x = solver->download().positions;
        first = first.empty() ? x : first;
        EXPECT_EQ
        (
            std::memcmp(x.data(), first.data(), x.size()*sizeof(vector)), 0
        );
    }
    omp_set_num_threads(threads);
}


TEST(implicitSolid, failureNamesTheTime)
{
    const solidMesh mesh = block(2, 4, 2, 0, 0.25);
    const auto solver = elasticSolver::make
    (
        "cpu", mesh, material(mesh, "E 1;", {}, "stepping implicit;")
    );
    solver->load()[0] = {1e200, 0, 0};
    try
    {
        solver->advance(0.5, 0.1);
        ADD_FAILURE() << "no error";
    }
    catch (const userError& e)
    {
        const std::string text = e.what();
        EXPECT_NE(text.find("at the time 0.5 s"), std::string::npos);
        EXPECT_NE(text.find("subSteps"), std::string::npos);
    }
}
