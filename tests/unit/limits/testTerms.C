// The limits of a case by term.

#include "common/fluids.H"
#include "common/lattice.H"
#include "limits/couplingLimit.H"
#include "limits/termLimits.H"

#include <gtest/gtest.h>

#include <complex>

using namespace gpuFsi;

namespace
{

particleSchemes schemes()
{
    particleSchemes s = defaultSchemes(periodicBox(8, 2, 8));
    s.areaWeights = particleSchemes::weight::moment;
    s.time = particleSchemes::timeScheme::symplecticEuler;
    return s;
}

caseScales still()
{
    caseScales s;
    s.flow = {2, 0.1, 10, 0};
    return s;
}

//- The greater of the roots of z^2 + b z + c
double greatestRoot(double b, double c)
{
    const std::complex<double> root =
        std::sqrt(std::complex<double>(b*b - 4*c));
    return std::max(std::abs(-b + root), std::abs(-b - root))/2;
}

} // namespace


TEST(terms, shortestIsNamed)
{
    const auto least = [](const caseScales& s)
    {
        return std::string(shortest(termLimits(schemes(), s)).term);
    };
    caseScales s = still();
    EXPECT_EQ(least(s), "acoustic");
    s.flow.c = 1e-3;
    s.flow.nu = 1;
    EXPECT_EQ(least(s), "viscous");
    s = still();
    s.relativeSpeed = 1000;
    EXPECT_EQ(least(s), "convective");
    s = still();
    s.force = 1e6;
    EXPECT_EQ(least(s), "bodyForce");
    s = still();
    s.solid.omegaMax = 1e4;
    EXPECT_EQ(least(s), "acoustic");    // sub-steps follow
    s.solid.subSteps = 3;
    EXPECT_EQ(least(s), "spring");
    s = still();
    s.solid.massPerArea = 1e-5;
    EXPECT_EQ(least(s), "coupling");
    s.flow.nu = 1e-2;
    EXPECT_EQ(least(s), "viscousCoupling");
}


TEST(terms, exceededAgreesWithThem)
{
    caseScales s = still();
    s.relativeSpeed = 1;
    s.flow.nu = 0.01;
    const termLimit least = shortest(termLimits(schemes(), s));
    EXPECT_FALSE(exceeded(schemes(), s, 0.999*least.deltaT));
    const auto beyond = exceeded(schemes(), s, 1.01*least.deltaT);
    ASSERT_TRUE(beyond);
    EXPECT_STREQ(beyond->term, least.term);
    EXPECT_NEAR(beyond->deltaT, least.deltaT, 1e-6*least.deltaT);
}


TEST(terms, implicitSolidsHaveNone)
{
    caseScales s;
    s.flow.c = 0;
    s.solid.omegaMax = 100;
    s.solid.subSteps = 2;
    s.solid.implicitBeyond = 10;
    EXPECT_FALSE(exceeded(schemes(), s, 0.039));
    EXPECT_TRUE(exceeded(schemes(), s, 0.041));
    EXPECT_FALSE(exceeded(schemes(), s, 11));
}


TEST(terms, plainOnes)
{
    EXPECT_DOUBLE_EQ(convectiveLimit(0.1, 5), 0.02);
    EXPECT_DOUBLE_EQ(bodyForceLimit(0.4, 10), 0.2);
    EXPECT_DOUBLE_EQ(springLimit(100, 3), 0.06);
    EXPECT_EQ(convectiveLimit(0.1, 0), HUGE_VAL);
    EXPECT_EQ(bodyForceLimit(0.1, 0), HUGE_VAL);
    EXPECT_EQ(springLimit(0), HUGE_VAL);
}


//- Between kappa = 1 of a particle without mass and 2 of a heavy one
TEST(terms, viscousCoupling)
{
    const double h = 0.2, mu = 5, rho = 3;
    const auto kappa = [&](double mass)
    {
        return viscousCouplingLimit(h, mu, rho, mass)*mu/(0.5*h*mass);
    };
    EXPECT_NEAR(kappa(1e-6), 1, 1e-4);
    EXPECT_NEAR(kappa(0.5*h*rho), 1.5, 1e-12);
    EXPECT_NEAR(kappa(1e6), 2, 1e-4);
}


//- Where a root of the polynomial leaves the unit circle
TEST(terms, couplingIsThatOfItsPolynomial)
{
    const double h = 0.2, c = 7, rho = 3, d = 0.5*h;
    for (const double x : {0.001, 0.05, 1.0, 20.0})
    {
        const double dt = couplingLimit(h, c, rho, rho*x);
        const double mu = d/(x + d);
        const auto grows = [&](double step)
        {
            const double kappa = step*step*c*c/(x*2*h);
            return greatestRoot(kappa - 2, 1 - kappa*mu) > 1 + 1e-12;
        };
        EXPECT_FALSE(grows(0.999*dt)) << x;
        EXPECT_TRUE(grows(1.001*dt)) << x;
    }
}
