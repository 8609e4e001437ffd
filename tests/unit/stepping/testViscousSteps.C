// Super-steps of viscosity: the polynomial of RKL2, the decay of a shear wave
// in the solver by that very polynomial, and stability on displaced particles.

#include "common/fluids.H"
#include "common/lattice.H"
#include "stepping/latticeViscosity.H"
#include "stepping/rkl2.H"

#include <gtest/gtest.h>

#include <cstring>
#include <omp.h>

using namespace gpuFsi;

namespace
{

double legendre(int s, double x)
{
    double before = 1, p = x;
    for (int j = 2; j <= s; ++j)
    {
        const double next = ((2*j - 1)*x*p - (j - 1)*before)/j;
        before = p;
        p = next;
    }
    return p;
}

double b(int s) { return (double(s)*s + s - 2)/(2.0*s*(s + 1)); }

particleSchemes splitSchemes(const domain& d, int exponent = 1)
{
    particleSchemes s = defaultSchemes(d);
    s.areaWeights = particleSchemes::weight::moment;
    s.weightExponent = exponent;
    s.time = particleSchemes::timeScheme::RK2;
    s.superSteps = true;
    return s;
}

//- U sin(k x) along y, or a common velocity where waves is 0
void setShear(hostState& s, const domain& d, double U, int waves)
{
    const double k = 2*M_PI*waves/(d.hi.x - d.lo.x);
    for (std::size_t i = 0; i < s.fluid.size(); ++i)
    {
        const double x = s.fluid.positions[i].x;
        s.fluid.U[i] = {0, waves ? U*std::sin(k*x) : U, 0};
    }
}

//- Amplitude of that wave
double shearOf(const hostState& s, const domain& d, int waves)
{
    const double k = 2*M_PI*waves/(d.hi.x - d.lo.x);
    double sum = 0;
    for (std::size_t i = 0; i < s.fluid.size(); ++i)
    {
        sum += s.fluid.U[i].y*std::sin(k*s.fluid.positions[i].x);
    }
    return 2*sum/double(s.fluid.size());
}

void march(fluidSolver& solver, double dt, int steps)
{
    for (int n = 0; n < steps; ++n)
    {
        solver.step(n*dt, dt);
        if (solver.maintenanceDue())
        {
            solver.maintain();
        }
    }
    solver.monitor();
}

//- Of the Laplacian of a lattice for a wave along x, 1/h^2
double symbol(int dimensions, int exponent, double kh)
{
    double sum = 0, second = 0;
    const int deep = dimensions == 3 ? 1 : 0;
    for (int i = -1; i <= 1; ++i)
    for (int j = -1; j <= 1; ++j)
    for (int l = -deep; l <= deep; ++l)
    {
        const int square = i*i + j*j + l*l;
        if (square > 0)
        {
            const double B = std::pow(square, -0.5*(exponent + 1));
            sum += B*(1 - std::cos(i*kh));
            second += B*square;
        }
    }
    return 2*dimensions*sum/second;
}

} // namespace


TEST(rkl2, isItsLegendrePolynomial)
{
    for (int s : {3, 5, 9, 21, 101})
    {
        const double most = 2*rkl2::reach(s);
        for (int m = 0; m <= 200; ++m)
        {
            const double z = -most*m/200;
            const double wanted =
                1 - b(s) + b(s)*legendre(s, 1 + z/rkl2::reach(s));
            EXPECT_NEAR(rkl2::factor(s, z), wanted, 1e-10) << s << " " << z;
            EXPECT_LE(std::abs(rkl2::factor(s, z)), 1 + 1e-12);
        }
        EXPECT_GT(std::abs(rkl2::factor(s, -1.5*most)), 1);

        // Second order: the third coefficient is not that of exp
        const double z = -1e-2;
        const double error = rkl2::factor(s, z) - std::exp(z);
        EXPECT_LT(std::abs(error), 0.17*std::abs(z*z*z));
    }
}


TEST(rkl2, stagesAreOddAndReach)
{
    EXPECT_EQ(rkl2::stagesFor(0.01), 3);
    for (double steps : {1.0, 2.5, 2.6, 7.0, 100.0, 12345.0})
    {
        const int s = rkl2::stagesFor(steps);
        EXPECT_EQ(s % 2, 1);
        EXPECT_GE(rkl2::reach(s), steps);
        EXPECT_TRUE(s == 3 || rkl2::reach(s - 2) < steps);
    }
    EXPECT_EQ(rkl2::stagesFor(1e9), rkl2::mostStages);
}


TEST(rkl2, latticeIsThatOfTheSymbol)
{
    EXPECT_NEAR(latticeViscosity::of(2, 1).limit(), 0.5, 1e-12);
    EXPECT_NEAR(latticeViscosity::of(2, 3).limit(), 0.375, 1e-12);
    EXPECT_NEAR(latticeViscosity::of(3, 1).limit(), 0.5, 1e-12);
    EXPECT_NEAR
    (
        latticeViscosity::of(3, 1).fastest, symbol(3, 1, M_PI), 1e-12
    );
}


//- The lattice hardly moves: what the solver makes of the wave is known to
//  round-off
TEST(viscousSteps, waveDecaysByThePolynomial)
{
    for (int dimensions : {2, 3})
    for (int exponent : {1, 3})
    for (double number : {0.1, 1.0, 10.0, 100.0})
    {
        const domain d = periodicBox(12, dimensions, 12);
        fluidProperties fluid = publishedFluid(1);
        fluid.c = 0.2/number;
        hostState s = latticeState(d, 0, 1);
        constexpr double U = 1e-12;
        constexpr int steps = 3;
        setShear(s, d, U, 1);
        const auto solver = fluidSolver::make
        (
            "cpu", "double", d, fluid, splitSchemes(d, exponent), s
        );
        march(*solver, number, steps);
        const double z =
            -0.5*number*symbol(dimensions, exponent, 2*M_PI/12);
        const double wanted = std::pow
        (
            rkl2::factor(solver->viscousStages(number), z), 2*steps
        );
        EXPECT_NEAR(shearOf(solver->download(), d, 1)/U, wanted, 1e-10)
            << dimensions << " " << exponent << " " << number;
    }
}


TEST(viscousSteps, leaveACommonVelocityAlone)
{
    const domain d = periodicBox(10, 2, 10);
    const fluidProperties fluid = publishedFluid(50);
    for (const char* precision : {"single", "double"})
    {
        hostState s = latticeState(d, 0, 1, 0.2);
        setShear(s, d, 0.7, 0);
        const auto solver = fluidSolver::make
        (
            "cpu", precision, d, fluid, splitSchemes(d), s
        );
        const hostState before = solver->download();
        march(*solver, 1, 5);
        const hostState after = solver->download();
        for (std::size_t i = 0; i < s.fluid.size(); ++i)
        {
            EXPECT_EQ(after.fluid.U[i].y, before.fluid.U[i].y);
        }
    }
}


//- Noise never grows, also where particles are far from a lattice
TEST(viscousSteps, displacedParticlesAreStable)
{
    for (int dimensions : {2, 3})
    for (double displace : {0.2, 0.4})
    for (double number : {1.0, 10.0, 100.0})
    {
        const int side = dimensions == 3 ? 10 : 24;
        const domain d = periodicBox(side, dimensions, side);
        fluidProperties fluid = publishedFluid(1);
        fluid.c = 1e-3/number;
        hostState s = latticeState(d, 0, 1, displace);
        double before = 0;
        for (std::size_t i = 0; i < s.fluid.size(); ++i)
        {
            s.fluid.U[i] = {1e-8*hashed(2*i), 1e-8*hashed(2*i + 1), 0};
            before = std::max(before, std::abs(s.fluid.U[i].x));
        }
        const auto solver = fluidSolver::make
        (
            "cpu", "double", d, fluid, splitSchemes(d), s
        );
        march(*solver, number, 100);
        EXPECT_LT(solver->monitor().maxSpeed, 2*before)
            << dimensions << " " << displace << " " << number;
    }
}


TEST(viscousSteps, sameBytesOnAnyThreadCount)
{
    const domain d = periodicBox(80, 2, 80);
    const fluidProperties fluid = publishedFluid(5);
    std::vector<particleSet> found;
    const int before = omp_get_max_threads();
    for (int threads : {1, 3})
    {
        omp_set_num_threads(threads);
        hostState s = latticeState(d, 0.01, 20, 0.2);
        setShear(s, d, 0.01, 2);
        const auto solver = fluidSolver::make
        (
            "cpu", "single", d, fluid, splitSchemes(d), s
        );
        march(*solver, 0.5, 30);
        found.push_back(solver->download().fluid);
    }
    omp_set_num_threads(before);
    EXPECT_EQ
    (
        0, std::memcmp
        (
            found[0].U.data(), found[1].U.data(),
            found[0].size()*sizeof(vector)
        )
    );
}
