#include "exact/acousticPulse.H"
#include "exact/radialFlow.H"

#include <gtest/gtest.h>

#include <cmath>

using namespace gpuFsi;

namespace
{

radialFlow::constants published(double amplitude, int dimensions = 3)
{
    return {dimensions, 1/std::sqrt(3.0), 1, amplitude, 5};
}

//- Integral over space; the integrand is even in r, so this sum is accurate
double excessMass(const radialFlow& flow)
{
    double sum = 0;
    for (double r = 0.025; r < 20; r += 0.05)
    {
        sum += 4*std::acos(-1.0)*r*r*flow.density(r)*0.05;
    }
    return sum;
}

//- Linear solution of the same pulse
acousticPulse linear(double amplitude, int dimensions)
{
    fluidConstants fluid;
    fluid.dimensions = dimensions;
    fluid.c = 1/std::sqrt(3.0);
    fluid.nu = 1;
    dictionary dict("d");
    dict.set("amplitude", std::to_string(amplitude));
    return acousticPulse(dict, fluid);
}

} // namespace


TEST(radialFlow, ofASmallPulseIsLinearAcoustics)
{
    const double a = 1e-6;
    for (const int dimensions : {2, 3})
    {
        const radialFlow flow(published(a, dimensions), 1.2);
        const acousticPulse exact = linear(a, dimensions);
        for (const double r : {0.0, 0.3, 1.0, 2.5, 6.0, 9.0})
        {
            const std::vector<vector> p{{r, 0, 0}};
            EXPECT_NEAR
            (
                flow.density(r), exact.scalar("deltaRho", p, 1.2)[0], 2e-6*a
            );
            EXPECT_NEAR
            (
                flow.speed(r), exact.vectors("U", p, 1.2)[0].x, 2e-6*a
            );
        }
    }
}


TEST(radialFlow, ofNoViscosityTravels)
{
    auto what = published(1e-6);
    what.nu = 0;
    const radialFlow flow(what, 3);
    // r rho' = (f(r - c t) + f(r + c t))/2, f = x exp(-x^2/5)
    for (const double r : {0.5, 2.0, 4.0})
    {
        const auto f = [](double x) { return x*std::exp(-x*x/5); };
        const double ct = std::sqrt(3.0);
        EXPECT_NEAR
        (
            flow.density(r), 1e-6*(f(r - ct) + f(r + ct))/(2*r), 1e-11
        );
    }
}


TEST(radialFlow, keepsMassAndIsResolved)
{
    for (const int dimensions : {2, 3})
    {
        const auto what = published(0.3, dimensions);
        const radialFlow flow(what, 1.2), fine(what, 1.2, 56);
        if (dimensions == 3)
        {
            EXPECT_NEAR
            (
                excessMass(flow), 0.3*std::pow(5*std::acos(-1.0), 1.5), 1e-8
            );
        }
        for (const double r : {0.0, 0.7, 2.0, 5.0, 8.0})
        {
            EXPECT_NEAR(flow.density(r), fine.density(r), 1e-9);
            EXPECT_NEAR(flow.speed(r), fine.speed(r), 1e-9);
        }
    }
}


TEST(nonlinearPulse, departsFromTheLinearOneAsKnown)
{
    // At amplitude 0.01, t = 1.2, of the largest value: 9.3e-4 at the centre,
    // 5.6e-5 rms over r < 6
    const radialFlow flow(published(0.01), 1.2);
    const acousticPulse exact = linear(0.01, 3);
    double sum = 0, volume = 0;
    for (double r = 0.005; r < 6; r += 0.01)
    {
        const double d = flow.density(r)
          - exact.scalar("deltaRho", {{r, 0, 0}}, 1.2)[0];
        sum += r*r*d*d;
        volume += r*r;
    }
    const double largest = exact.scalar("deltaRho", {{0, 0, 0}}, 1.2)[0];
    EXPECT_NEAR(largest, 0.00846, 1e-5);
    EXPECT_NEAR(std::sqrt(sum/volume)/largest, 5.6e-5, 2e-6);
    EXPECT_NEAR
    (
        std::fabs(flow.density(0) - largest)/largest, 9.3e-4, 2e-5
    );
}


TEST(nonlinearPulse, isChosenByItsWord)
{
    fluidConstants fluid;
    fluid.rho0 = 2;
    fluid.c = 0.5;
    fluid.nu = 0.1;
    dictionary dict("d");
    dict.set("centre", "(1 0 0)");
    const auto exact = exactSolution::make("nonlinearPulse", dict, fluid);
    const radialFlow flow({3, 0.5, 0.1, 0.005, 5}, 0.7);
    const std::vector<vector> p{{1, 2, 0}};
    EXPECT_DOUBLE_EQ(exact->scalar("deltaRho", p, 0.7)[0], 2*flow.density(2));
    EXPECT_DOUBLE_EQ(exact->vectors("U", p, 0.7)[0].y, flow.speed(2));
    dict.set("amplitude", "-3");
    EXPECT_THROW
    (
        exactSolution::make("nonlinearPulse", dict, fluid), userError
    );
}
