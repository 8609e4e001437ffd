// The surface's acceleration that carries the fluid's density: stable whatever
// the masses, and what both masses together take.

#include "coupling/wallAcceleration.H"
#include "solid/springNetwork.H"

#include <gtest/gtest.h>

using namespace gpuFsi;

namespace
{

//- A free particle of mass 1 under a steady force of 1, pushed back by the
//  mass beside with the acceleration of the step before
double velocityAfter(int steps, double beside)
{
    const double dt = 0.01, mass = 1;
    vector u{0, 0, 0}, before, a{0, 0, 0};
    for (int k = 0; k < steps; ++k)
    {
        before = u;
        u.x += dt*(1 - beside*a.x)/mass;
        wallAcceleration{&u, &before, &mass, &beside, &a, 1/dt}(0);
        EXPECT_NEAR(a.x, 1/(mass + beside), 1e-10) << "step " << k;
    }
    return u.x;
}

} // namespace


TEST(wallAcceleration, isThatOfBothMassesAtOnce)
{
    for (double beside : {0.0, 0.1, 1.0, 10.0, 100.0})
    {
        // The first step does not know the mass beside yet
        const double late = 0.01 - 0.01/(1 + beside);
        EXPECT_NEAR
        (
            velocityAfter(200, beside), 2/(1 + beside) + late, 1e-10
        ) << beside;
    }
}


TEST(wallAcceleration, ofDrivenParticlesIsTheirOwn)
{
    const double dt = 0.1, mass = HUGE_VAL, beside = 5;
    const vector u{0.3, 0, -0.2}, before{0.1, 0, 0};
    vector a{7, 7, 7};
    wallAcceleration{&u, &before, &mass, &beside, &a, 1/dt}(0);
    EXPECT_NEAR(a.x, 2, 1e-12);
    EXPECT_NEAR(a.y, 0, 1e-12);
    EXPECT_NEAR(a.z, -2, 1e-12);
}


//- A block of two cells of 0.5 m, one of whose ends is held
TEST(wallAcceleration, massesAreSharesOfCells)
{
    solidMesh mesh;
    mesh.dimensions = 2;
    mesh.points =
    {
        {0, 0, 0}, {0.5, 0, 0}, {1, 0, 0},
        {0, 0.5, 0}, {0.5, 0.5, 0}, {1, 0.5, 0}
    };
    mesh.solid.assign(6, 0);
    mesh.part = {0, -1, -1, 0, -1, -1};
    mesh.names = {"block"};
    mesh.parts = {{0, "end"}};
    mesh.cells = {{0, 1, 3, 4, -1, -1, -1, -1}, {1, 2, 4, 5, -1, -1, -1, -1}};
    solidProperties properties;
    properties.materials.resize(1);
    properties.materials[0].rho = 8;
    properties.parts.resize(1);
    properties.parts[0].kind = solidPart::type::fixed;
    const std::vector<double> mass = yieldingMasses
    (
        mesh, properties, springNetwork::of(mesh, properties).mass
    );
    EXPECT_EQ
    (
        mass, (std::vector<double>{HUGE_VAL, 1, 0.5, HUGE_VAL, 1, 0.5})
    );
}
