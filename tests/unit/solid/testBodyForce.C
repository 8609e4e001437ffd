// A free solid under a body force that varies with time falls as a point does.

#include "blocks.H"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <unistd.h>

using namespace gpuFsi;

namespace
{

bodyForce swinging(const std::string& value)
{
    namespace fs = std::filesystem;
    const fs::path casePath = fs::temp_directory_path()
        /("solidForce" + std::to_string(getpid()));
    fs::create_directories(casePath/"constant");
    std::ofstream(casePath/"constant"/"g") << "value " << value << ";";
    const bodyForce g = bodyForce::read(casePath);
    fs::remove_all(casePath);
    return g;
}

} // namespace


TEST(bodyForce, swingsAFreeSolid)
{
    const solidMesh mesh = block(3, 2, 2, 2, 0.5);
    const bodyForce g = swinging("(\"0.3*cos(2*t)\" 0 -0.1)");
    for (const char* stepping : {"explicit", "implicit"})
    {
        solidProperties p = material
        (
            mesh, "E 1; nu 0.25;", {},
            std::string("subSteps 4; stepping ") + stepping + ";"
        );
        p.g = g;
        const auto solver = elasticSolver::make("cpu", mesh, p);
        march(*solver, 10, 0.2);
        const hostSolid s = solver->download();
        const double error = 0.05*0.05*4/12;    // of second order, relative
        for (std::size_t i = 0; i < mesh.size(); ++i)
        {
            const vector moved = s.positions[i] - mesh.points[i];
            EXPECT_NEAR(s.U[i].x, 0.15*std::sin(4.0), 0.15*error);
            EXPECT_NEAR(moved.x, 0.075*(1 - std::cos(4.0)), 0.15*error);
            EXPECT_NEAR(s.U[i].z, -0.2, 1e-12);
        }

        // No potential: what it gained is what the ledger has as work
        const solidEnergies e = solver->energies();
        EXPECT_GT(e.kinetic, 0.01);
        EXPECT_NEAR(e.gravity, e.kinetic + e.elastic, 1e-9);
    }
}


TEST(bodyForce, staysInThePlaneOfAPlaneSolid)
{
    const solidMesh mesh = block(2, 2, 2, 0, 1);
    const dictionary dict = dictionary::fromString("bar { rho 1; E 1; }");
    EXPECT_THROW
    (
        solidProperties::read(dict, swinging("(0 0 \"sin(t)\")"), mesh),
        userError
    );
    EXPECT_NO_THROW
    (
        solidProperties::read(dict, swinging("(0 \"sin(t)\" \"0\")"), mesh)
    );
}
