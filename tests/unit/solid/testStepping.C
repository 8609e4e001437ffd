// Bars against the wave equation; energy; the step's bound; the backends.

#include "blocks.H"
#include "device/backend.H"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstring>
#include <omp.h>

using namespace gpuFsi;

namespace
{

constexpr double pi = 3.14159265358979323846;

//- First frequency over c/(4L), by the time of the right end's third crossing
//  of rest, a bar clamped left, periodic in y, nu = 1/4: c^2 = 1.2 E/rho
double frequencyRatio(int nx)
{
    const double h = 1.0/nx, c = std::sqrt(1.2);
    const solidMesh mesh = block(2, nx, 3, 0, h, 0, true);
    const solidProperties p =
        material(mesh, "E 1; parts { left { type fixed; } }");
    solidState s;
    s.positions = mesh.points;
    for (vector& x : s.positions)
    {
        x.x += 1e-6*std::sin(pi/2*x.x);
    }
    const auto solver = elasticSolver::make("cpu", mesh, p, s);
    const double dt = 0.25*h;
    double before = 1e-6, crossing = 0;
    int times = 0;
    for (int k = 0; times < 3; ++k)
    {
        solver->advance(k*dt, dt);
        const double now = solver->positions()[nx].x - 1;
        if (now*before < 0)
        {
            ++times;
            crossing = (k + before/(before - now))*dt;
        }
        before = now;
    }
    return 5.0/(4*crossing)/(c/4);
}

//- Plane strain, L = 8 H, end load; deflection over that of Timoshenko's beam
double cantileverRatio(int across, double nu)
{
    const double load = 1e-7;
    const solidMesh mesh = block(2, 8*across, across, 0, 1.0/across);
    const solidProperties p = material
    (
        mesh,
        fmt::format
        (
            "E 1; nu {}; viscous 0.032; parts {{ left {{ type fixed; }} "
            "right {{ type traction; traction (0 {} 0); ramp 50; }} }}",
            nu, load
        ),
        {}, "stepping explicit;"
    );
    const auto solver = elasticSolver::make("cpu", mesh, p);
    for (int k = 0; k < 70; ++k)
    {
        solver->advance(10.0*k, 10);
    }
    const double length = 8, modulus = 1/(1 - nu*nu);
    const double exact = load
       *(4*length*length*length/modulus + length*2*(1 + nu)*6/5);
    const int tip = across/2*(8*across + 1) + 8*across;
    return solver->positions()[tip].y/exact - 0.5/exact;
}

struct run
{
    std::vector<vector> x;
    solidEnergies energies;
    double exchanged;
    double balance;
};

run shaken(const char* backend, double dt)
{
    const solidMesh mesh = block(3, 8, 2, 2, 0.125);
    const solidProperties p = material
    (
        mesh,
        "E 10; nu 0.35; dashpot 0.002; friction 0.1; viscous 0.1; parts {"
        " left { type oscillation; amplitude (0 0.02 0); omega 3; }"
        " right { type pressure; pressure 0.05; ramp 0.5; } }",
        {0, 0, -0.1}
    );
    const auto solver = elasticSolver::make(backend, mesh, p);
    for (int k = 0; k*dt < 1 - 1e-9; ++k)
    {
        solver->advance(k*dt, dt);
    }
    run r;
    r.x = solver->download().positions;
    r.energies = solver->energies();
    const solidEnergies& e = r.energies;
    r.balance = e.kinetic + e.elastic + e.dissipated
      - e.gravity - e.loads - e.driven - e.fluid;
    r.exchanged = std::fabs(e.driven);
    return r;
}

} // namespace


TEST(elasticBar, frequencyConvergesInSecondOrder)
{
    const double coarse = std::fabs(frequencyRatio(16) - 1);
    const double fine = std::fabs(frequencyRatio(32) - 1);
    RecordProperty("error32", std::to_string(fine));
    EXPECT_LT(fine, 0.005);
    EXPECT_LT(fine, coarse/2.8);
}


TEST(elasticBar, staticExtensionUnderAForce)
{
    const solidMesh mesh = block(2, 8, 2, 0, 0.125);
    const solidProperties p = material
    (
        mesh,
        "E 1; nu 0.3; plane stress; viscous 2; parts {"
        " left { type slide; normal (1 0 0); }"
        " right { type traction; traction (1e-5 0 0); ramp 1; } }"
    );
    const auto solver = elasticSolver::make("cpu", mesh, p);
    march(*solver, 300, 0.1);
    const hostSolid s = solver->download();
    EXPECT_NEAR(s.positions[8].x - 1, 1e-5, 2e-8);
    EXPECT_NEAR(s.stress[4][0], 1e-5, 2e-8);
}


TEST(elasticBar, noEnergyGainOverTwentyPeriods)
{
    const solidMesh mesh = block(2, 16, 4, 0, 1.0/16);
    const solidProperties p =
        material(mesh, "E 1; nu 0.4; parts { left { type fixed; } }");
    // Verlet's energy swings about a mean: the mean must not rise
    double early = 0, late = 0;
    solidState s;
    s.positions = mesh.points;
    for (vector& x : s.positions)
    {
        x.x += 0.01*std::sin(pi/2*x.x);
    }
    const auto solver = elasticSolver::make("cpu", mesh, p, s);
    for (int k = 0; k < 800; ++k)
    {
        solver->advance(0.1*k, 0.1);
        const solidEnergies e = solver->energies();
        (k < 80 ? early : late) += k < 80 || k >= 720
          ? e.elastic + e.kinetic : 0;
    }
    RecordProperty("lateOverEarly", std::to_string(late/early));
    EXPECT_NEAR(late/early, 1, 0.002);
}


//- 4, 8, 16 cells across are too stiff by 7.7, 2.3, 0.8% (nu 0.25) and 6.4,
//  2.5, 1.4% (nu 0.4): order 1.8 towards 0.3% and 1%, as the clamp also holds
//  the section's width, which the beam does not know
TEST(cantilever, tipDeflectionConverges)
{
    for (const double nu : {0.25, 0.4})
    {
        const double coarse = 1 - cantileverRatio(4, nu);
        const double fine = 1 - cantileverRatio(8, nu);
        RecordProperty
        (
            fmt::format("errors{}", int(100*nu)),
            fmt::format("{:.4f} {:.4f}", coarse, fine)
        );
        EXPECT_LT(std::fabs(fine), 0.03);
        EXPECT_LT(std::fabs(fine - (coarse - fine)/3), 0.015);
    }
}


TEST(elasticBar, ledgerCloses)
{
    const run coarse = shaken("cpu", 0.02), fine = shaken("cpu", 0.005);
    EXPECT_LT(std::fabs(fine.balance), 0.01*fine.exchanged);
    EXPECT_LE(std::fabs(fine.balance), std::fabs(coarse.balance));
}


TEST(elasticBar, frequencyIsBelowGershgorinsBound)
{
    for (const char* nu : {"0.25", "0.4"})
    {
        const solidMesh mesh = block(3, 4, 3, 3, 1, 0.1);
        const solidProperties p =
            material(mesh, std::string("E 1; nu ") + nu + ";");
        const auto solver = elasticSolver::make("cpu", mesh, p);
        const double bound =
            std::sqrt(springNetwork::of(mesh, p).gershgorin());
        EXPECT_LE(solver->omegaMax(), bound);
        EXPECT_GT(solver->omegaMax(), 0.4*bound);
        const double dt = 10.0;
        EXPECT_EQ
        (
            solver->subSteps(dt),
            int(std::ceil(dt*solver->omegaMax()/1.6))
        );
    }
}


TEST(elasticBar, sameBytesForAnyNumberOfThreads)
{
    const int threads = omp_get_max_threads();
    std::vector<vector> first;
    for (const int n : {1, 2})
    {
        omp_set_num_threads(n);
        const solidMesh mesh = block(3, 17, 16, 16, 0.1, 0.1);
        const solidProperties p =
            material(mesh, "E 1; nu 0.4; dashpot 0.01;", {0, 0, -1});
        const auto solver = elasticSolver::make("cpu", mesh, p);
        solver->advance(0, 0.1);
        const std::vector<vector> x = solver->download().positions;
        if (first.empty())
        {
            first = x;
        }
        EXPECT_EQ
        (
            std::memcmp(x.data(), first.data(), x.size()*sizeof(vector)), 0
        );
    }
    omp_set_num_threads(threads);
}


TEST(cudaSprings, agreesWithTheCpu)
{
#ifdef FSI_HAVE_CUDA
    if (!cudaBackend::available())
#endif
    {
        GTEST_SKIP() << "no GPU here: cuda backend not compared";
    }
    const run a = shaken("cpu", 0.01), b = shaken("cuda", 0.01);
    for (std::size_t i = 0; i < a.x.size(); ++i)
    {
        EXPECT_NEAR(a.x[i].x, b.x[i].x, 1e-12);
        EXPECT_NEAR(a.x[i].y, b.x[i].y, 1e-12);
        EXPECT_NEAR(a.x[i].z, b.x[i].z, 1e-12);
    }
    EXPECT_NEAR(a.energies.driven, b.energies.driven, 1e-12);
}
