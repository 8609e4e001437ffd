// The operators of the area-weight schemes through the solver: one Euler step
// of length dt gives the rates of change.

#include "common/column.H"
#include "common/fluids.H"
#include "common/lattice.H"

#include <gtest/gtest.h>

#include <functional>

using namespace gpuFsi;

namespace
{

constexpr double dt = 1e-4;
constexpr double k = 2*M_PI;

particleSchemes moment(const domain& d, bool hermite = false, double a = 1)
{
    particleSchemes s = defaultSchemes(d);
    s.areaWeights = particleSchemes::weight::moment;
    s.faces = hermite ? particleSchemes::face::hermite
      : particleSchemes::face::linear;
    s.laplacianFactor = a;
    return s;
}

hostState afterOneStep
(
    const domain& d,
    const particleSchemes& schemes,
    const hostState& s,
    double mu
)
{
    fluidProperties fluid = publishedFluid(mu);
    fluid.c = 1;
    const auto solver = fluidSolver::make
    (
        "cpu", "double", d, fluid, schemes, s
    );
    solver->step(0, dt);
    solver->monitor();
    return solver->download();
}

struct errors
{
    double gradient, divergence, laplacian;
};

double relative
(
    const hostState& s,
    const std::function<vector(std::size_t)>& found,
    const std::function<vector(const vector&)>& exact
)
{
    double e = 0, size = 0;
    for (std::size_t i = 0; i < s.fluid.size(); ++i)
    {
        const vector x = exact(s.fluid.positions[i]);
        const vector difference = found(i) - x;
        e += dot(difference, difference);
        size += dot(x, x);
    }
    return std::sqrt(e/size);
}

//- Relative rms errors on sines and cosines in the unit cube
errors measure(int n, double displace, bool hermite, double a)
{
    const domain d = periodicBox(n, 3, 1);
    const particleSchemes schemes = moment(d, hermite, a);
    hostState s = latticeState(d, 0, 1, displace);
    const double size = 1e-3;
    for (std::size_t i = 0; i < s.fluid.size(); ++i)
    {
        const vector& x = s.fluid.positions[i];
        s.fluid.deltaRho[i] =
            size*std::sin(k*x.x)*std::cos(k*x.y)*std::cos(k*x.z);
    }
    errors e;
    {
        const hostState r = afterOneStep(d, schemes, s, 0);
        e.gradient = relative
        (
            s,
            [&](std::size_t i)
            {
                return (-(1 + s.fluid.deltaRho[i])/dt/size)*r.fluid.U[i];
            },
            [](const vector& x)
            {
                const double sx = std::sin(k*x.x), cx = std::cos(k*x.x);
                const double sy = std::sin(k*x.y), cy = std::cos(k*x.y);
                const double sz = std::sin(k*x.z), cz = std::cos(k*x.z);
                return k*vector{cx*cy*cz, -sx*sy*cz, -sx*cy*sz};
            }
        );
    }
    for (std::size_t i = 0; i < s.fluid.size(); ++i)
    {
        const vector& x = s.fluid.positions[i];
        s.fluid.deltaRho[i] = 0;
        s.fluid.U[i] =
        {
            std::sin(k*x.x)*std::cos(k*x.y),
            std::sin(k*x.y)*std::cos(k*x.z),
            std::sin(k*x.z)
        };
    }
    {
        const hostState r = afterOneStep(d, schemes, s, 0);
        e.divergence = relative
        (
            s,
            [&](std::size_t i)
            {
                return vector{-r.fluid.deltaRho[i]/dt, 0, 0};
            },
            [](const vector& x)
            {
                return vector
                {
                    k*std::cos(k*x.x)*std::cos(k*x.y)
                  + k*std::cos(k*x.y)*std::cos(k*x.z)
                  + k*std::cos(k*x.z), 0, 0
                };
            }
        );
    }
    for (std::size_t i = 0; i < s.fluid.size(); ++i)
    {
        const vector& x = s.fluid.positions[i];
        s.fluid.U[i] =
        {
            std::sin(k*x.x)*std::cos(k*x.y)*std::cos(k*x.z), 0, 0
        };
    }
    const hostState r = afterOneStep(d, schemes, s, 1);
    e.laplacian = relative
    (
        s,
        [&](std::size_t i)
        {
            // The pressure does not change within the step
            return (1/dt)*(r.fluid.U[i] - s.fluid.U[i]);
        },
        [](const vector& x)
        {
            return vector
            {
                -3*k*k*std::sin(k*x.x)*std::cos(k*x.y)*std::cos(k*x.z), 0, 0
            };
        }
    );
    return e;
}

void report(const char* what, int n, const errors& e)
{
    std::printf("%-34s %3d^3: gradient %.3g divergence %.3g Laplacian %.3g\n",
        what, n, e.gradient, e.divergence, e.laplacian);
}

double order(double coarse, double fine, double ratio)
{
    return std::log(coarse/fine)/std::log(ratio);
}

} // namespace

TEST(accuracy, linearFacesOffTheLattice)
{
    const errors a = measure(12, 0.2, false, 1);
    const errors b = measure(48, 0.2, false, 1);
    report("displaced 20%, linear", 12, a);
    report("displaced 20%, linear", 48, b);
    EXPECT_LE(b.gradient, 0.022);
    EXPECT_LE(b.divergence, 0.014);
    EXPECT_LE(b.laplacian, 0.012);
    EXPECT_GE(order(a.gradient, b.gradient, 4), 1.3);
    EXPECT_GE(order(a.divergence, b.divergence, 4), 1.3);
    EXPECT_GE(order(a.laplacian, b.laplacian, 4), 1.3);
}

TEST(accuracy, linearFacesAreSecondOrderOnTheLattice)
{
    const errors a = measure(12, 0, false, 1);
    const errors b = measure(24, 0, false, 1);
    report("lattice, linear", 12, a);
    report("lattice, linear", 24, b);
    EXPECT_GE(order(a.gradient, b.gradient, 2), 1.85);
    EXPECT_GE(order(a.divergence, b.divergence, 2), 1.85);
    EXPECT_GE(order(a.laplacian, b.laplacian, 2), 1.85);
}

TEST(accuracy, hermiteFacesAreFourthOrderOnTheLattice)
{
    const errors a = measure(12, 0, true, 4.0/3);
    const errors b = measure(24, 0, true, 4.0/3);
    report("lattice, hermite", 12, a);
    report("lattice, hermite", 24, b);
    EXPECT_GE(order(a.gradient, b.gradient, 2), 3.7);
    EXPECT_GE(order(a.divergence, b.divergence, 2), 3.7);
    EXPECT_GE(order(a.laplacian, b.laplacian, 2), 3.7);
}

//- Gradient and divergence of linear, Laplacian of quadratic fields, on any
//  arrangement, with walls whose values are given
TEST(accuracy, exactForPolynomialsAlsoBesideWalls)
{
    const domain d = columnDomain(12, 8, 1);
    hostState s = columnState(d);
    const double h = d.spacing;
    for (std::size_t i = 0; i < s.fluid.size(); ++i)
    {
        s.fluid.positions[i] += vector
        {
            0.2*h*hashed(2*i), 0.2*h*hashed(2*i + 1), 0
        };
    }
    // Functions of x only: the column is periodic in y
    const auto set = [&](bool quadratic)
    {
        for (particleSet* p : {&s.fluid, &s.walls})
        {
            for (std::size_t i = 0; i < p->size(); ++i)
            {
                const double x = p->positions[i].x;
                p->deltaRho[i] = 1e-3*(0.3 - 0.7*x);
                p->U[i] = {0.3 - 0.7*x, quadratic ? x*x - 0.4*x : 0.2*x, 0};
            }
        }
        return afterOneStep(d, moment(d), s, 1);
    };
    double worst = 0;
    const hostState linear = set(false);
    for (std::size_t i = 0; i < s.fluid.size(); ++i)
    {
        const double rho = 1 + s.fluid.deltaRho[i];
        const double rate =
            (linear.fluid.deltaRho[i] - s.fluid.deltaRho[i])/dt;
        const vector a = (rho/dt)*(linear.fluid.U[i] - s.fluid.U[i]);
        worst = std::max
        ({
            worst, std::abs(rate - 0.7*rho), std::abs(a.x - 0.7e-3),
            std::abs(a.y)
        });
    }
    const hostState quadratic = set(true);
    for (std::size_t i = 0; i < s.fluid.size(); ++i)
    {
        const double rho = 1 + s.fluid.deltaRho[i];
        const vector a = (rho/dt)*(quadratic.fluid.U[i] - s.fluid.U[i]);
        worst = std::max(worst, std::abs(a.y - 2));
    }
    EXPECT_LT(worst, 2e-9);    // round-off over h^2 and dt
}

TEST(accuracy, movingFrameChangesNothing)
{
    const domain d = periodicBox(16, 2, 1);
    fluidProperties fluid = publishedFluid(0.01);
    fluid.c = 1;
    particleSchemes schemes = moment(d, true);
    schemes.dissipation = 0.1;
    schemes.shifting = 0.5;
    schemes.weightExponent = 3;
    schemes.time = particleSchemes::timeScheme::symplecticEuler;
    const double step = 0.2*d.spacing, boost = 10;
    hostState results[2];
    for (int moving = 0; moving < 2; ++moving)
    {
        hostState s = latticeState(d, 0.05, 0.05, 0.2);
        for (std::size_t i = 0; i < s.fluid.size(); ++i)
        {
            const vector& x = s.fluid.positions[i];
            s.fluid.U[i] =
            {
                0.1*std::sin(k*x.y) + moving*boost, 0.1*std::sin(k*x.x), 0
            };
        }
        const auto solver = fluidSolver::make
        (
            "cpu", "double", d, fluid, schemes, s
        );
        for (int i = 0; i < 100; ++i)
        {
            solver->step(i*step, step);
            if (solver->maintenanceDue())
            {
                solver->maintain();
            }
        }
        results[moving] = solver->download();
    }
    double worst = 0;
    for (std::size_t i = 0; i < results[0].fluid.size(); ++i)
    {
        const vector u = results[1].fluid.U[i] - results[0].fluid.U[i]
          - vector{boost, 0, 0};
        worst = std::max
        ({
            worst, std::abs(u.x), std::abs(u.y),
            std::abs(results[1].fluid.deltaRho[i]
              - results[0].fluid.deltaRho[i])
        });
    }
    EXPECT_LT(worst, 1e-10);
}
