#include "exact/acousticPulse.H"

#include <gtest/gtest.h>

#include <cmath>

using namespace gpuFsi;

namespace
{

constexpr double pi = 3.14159265358979323846;

fluidConstants fluidOf(double nu, int dimensions = 3)
{
    fluidConstants fluid;
    fluid.dimensions = dimensions;
    fluid.c = 1/std::sqrt(3.0);
    fluid.nu = nu;
    return fluid;
}

//- The published integral by brute force: a very fine trapezoidal sum with
//  complex roots, so that no branch is chosen by hand
double bruteForce(double r, double t, double nu)
{
    const double c = 1/std::sqrt(3.0);
    const int n = 20000;
    const double kMax = 8;
    long double sum = 0;
    for (int i = 1; i < n; ++i)
    {
        const double k = kMax*(i + 0.5)/n;
        const double gamma = nu*k*k/2;
        const double square = c*c*k*k - gamma*gamma;
        const double w = std::sqrt(std::abs(square));
        const double f = square > 0
            ? std::cos(w*t) + gamma*std::sin(w*t)/w
            : std::cosh(w*t) + gamma*std::sinh(w*t)/w;
        const double transform =
            0.01*std::pow(5*pi, 1.5)*std::exp(-5*k*k/4);
        const double kernel = r > 0 ? k*std::sin(k*r)/r : k*k;
        sum += kernel*transform*f*std::exp(-gamma*t);
    }
    return double(sum*kMax/n/(2*pi*pi));
}

std::vector<vector> onAxis(int n, double step)
{
    std::vector<vector> points;
    for (int i = 0; i < n; ++i)
    {
        points.push_back({0, i*step, 0});
    }
    return points;
}

} // namespace


TEST(acousticPulse, startsAsTheGivenPulseAtRest)
{
    const acousticPulse pulse(dictionary("d"), fluidOf(1));
    // Many points: the interpolated table
    const auto points = onAxis(6001, 0.001);
    const auto rho = pulse.scalar("deltaRho", points, 0);
    const auto U = pulse.vectors("U", points, 0);
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        const double r = points[i].y;
        EXPECT_NEAR(rho[i], 0.01*std::exp(-r*r/5), 1e-12) << r;
        EXPECT_NEAR(U[i].y, 0, 1e-14);
    }
}


TEST(acousticPulse, equalsBruteForceInBothBranches)
{
    for (double nu : {0.0, 0.05, 1.0, 4.0})
    {
        const acousticPulse pulse(dictionary("d"), fluidOf(nu));
        const auto points = onAxis(5001, 0.002);
        for (double t : {0.2, 1.2, 5.0})
        {
            const auto rho = pulse.scalar("deltaRho", points, t);
            for (std::size_t i = 0; i < points.size(); i += 500)
            {
                const double exact = bruteForce(points[i].y, t, nu);
                EXPECT_NEAR(rho[i], exact, 1e-12)
                    << "nu " << nu << " t " << t << " r " << points[i].y;
            }
        }
    }
}


TEST(acousticPulse, inviscidPulseIsTwoTravellingWaves)
{
    // r rho' obeys the one-dimensional wave equation
    const acousticPulse pulse(dictionary("d"), fluidOf(0));
    const double c = 1/std::sqrt(3.0);
    for (double t : {0.5, 3.0, 8.0})
    {
        for (double r : {0.3, 1.7, 4.1})
        {
            const auto half = [&](double s)
            {
                return 0.005*s*std::exp(-s*s/5);
            };
            const double exact = (half(r + c*t) + half(r - c*t))/r;
            const auto rho =
                pulse.scalar("deltaRho", {{0, 0, r}}, t);
            EXPECT_NEAR(rho[0], exact, 1e-15);
        }
    }
}


TEST(acousticPulse, obeysMassAndMomentumInTwoAndThreeDimensions)
{
    for (int D : {2, 3})
    {
        const double nu = 0.7;
        const fluidConstants fluid = fluidOf(nu, D);
        const dictionary dict = dictionary::fromString
        (
            "centre (1 2 0); amplitude 0.02; width 3; rho0 1.5;"
        );
        const acousticPulse pulse(dict, fluid);
        const double t = 0.9;
        const double e = 1e-3;
        const vector p{1.8, 2.9, D == 3 ? 0.4 : 0.0};
        const auto rho = [&](const vector& at, double time)
        {
            return pulse.scalar("deltaRho", {at}, time)[0];
        };
        const auto U = [&](const vector& at, double time)
        {
            return pulse.vectors("U", {at}, time)[0];
        };
        const vector dx{e, 0, 0}, dy{0, e, 0}, dz{0, 0, D == 3 ? e : 0};
        const double divergence =
            (U(p + dx, t).x - U(p - dx, t).x + U(p + dy, t).y
           - U(p - dy, t).y + U(p + dz, t).z - U(p - dz, t).z)/(2*e);
        const double rate = (rho(p, t + e) - rho(p, t - e))/(2*e);
        EXPECT_NEAR(rate, -1.5*divergence, 1e-8) << D;

        const double acceleration = (U(p, t + e).x - U(p, t - e).x)/(2*e);
        const double gradient = (rho(p + dx, t) - rho(p - dx, t))/(2*e);
        double laplacian = -(D == 3 ? 6 : 4)*U(p, t).x;
        for (const vector& d : {dx, dy, dz})
        {
            if (dot(d, d) > 0)
            {
                laplacian += U(p + d, t).x + U(p - d, t).x;
            }
        }
        laplacian /= e*e;
        EXPECT_NEAR
        (
            acceleration,
            -fluid.c*fluid.c/1.5*gradient + nu*laplacian,
            1e-7
        ) << D;
    }
}


TEST(acousticPulse, zeroWidthIsAnError)
{
    const dictionary dict = dictionary::fromString("width 0;");
    EXPECT_THROW(acousticPulse(dict, fluidOf(1)), userError);
}
