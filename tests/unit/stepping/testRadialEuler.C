// The stepping against equations (1)-(9) written out plainly in double
// precision, with lattice neighbours known by index.

#include "common/fluids.H"
#include "common/lattice.H"

#include <gtest/gtest.h>

using namespace gpuFsi;

namespace
{

struct plainLattice
{
    int n, D;
    double length;
    std::vector<vector> x, v;
    std::vector<double> rho;

    double wrapped(double d) const
    {
        return d - length*std::round(d/length);
    }

    std::vector<int> neighbours(int i) const
    {
        const int a = i%n, b = i/n%n, c = i/(n*n);
        std::vector<int> list;
        for (int z = D == 3 ? -1 : 0; z <= (D == 3 ? 1 : 0); ++z)
        for (int y = -1; y <= 1; ++y)
        for (int u = -1; u <= 1; ++u)
        {
            if (u || y || z)
            {
                list.push_back
                (
                    (a + u + n)%n + n*((b + y + n)%n)
                  + (D == 3 ? n*n*((c + z + n)%n) : 0)
                );
            }
        }
        return list;
    }

    void step(double dt, double mu, double (*pressure)(double), vector g)
    {
        std::vector<vector> newV(v), newX(x);
        std::vector<double> newRho(rho);
        for (int i = 0; i < int(x.size()); ++i)
        {
            const auto list = neighbours(i);
            const int N = int(list.size());
            vector grad{}, lap{};
            double div = 0, R = 0;
            for (int j : list)
            {
                const vector dx
                {
                    wrapped(x[j].x - x[i].x), wrapped(x[j].y - x[i].y),
                    D == 3 ? wrapped(x[j].z - x[i].z) : 0
                };
                const double d = std::sqrt(dot(dx, dx));
                const vector unit = (1/d)*dx;
                grad += ((pressure(rho[j]) - pressure(rho[i]))/d)*unit;
                div += 0.5*dot(v[j] + v[i], unit);
                lap += (1/d)*(v[j] - v[i]);
                R += 0.5*d/N;
            }
            const double AV = D/(N*R);
            const vector force = AV*mu*lap - (double(D)/N)*grad;
            newV[i] = v[i] + (dt/rho[i])*force + dt*g;
            newRho[i] = rho[i] - dt*rho[i]*AV*div;
            newX[i] = x[i] + 0.5*dt*(v[i] + newV[i]);
        }
        x = newX;
        v = newV;
        rho = newRho;
    }
};

double isothermal(double rho)
{
    return rho/3;
}

double tait7(double rho)
{
    return (std::pow(rho, 7) - 1)/3/7;
}

double tait14(double rho)
{
    return (std::pow(rho, 1.4) - 1)/3/1.4;
}

void compare
(
    int D,
    double (*pressure)(double),
    double gamma,
    double mu,
    const char* precision,
    double tolerance
)
{
    const int n = D == 3 ? 12 : 24;
    const domain d = periodicBox(n, D, 15);
    hostState s = latticeState(d, 0.01, 5);
    for (std::size_t i = 0; i < s.fluid.size(); ++i)
    {
        const vector& x = s.fluid.positions[i];
        s.fluid.U[i] = {0.01*std::sin(2*M_PI*x.y/15), 0, 0};
    }
    plainLattice plain{n, D, 15, s.fluid.positions, s.fluid.U, {}};
    for (double delta : s.fluid.deltaRho)
    {
        plain.rho.push_back(1 + delta);
    }

    fluidProperties fluid = publishedFluid(mu);
    fluid.g = vector{0, D == 3 ? 0.003 : 0.001, 0};
    if (gamma > 0)
    {
        fluid.eos = fluidProperties::state::Tait;
        fluid.gamma = gamma;
    }
    const auto solver = fluidSolver::make
    (
        "cpu", precision, d, fluid, defaultSchemes(d), s
    );
    const double dt = 0.05;
    for (int k = 0; k < 20; ++k)
    {
        solver->step(k*dt, dt);
        plain.step(dt, mu, pressure, fluid.g.at(0));
    }
    solver->maintain();
    const hostState result = solver->download();
    double worst = 0;
    for (std::size_t i = 0; i < plain.rho.size(); ++i)
    {
        const vector u = result.fluid.U[i] - plain.v[i];
        worst = std::max
        ({
            worst, std::abs(1 + result.fluid.deltaRho[i] - plain.rho[i]),
            std::abs(u.x), std::abs(u.y), std::abs(u.z),
            std::abs(plain.wrapped(result.fluid.positions[i].x - plain.x[i].x)),
            std::abs(plain.wrapped(result.fluid.positions[i].y - plain.x[i].y))
        });
    }
    EXPECT_LT(worst, tolerance);
}

} // namespace

TEST(radialEuler, isTheEquationsIn3D)
{
    compare(3, isothermal, 0, 1, "double", 1e-12);
    compare(3, isothermal, 0, 0, "double", 1e-12);
    compare(3, isothermal, 0, 1, "single", 2e-7);
}

TEST(radialEuler, isTheEquationsIn2D)
{
    compare(2, isothermal, 0, 1, "double", 1e-12);
    compare(2, isothermal, 0, 1, "single", 2e-7);
}

TEST(radialEuler, TaitWithBothExponents)
{
    compare(3, tait7, 7, 1, "double", 1e-12);
    compare(2, tait14, 1.4, 0.5, "double", 1e-12);
}
