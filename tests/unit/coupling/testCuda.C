// Fluid and solid on a GPU against the CPU.

#include "barColumn.H"
#include "common/needsGpu.H"

using namespace gpuFsi;

namespace
{

hostState run(const barColumn& s, const char* backend, const char* precision)
{
    const auto solver = s.solver(backend, precision);
    const double dt = 0.01;
    for (int k = 0; k < 60; ++k)
    {
        solver->step(k*dt, dt);
        if (solver->maintenanceDue())
        {
            solver->maintain();
        }
    }
    return solver->download();
}

double difference(const std::vector<vector>& a, const std::vector<vector>& b)
{
    double worst = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
    {
        const vector d = a[i] - b[i];
        worst = std::max(worst, std::sqrt(dot(d, d)));
    }
    return worst;
}

class cudaCoupling
:
    public testing::Test
{
public:

    void SetUp() override
    {
        NEEDS_GPU;
        scene.fluid = publishedFluid(0.01);
        for (std::size_t i = 0; i < scene.state.fluid.size(); ++i)
        {
            const vector& x = scene.state.fluid.positions[i];
            scene.state.fluid.U[i] = {0.1*x.x, 0.02*std::sin(6*x.x), 0};
        }
    }

    barColumn scene;
};

} // namespace


TEST_F(cudaCoupling, agreesWithTheCpu)
{
    using law = couplingProperties::law;
    for (const double dissipation : {0.0, 0.2})
    {
        for (const law force : {law::surface, law::reaction})
        {
            scene.schemes.dissipation = dissipation;
            scene.solids.coupling.force = force;
            const hostState a = run(scene, "cpu", "double");
            const hostState b = run(scene, "cuda", "double");
            EXPECT_LT(difference(a.solid.positions, b.solid.positions), 1e-12);
            EXPECT_LT(difference(a.solid.U, b.solid.U), 1e-12);
            EXPECT_LT(difference(a.fluid.U, b.fluid.U), 1e-11);
        }
    }
}


TEST_F(cudaCoupling, booksTheSameWorks)
{
    scene.schemes.dissipation = 0.2;
    scene.schemes.shifting = 0.5;
    const auto works = [&](const char* backend)
    {
        const auto solver = scene.solver(backend, "double");
        solver->keepLedger();
        for (int k = 0; k < 20; ++k)
        {
            solver->step(0.01*k, 0.01);
        }
        return solver->download().works;
    };
    const fluidWorks a = works("cpu"), b = works("cuda");
    const auto expectNear = [](double x, double y)
    {
        EXPECT_NEAR(x, y, 1e-10*std::abs(x));
    };
    expectNear(a.boundary, b.boundary);
    expectNear(a.viscousLoss, b.viscousLoss);
    expectNear(a.momentumLoss, b.momentumLoss);
    expectNear(a.densityLoss, b.densityLoss);
    expectNear(a.shifting, b.shifting);
    expectNear(a.couplingLag, b.couplingLag);
    expectNear(a.faceForce.x, b.faceForce.x);
}


TEST_F(cudaCoupling, twoRunsAreTheSameBytes)
{
    for (const char* precision : {"single", "double"})
    {
        const hostState a = run(scene, "cuda", precision);
        const hostState b = run(scene, "cuda", precision);
        EXPECT_EQ(difference(a.solid.positions, b.solid.positions), 0);
        EXPECT_EQ(difference(a.fluid.positions, b.fluid.positions), 0);
        EXPECT_EQ(a.fluid.deltaRho, b.fluid.deltaRho);
    }
}
