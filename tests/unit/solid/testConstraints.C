// Parts that turn or slide, dashpots beyond the springs, a column that buckles.

#include "blocks.H"

#include <fmt/format.h>
#include <gtest/gtest.h>

using namespace gpuFsi;

namespace
{

const char* const schemes[] = {"stepping explicit;", "stepping implicit;"};

double size(const vector& a)
{
    return std::sqrt(dot(a, a));
}

} // namespace


TEST(constraints, aDrivenEndTurnsExactly)
{
    for (const char* scheme : schemes)
    {
        const solidMesh mesh = block(3, 4, 2, 2, 0.25);
        const solidProperties p = material
        (
            mesh,
            "E 100; nu 0.3; parts { left { type rotation; "
            "origin (0 0.25 0.25); axis (1 0 0); omega 2; } }",
            {}, scheme
        );
        const auto solver = elasticSolver::make("cpu", mesh, p);
        march(*solver, 50, 0.02);
        const double c = std::cos(2.0), s = std::sin(2.0);
        const hostSolid now = solver->download();
        for (std::size_t i = 0; i < mesh.size(); ++i)
        {
            if (mesh.part[i] != 0)
            {
                continue;
            }
            const double y = mesh.points[i].y - 0.25;
            const double z = mesh.points[i].z - 0.25;
            const vector arm{0, c*y - s*z, s*y + c*z};
            const vector centre{0, 0.25, 0.25};
            const vector spin{2, 0, 0};
            EXPECT_LT(size(now.positions[i] - centre - arm), 1e-14);
            EXPECT_LT(size(now.U[i] - cross(spin, arm)), 1e-14);
        }
        const solidEnergies e = solver->energies();
        EXPECT_GT(e.driven, 0);
        EXPECT_NEAR((e.kinetic + e.elastic)/e.driven, 1, 0.03);
    }
}


//- Every particle on a plane: a rigid fall along it, exact in both schemes
TEST(constraints, slideOnAnObliquePlane)
{
    for (const char* scheme : schemes)
    {
        solidMesh mesh = block(3, 3, 2, 2, 0.25);
        mesh.part.assign(mesh.size(), 0);
        const vector g{0.1, -0.3, 0.2}, n = (1/3.0)*vector{1, 2, 2};
        const solidProperties p = material
        (
            mesh,
            "E 1; nu 0.4; parts { left { type slide; normal (1 2 2); } }",
            g, scheme
        );
        const auto solver = elasticSolver::make("cpu", mesh, p);
        march(*solver, 20, 0.05);
        const vector along = g - dot(g, n)*n;
        const hostSolid s = solver->download();
        for (std::size_t i = 0; i < mesh.size(); ++i)
        {
            const vector moved = s.positions[i] - mesh.points[i];
            EXPECT_LT(size(moved - 0.5*along), 1e-12);
            EXPECT_LT(size(s.U[i] - along), 1e-12);
        }
    }
}


//- Dashpots far beyond critical: the sub-steps are enough, half are not
TEST(constraints, dashpotsLimitTheSubSteps)
{
    const solidMesh mesh = block(2, 6, 3, 0, 0.5);
    const solidMesh shaken = block(2, 6, 3, 0, 0.5, 0.02);
    const auto energyAfter = [&](int subSteps)
    {
        const solidProperties p = material
        (
            mesh, "E 1; nu 0.25; dashpot 2;", {},
            "stepping explicit;"
          + (subSteps ? fmt::format(" subSteps {};", subSteps) : "")
        );
        solidState s;
        s.positions = shaken.points;
        const auto solver = elasticSolver::make("cpu", mesh, p, s);
        const double start = solver->energies().elastic;
        for (int k = 0; k < 20; ++k)
        {
            solver->advance(k, 1);
        }
        const solidEnergies e = solver->energies();
        return (e.elastic + e.kinetic)/start;
    };
    const solidProperties p =
        material(mesh, "E 1; nu 0.25; dashpot 2;", {}, "stepping explicit;");
    const int chosen = elasticSolver::make("cpu", mesh, p)->subSteps(1);
    EXPECT_GT(chosen, 10);
    EXPECT_LT(energyAfter(0), 1);
    EXPECT_FALSE(energyAfter(chosen/2) < 1e6);
}


//- A clamped column of length 2 and width 1/4 pressed by a tenth: Euler's
//  strain is 4 pi^2 w^2/(12 L^2) = 0.051, so it bends. By the length that is
//  too much the middle goes out by 2/pi sqrt(L (shortening - Euler's)) = 0.28;
//  2 and 4 cells across, too stiff for bending, give 0.21 and 0.24.
TEST(constraints, aColumnBucklesInImplicitSteps)
{
    const solidMesh mesh = block(2, 32, 4, 0, 0.0625);
    const solidProperties p = material
    (
        mesh,
        "E 1e5; nu 0; viscous 20; parts { left { type fixed; }"
        " right { type translation; velocity (-0.2 0 0); } }",
        {0, 0.1, 0}, "stepping implicit;"
    );
    const auto solver = elasticSolver::make("cpu", mesh, p);
    const double dt = 0.05;
    EXPECT_EQ(solver->subSteps(dt), 1);
    march(*solver, 20, dt);
    const int middle = 2*33 + 16;
    RecordProperty
    (
        "deflection",
        fmt::format("{:.4f}", solver->positions()[middle].y - 0.125)
    );
    RecordProperty("stepping", solver->describe());
    EXPECT_NEAR(solver->positions()[middle].y - 0.125, 0.28, 0.045);
}
