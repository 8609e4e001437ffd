#include "exact/exactSolution.H"

#include <gtest/gtest.h>

#include <cmath>

using namespace gpuFsi;

namespace
{

constexpr double pi = 3.14159265358979323846;

std::unique_ptr<exactSolution> make
(
    const std::string& word,
    const std::string& text,
    double c,
    double nu
)
{
    static std::vector<std::unique_ptr<dictionary>> kept;
    kept.push_back
    (
        std::make_unique<dictionary>(dictionary::fromString(text))
    );
    fluidConstants fluid;
    fluid.c = c;
    fluid.nu = nu;
    return exactSolution::make(word, *kept.back(), fluid);
}

//- Staggered finite differences of rho_t = -rho0 v_s, v_t = -c^2/rho0 rho_s
//  + nu v_ss (rho0 1), the wall at s = 0 moving as A omega sin(omega t)
struct lineSolver
{
    std::vector<double> v, rho;

    lineSolver
    (
        int n, double L, double c, double nu, double A, double omega, double T
    )
    :
        v(n + 1, 0),
        rho(n, 0)
    {
        const double h = L/n;
        const double limit = std::min(0.5*h/c, 0.2*h*h/(nu + 1e-300));
        const int steps = int(T/limit) + 1;
        const double dt = T/steps;
        for (int step = 0; step < steps; ++step)
        {
            // Leap-frog: v at whole steps, rho half a step on, then averaged
            const double before = A*omega*std::sin(omega*step*dt);
            v[0] = before;
            std::vector<double> middle(rho);
            for (int i = 0; i < n; ++i)
            {
                middle[i] -= dt/2*(v[i + 1] - v[i])/h;
            }
            std::vector<double> w(v);
            for (int i = 1; i < n; ++i)
            {
                w[i] += dt
                   *(
                        -c*c*(middle[i] - middle[i - 1])/h
                      + nu*(v[i + 1] - 2*v[i] + v[i - 1])/(h*h)
                    );
            }
            w[0] = A*omega*std::sin(omega*(step + 1)*dt);
            v = w;
            for (int i = 0; i < n; ++i)
            {
                rho[i] = middle[i] - dt/2*(v[i + 1] - v[i])/h;
            }
        }
    }
};

} // namespace


TEST(piston, equalsAFineFiniteDifferenceSolver)
{
    const double L = 2, c = 1.3, A = 0.01, omega = 2.1;
    for (double nu : {0.4, 0.05})
    {
        const auto exact = make
        (
            "piston",
            "length 2; amplitude 0.01; omega 2.1;",
            c,
            nu
        );
        for (double T : {0.7, 5.0})
        {
            double error[2] = {0, 0};
            double size = 0;
            for (int level = 0; level < 2; ++level)
            {
                const int n = 100*(level + 1);
                const lineSolver line(n, L, c, nu, A, omega, T);
                std::vector<vector> cells, faces;
                for (int i = 0; i < n; ++i)
                {
                    cells.push_back({(i + 0.5)*L/n, 3, 4});
                    faces.push_back({i*L/n, 3, 4});
                }
                const auto rho = exact->scalar("deltaRho", cells, T);
                const auto U = exact->vectors("U", faces, T);
                for (int i = 0; i < n; ++i)
                {
                    error[level] = std::max
                    ({
                        error[level],
                        std::abs(rho[i] - line.rho[i]),
                        std::abs(U[i].x - line.v[i])
                    });
                    size = std::max(size, std::abs(rho[i]));
                }
            }
            EXPECT_GT(size, 2e-3);
            EXPECT_LT(error[1], 0.01*size) << nu << " " << T;
            EXPECT_LT(error[1], 0.65*error[0]) << nu << " " << T;
        }
    }
}


TEST(piston, obeysMassMomentumAndItsWalls)
{
    const double c = 0.8, nu = 0.3;
    const auto exact = make
    (
        "piston",
        "pistonCoeffs { length 3; amplitude 0.02; omega 1.7;"
        " direction (0 -2 0); origin (0 5 0); }",
        c,
        nu
    );
    const auto rho = [&](double s, double t)
    {
        return exact->scalar("deltaRho", {{7, 5 - s, 0}}, t)[0];
    };
    const auto v = [&](double s, double t)
    {
        return -exact->vectors("U", {{7, 5 - s, 0}}, t)[0].y;
    };
    const double e = 1e-3;
    for (double t : {0.4, 2.0, 9.0})
    {
        EXPECT_NEAR(v(0, t), 0.02*1.7*std::sin(1.7*t), 1e-9);
        EXPECT_NEAR(v(3, t), 0, 1e-9);
        for (double s : {0.2, 1.1, 2.6})
        {
            EXPECT_NEAR
            (
                (rho(s, t + e) - rho(s, t - e))/(2*e),
                -(v(s + e, t) - v(s - e, t))/(2*e),
                1e-7
            ) << s << " " << t;
            EXPECT_NEAR
            (
                (v(s, t + e) - v(s, t - e))/(2*e),
                -c*c*(rho(s + e, t) - rho(s - e, t))/(2*e)
              + nu*(v(s + e, t) - 2*v(s, t) + v(s - e, t))/(e*e),
                2e-6
            ) << s << " " << t;
        }
    }
}


TEST(piston, startsFromRest)
{
    for (double nu : {0.0, 0.5})
    {
        const auto exact = make
        (
            "piston", "length 1; amplitude 0.1; omega 2;", 1, nu
        );
        for (double s : {0.0, 0.3, 1.0})
        {
            EXPECT_NEAR(exact->scalar("deltaRho", {{s, 0, 0}}, 0)[0], 0, 1e-9);
            EXPECT_NEAR(exact->vectors("U", {{s, 0, 0}}, 0)[0].x, 0, 1e-9);
        }
    }
}


TEST(piston, inviscidWavesAreDelayedImagesOfTheWall)
{
    // d'Alembert: v = sum_m u(t - (s + 2 m L)/c) - u(t - (2 (m+1) L - s)/c),
    // deltaRho = rho0/c times the same sum with a plus
    const double L = 2, c = 1.5;
    const auto exact = make
    (
        "piston", "length 2; amplitude 0.01; omega 3;", c, 0
    );
    const auto u = [](double t)
    {
        return t > 0 ? 0.03*std::sin(3*t) : 0;
    };
    for (double t : {0.3, 1.1, 2.5, 12.3})
    {
        for (double s : {0.0, 0.4, 1.0, 1.64, 1.66, 2.0})
        {
            double v = 0;
            double rho = 0;
            for (int m = 0; m < 20; ++m)
            {
                const double right = u(t - (s + 2*m*L)/c);
                const double left = u(t - (2*(m + 1)*L - s)/c);
                v += right - left;
                rho += (right + left)/c;
            }
            EXPECT_NEAR(exact->vectors("U", {{s, 0, 0}}, t)[0].x, v, 1e-9)
                << s << " " << t;
            EXPECT_NEAR(exact->scalar("deltaRho", {{s, 0, 0}}, t)[0], rho, 1e-9)
                << s << " " << t;
        }
    }
}


TEST(piston, undampedResonanceIsAnError)
{
    try
    {
        make
        (
            "piston", "length 2; amplitude 0.01; omega 3.14159265358979;", 1, 0
        );
        FAIL();
    }
    catch (const userError& e)
    {
        EXPECT_NE
        (
            std::string(e.what()).find("grows without bound"),
            std::string::npos
        );
    }
}


TEST(standingWave, decaysAndTurnsAsStated)
{
    const double c = 0.9, nu = 0.2, L = 2;
    const auto exact = make
    (
        "standingWave", "length 2; mode 3; amplitude 0.05; rho0 2;", c, nu
    );
    const double k = 3*pi/L;
    const double gamma = nu*k*k/2;
    const double omega = std::sqrt(c*c*k*k - gamma*gamma);
    for (double t : {0.0, 0.3, 1.9})
    {
        const double s = 0.37;
        const double time = std::exp(-gamma*t)
            *(std::cos(omega*t) + gamma/omega*std::sin(omega*t));
        EXPECT_NEAR
        (
            exact->scalar("deltaRho", {{s, 1, 1}}, t)[0],
            0.05*std::cos(k*s)*time,
            1e-15
        );
        const double speed = 0.05/2*c*c*k*std::exp(-gamma*t)
            *std::sin(omega*t)/omega*std::sin(k*s);
        EXPECT_NEAR(exact->vectors("U", {{s, 1, 1}}, t)[0].x, speed, 1e-15);
    }
}


TEST(hydrostatic, isExponentialAndAtRest)
{
    const auto exact = make
    (
        "hydrostatic", "g (0 -0.2 0); origin (0 1 0); rho0 3;", 0.7, 0
    );
    const auto rho = exact->scalar("deltaRho", {{4, 0.25, 1}}, 5)[0];
    EXPECT_NEAR(rho, 3*(std::exp(0.2*0.75/0.49) - 1), 1e-14);
    const vector U = exact->vectors("U", {{4, 0.25, 1}}, 5)[0];
    EXPECT_EQ(dot(U, U), 0);
}


TEST(exactSolution, unknownWordListsTheValid)
{
    try
    {
        make("pistn", "", 1, 0);
        FAIL();
    }
    catch (const userError& e)
    {
        const std::string text = e.what();
        for (const char* word :
            {"pistn", "piston", "acousticPulse", "hydrostatic",
             "standingWave"})
        {
            EXPECT_NE(text.find(word), std::string::npos) << text;
        }
    }
}
