#include "exact/exactSolution.H"

#include <gtest/gtest.h>

#include <cmath>

using namespace gpuFsi;

namespace
{

std::unique_ptr<exactSolution> make
(
    const std::string& word,
    const dictionary& dict,
    int dimensions
)
{
    fluidConstants fluid;
    fluid.dimensions = dimensions;
    fluid.rho0 = 1.5;
    fluid.c = 9;
    fluid.nu = 0.03;
    return exactSolution::make(word, dict, fluid);
}

//- Residuals of the incompressible equations by central differences of the
//  solution itself; all must vanish
struct residuals
{
    double divergence;
    vector momentum;

    residuals(const exactSolution& s, const vector& p, double t)
    {
        const double e = 1e-3;
        const vector step[3] = {{e, 0, 0}, {0, e, 0}, {0, 0, e}};
        const auto U = [&](const vector& at, double time)
        {
            return s.vectors("U", {at}, time)[0];
        };
        const auto pressure = [&](const vector& at)
        {
            // P/rho0 = c^2 deltaRho/rho0
            return 81/1.5*s.scalar("deltaRho", {at}, t)[0];
        };
        const auto part = [](const vector& v, int a)
        {
            return a == 0 ? v.x : a == 1 ? v.y : v.z;
        };
        const vector here = U(p, t);
        divergence = 0;
        momentum = (0.5/e)*(U(p, t + e) - U(p, t - e));
        for (int a = 0; a < 3; ++a)
        {
            const vector ahead = U(p + step[a], t);
            const vector behind = U(p - step[a], t);
            const double slope =
                (pressure(p + step[a]) - pressure(p - step[a]))/(2*e);
            divergence += (part(ahead, a) - part(behind, a))/(2*e);
            momentum += (part(here, a)/(2*e))*(ahead - behind);
            momentum += (-0.03/e/e)*(ahead + behind - 2.0*here);
            momentum += (slope/e)*step[a];
        }
    }
};

void expectSolves(const exactSolution& s)
{
    for (double t : {0.0, 0.7})
    {
        for (const vector& p :
            {vector{0.1, 0.2, 0.3}, vector{1.3, -0.4, 0.9}, vector{2, 1, 5}})
        {
            const residuals r(s, p, t);
            EXPECT_NEAR(r.divergence, 0, 1e-9);
            EXPECT_NEAR(r.momentum.x, 0, 2e-4) << p.x << " " << t;
            EXPECT_NEAR(r.momentum.y, 0, 2e-4) << p.x << " " << t;
            EXPECT_NEAR(r.momentum.z, 0, 2e-4) << p.x << " " << t;
        }
    }
}

} // namespace


TEST(taylorGreen, solvesTheEquationsAndIsAsStated)
{
    const dictionary dict = dictionary::fromString
    (
        "length 2; speed 1.2; origin (0.3 0.1 0);"
    );
    const auto s = make("taylorGreen", dict, 2);
    expectSolves(*s);

    // At a quarter of a period along x: the whole speed, along x
    const double k = std::acos(-1.0);
    const vector U = s->vectors("U", {{0.8, 0.1, 0}}, 0.5)[0];
    EXPECT_NEAR(U.x, 1.2*std::exp(-2*0.03*k*k*0.5), 1e-14);
    EXPECT_NEAR(U.y, 0, 1e-14);
    EXPECT_NEAR
    (
        s->scalar("deltaRho", {{0.3, 0.1, 0}}, 0)[0],
        1.5*1.44/2/81,
        1e-15
    );
}


TEST(ABC, solvesTheEquationsAndDecaysAsAWhole)
{
    const dictionary dict = dictionary::fromString
    (
        "length 3; A 1; B 0.5; C 0.25; origin (0.3 0.1 0.7);"
    );
    const auto s = make("ABC", dict, 3);
    expectSolves(*s);

    const double k = 2*std::acos(-1.0)/3;
    const std::vector<vector> points{{0.3, 0.1, 0.7}, {1, 2, 3}};
    const auto first = s->vectors("U", points, 0);
    const auto later = s->vectors("U", points, 2);
    EXPECT_NEAR(first[0].x, 0.25, 1e-15);
    EXPECT_NEAR(first[0].y, 1, 1e-15);
    EXPECT_NEAR(first[0].z, 0.5, 1e-15);
    for (int i = 0; i < 2; ++i)
    {
        EXPECT_NEAR(later[i].y, first[i].y*std::exp(-0.03*k*k*2), 1e-14);
    }
}


TEST(ABC, hasUnitRmsSpeedAndZeroMeanDensityByDefault)
{
    const auto s = make("ABC", dictionary("d"), 3);
    std::vector<vector> points;
    const int n = 8;
    for (int i = 0; i < n*n*n; ++i)
    {
        points.push_back
        ({
            double(i % n)/n, double(i/n % n)/n, double(i/n/n)/n
        });
    }
    double square = 0, density = 0;
    for (const vector& U : s->vectors("U", points, 0))
    {
        square += dot(U, U);
    }
    for (double deltaRho : s->scalar("deltaRho", points, 0))
    {
        density += deltaRho;
    }
    EXPECT_NEAR(square/points.size(), 1, 1e-13);
    EXPECT_NEAR(density/points.size(), 0, 1e-15);
}


//- U_t = nu U_xx, from the values at (0.1 0.2 0), and no other component
TEST(periodicFlow, shearWaveSolvesTheHeatEquation)
{
    const dictionary dict = dictionary::fromString
    (
        "length 2; speed 0.7; origin (0.3 0 0);", "test"
    );
    const auto s = make("shearWave", dict, 2);
    EXPECT_TRUE(s->has("U"));
    EXPECT_FALSE(s->has("deltaRho"));
    const auto U = [&](double x, double t)
    {
        return s->vectors("U", {{x, 0.2, 0}}, t)[0];
    };
    const double e = 1e-3, x = 0.1, t = 0.4;
    const double rate = (U(x, t + e).y - U(x, t - e).y)/(2*e);
    const double curve =
        (U(x + e, t).y - 2*U(x, t).y + U(x - e, t).y)/(e*e);
    EXPECT_NEAR(rate, 0.03*curve, 1e-6);
    EXPECT_NEAR(U(0.8, 0).y, 0.7, 1e-14);
    EXPECT_EQ(U(x, t).x, 0);
    EXPECT_EQ(U(x, t).z, 0);
}
