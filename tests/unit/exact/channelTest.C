#include "exact/exactSolution.H"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

using namespace gpuFsi;

namespace
{

struct made
{
    dictionary dict;
    std::unique_ptr<exactSolution> solution;

    made(const std::string& word, const std::string& text, double nu)
    :
        dict(dictionary::fromString(text))
    {
        fluidConstants fluid;
        fluid.nu = nu;
        solution = exactSolution::make(word, dict, fluid);
    }

    vector U(const vector& p, double t) const
    {
        return solution->vectors("U", {p}, t)[0];
    }
};

std::function<double(double)> steady(double G)
{
    return [G](double) { return G; };
}

//- Crank-Nicolson of u_t = G(t) + nu (u_ss + k/s u_s), u(L) = wall; k 0: u(0) = 0,
//  k 1 (a pipe, s the radius): symmetric at s = 0. Values at s_i = i L/n.
std::vector<double> diffusion
(
    int n, double L, double nu, const std::function<double(double)>& G,
    double wall, int k, double T
)
{
    const double h = L/n;
    const int steps = 4000;
    const double r = nu*T/steps/(h*h)/2;
    std::vector<double> u(n + 1, 0), b(n + 1);
    std::vector<double> low(n + 1), mid(n + 1), up(n + 1);
    u[n] = wall;
    for (int step = 0; step < steps; ++step)
    {
        for (int i = 0; i <= n; ++i)
        {
            double lower = 0, upper = 0;
            if (i > 0 && i < n)
            {
                lower = k ? 1 - 0.5/i : 1;
                upper = k ? 1 + 0.5/i : 1;
            }
            else if (i == 0 && k)
            {
                upper = 4;    // 2 u_ss at the axis
            }
            const bool fixed = i == n || (i == 0 && !k);
            const double left = i > 0 ? u[i - 1] : 0;
            const double right = i < n ? u[i + 1] : 0;
            low[i] = -r*lower;
            up[i] = -r*upper;
            mid[i] = 1 + r*(lower + upper);
            b[i] = fixed ? u[i]
                : u[i] + G((step + 0.5)*T/steps)*T/steps
                  + r*(lower*(left - u[i]) + upper*(right - u[i]));
        }
        for (int i = 1; i <= n; ++i)
        {
            const double f = low[i]/mid[i - 1];
            mid[i] -= f*up[i - 1];
            b[i] -= f*b[i - 1];
        }
        for (int i = n; i >= 0; --i)
        {
            u[i] = (b[i] - (i < n ? up[i]*u[i + 1] : 0))/mid[i];
        }
    }
    return u;
}

} // namespace


TEST(poiseuille, equalsFiniteDifferences)
{
    const made flow
    (
        "poiseuille",
        "length 2; origin (0 1 0); direction (0 1 0); g (0.7 -9 0);",
        0.3
    );
    for (double t : {0.2, 1.5, 20.0})
    {
        const auto u = diffusion(200, 2, 0.3, steady(0.7), 0, 0, t);
        for (int i = 0; i <= 200; i += 20)
        {
            const vector U = flow.U({5, 1 + i*0.01, 3}, t);
            EXPECT_NEAR(U.x, u[i], 2e-5) << t << " " << i;
            EXPECT_EQ(U.y, 0);
        }
    }
    EXPECT_EQ(flow.U({0, 2, 0}, 0).x, 0);
    EXPECT_NEAR(flow.U({0, 2, 0}, 1e3).x, 0.7*4/(8*0.3), 1e-12);
    EXPECT_FALSE(flow.solution->has("deltaRho"));
}


TEST(womersley, equalsFiniteDifferences)
{
    const made flow
    (
        "womersley",
        "length 2; origin (0 1 0); direction (0 1 0); g (0.7 -9 0);"
        " omega 3; phase 0.4;",
        0.1
    );
    const auto G = [](double t) { return 0.7*std::cos(3*t + 0.4); };
    for (double t : {0.05, 0.9, 7.0})
    {
        const auto u = diffusion(200, 2, 0.1, G, 0, 0, t);
        for (int i = 0; i <= 200; i += 20)
        {
            const vector U = flow.U({5, 1 + i*0.01, 3}, t);
            EXPECT_NEAR(U.x, u[i], 3e-5) << t << " " << i;
            EXPECT_EQ(U.y, 0);
        }
    }
    EXPECT_EQ(flow.U({0, 2, 0}, 0).x, 0);

    // A whole swing later, once settled, and slow: Poiseuille's
    EXPECT_NEAR
    (
        flow.U({0, 1.7, 0}, 200).x,
        flow.U({0, 1.7, 0}, 200 + 2*3.14159265358979324/3).x, 1e-12
    );
    const made slow
    (
        "womersley", "length 2; direction (0 1 0); g (0.7 0 0); omega 1e-6;",
        0.3
    );
    EXPECT_NEAR(slow.U({0, 1, 0}, 100).x, 0.7*4/(8*0.3), 1e-5);
    EXPECT_THROW
    (
        made("womersley", "length 2; g (1 0 0); omega 0;", 0.3), userError
    );
}


TEST(steadySolutions, refuseAForceThatVaries)
{
    fluidConstants fluid;
    fluid.nu = 1;
    fluid.forceVaries = true;
    for (const char* word : {"poiseuille", "hagenPoiseuille", "hydrostatic"})
    {
        const auto make = [&](const std::string& more)
        {
            return exactSolution::make
            (
                word, dictionary::fromString("length 1; radius 1; " + more),
                fluid
            );
        };
        EXPECT_THROW(make(""), userError) << word;
        EXPECT_NO_THROW(make("g (1 0 0);")) << word;
    }
}


TEST(couette, equalsFiniteDifferences)
{
    const made flow
    (
        "couette", "length 2; direction (0 1 0); velocity (0 0 3);", 0.3
    );
    for (double t : {0.3, 1.5, 30.0})
    {
        const auto u = diffusion(400, 2, 0.3, steady(0), 3, 0, t);
        for (int i = 0; i <= 400; i += 40)
        {
            EXPECT_NEAR(flow.U({5, i*0.005, 3}, t).z, u[i], 2e-4)
                << t << " " << i;
        }
    }
    EXPECT_EQ(flow.U({0, 1, 0}, 0).z, 0);
    EXPECT_NEAR(flow.U({0, 1, 0}, 1e3).z, 1.5, 1e-12);
    EXPECT_THROW
    (
        made("couette", "length 2; velocity (1 0 0);", 0.3), userError
    );
}


TEST(hagenPoiseuille, equalsFiniteDifferences)
{
    const made flow
    (
        "hagenPoiseuille",
        "radius 0.5; origin (1 0 0); axis (0 2 0); g (7 1.6 0);",
        0.1
    );
    for (double t : {0.05, 0.4, 10.0})
    {
        const auto u = diffusion(200, 0.5, 0.1, steady(1.6), 0, 1, t);
        for (int i = 0; i <= 200; i += 20)
        {
            EXPECT_NEAR(flow.U({1, 9, i*0.0025}, t).y, u[i], 3e-5)
                << t << " " << i;
        }
    }
    EXPECT_EQ(flow.U({1, 0, 0}, 0).y, 0);
    EXPECT_NEAR(flow.U({1, 0, 0}, 1e3).y, 1.6*0.25/(4*0.1), 1e-12);
}


TEST(taylorCouette, meetsItsWallsAndTheEquation)
{
    const made flow
    (
        "taylorCouette",
        "innerRadius 1; outerRadius 2; innerOmega 3; outerOmega -0.5;",
        0.1
    );
    EXPECT_NEAR(flow.U({1, 0, 5}, 0).y, 3, 1e-14);
    EXPECT_NEAR(flow.U({0, -2, 5}, 0).x, -1, 1e-14);
    // (u' + u/r)' = 0
    const double e = 1e-3;
    const auto u = [&](double r) { return flow.U({r, 0, 0}, 0).y; };
    for (double r : {1.2, 1.5, 1.9})
    {
        const double balance = (u(r + e) - 2*u(r) + u(r - e))/(e*e)
          + (u(r + e) - u(r - e))/(2*e*r) - u(r)/(r*r);
        EXPECT_NEAR(balance, 0, 1e-5) << r;
    }
    EXPECT_THROW
    (
        made("taylorCouette", "innerRadius 2; outerRadius 1;", 1), userError
    );
}
