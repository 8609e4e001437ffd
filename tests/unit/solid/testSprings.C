// Springs and volumetric term against linear elasticity and its symmetries.

#include "blocks.H"
#include "solid/cellShape.H"

#include <fmt/format.h>
#include <gtest/gtest.h>

using namespace gpuFsi;

namespace
{

std::vector<vector> strained(const solidMesh& mesh, const vector rows[3])
{
    std::vector<vector> x = mesh.points;
    for (vector& p : x)
    {
        const vector q = p;
        p += vector{dot(rows[0], q), dot(rows[1], q), dot(rows[2], q)};
    }
    return x;
}

//- Energy of a homogeneous strain over lambda tr^2/2 + mu e:e
double energyRatio
(
    int D,
    double shake,
    const std::string& entries,
    double lambda,
    double mu
)
{
    const solidMesh mesh = block(D, 3, 3, 2, 0.5, shake);
    const springNetwork net =
        springNetwork::of(mesh, material(mesh, entries));
    const double e = 1e-6;
    const vector rows[3] =
    {
        {e, 0.3*e, D == 2 ? 0 : 0.2*e},
        {0.3*e, -0.6*e, D == 2 ? 0 : -0.4*e},
        {0, 0, 0}
    };
    vector r[3] = {rows[0], rows[1], rows[2]};
    if (D == 3)
    {
        r[2] = {0.2*e, -0.4*e, 0.7*e};
    }
    const double trace = r[0].x + r[1].y + r[2].z;
    const double square =
        dot(r[0], r[0]) + dot(r[1], r[1]) + dot(r[2], r[2]);
    double volume = 0;
    for (const double V : net.volume)
    {
        volume += V;
    }
    EXPECT_EQ(net.nClipped, 0);
    return elasticEnergy(net, strained(mesh, r))
        /(volume*(lambda*trace*trace/2 + mu*square));
}

} // namespace


TEST(springs, homogeneousStrainHasTheElasticEnergy)
{
    for (const double nu : {0.0, 0.25, 0.3, 0.4})
    {
        const double mu = 1/(2*(1 + nu));
        const double lambda = nu/((1 + nu)*(1 - 2*nu));
        const double flat = 2*lambda*mu/(lambda + 2*mu);
        const std::string E = fmt::format("E 1; nu {}; ", nu);
        for (const double shake : {0.0, 0.1})
        {
            EXPECT_NEAR(energyRatio(2, shake, E, lambda, mu), 1, 1e-5);
            EXPECT_NEAR
            (
                energyRatio(2, shake, E + "plane stress;", flat, mu), 1, 1e-5
            );
            EXPECT_NEAR(energyRatio(3, shake, E, lambda, mu), 1, 1e-5);
        }
    }
}


//- Eq (11): k V between all neighbours; on squares of side h that is
//      k h^2/2 (exx^2 + eyy^2 + (exx + eyy)^2 + 4 exy^2) an area
TEST(springs, uniformSpringsAreThePublishedOnes)
{
    const double h = 0.5;
    const solidMesh flat = block(2, 4, 3, 0, h);
    const springNetwork net =
        springNetwork::of(flat, material(flat, "springs uniform; k 3;"));
    const double a = 1e-6, b = -0.6e-6, c = 0.3e-6;
    const vector rows[3] = {{a, c, 0}, {c, b, 0}, {0, 0, 0}};
    const double density =
        3*h*h/2*(a*a + b*b + (a + b)*(a + b) + 4*c*c);
    EXPECT_NEAR
    (
        elasticEnergy(net, strained(flat, rows))/(density*12*h*h), 1, 1e-5
    );

    const solidMesh solid = block(3, 2, 2, 2, h);
    const springNetwork cube =
        springNetwork::of(solid, material(solid, "springs uniform; k 3;"));
    const int middle = 13;
    EXPECT_EQ(cube.bondBegin[middle + 1] - cube.bondBegin[middle], 26);
    for (int i = cube.bondBegin[middle]; i < cube.bondBegin[middle + 1]; ++i)
    {
        EXPECT_NEAR(cube.bondK[i], 3*h*h*h, 1e-14);
    }
}


TEST(springs, gradientOfTheVolume)
{
    const solidMesh mesh = block(3, 1, 1, 1, 1, 0.2);
    std::vector<vector> x;
    for (const int i : mesh.cells[0])
    {
        x.push_back(mesh.points[i]);
    }
    for (int a = 0; a < 8; ++a)
    {
        std::vector<vector> hi = x, lo = x;
        hi[a].y += 1e-4;
        lo[a].y -= 1e-4;
        const double slope =
            (cellShape<3>::volume(hi.data()) - cellShape<3>::volume(lo.data()))
           /2e-4;
        EXPECT_NEAR(cellShape<3>::gradient(x.data(), a).y, slope, 1e-10);
    }
}


TEST(springs, accelerationIsMinusTheGradientOfTheEnergy)
{
    for (const int D : {2, 3})
    {
        const solidMesh mesh = block(D, 2, 2, 2, 1, 0.1);
        const solidProperties p =
            material(mesh, "E 1; nu 0.4;", {}, "subSteps 1;");
        const springNetwork net = springNetwork::of(mesh, p);
        solidState s;
        s.positions = block(D, 2, 2, 2, 1.05, 0.12).points;
        const auto solver = elasticSolver::make("cpu", mesh, p, s);
        solver->advance(0, 1e-9);
        vector force{}, torque{};
        double largest = 0;
        for (int i = 0; i < net.n; ++i)
        {
            std::vector<vector> hi = s.positions, lo = s.positions;
            hi[i].x += 1e-5;
            lo[i].x -= 1e-5;
            const double slope =
                (elasticEnergy(net, hi) - elasticEnergy(net, lo))/2e-5;
            const vector f = net.mass[i]*solver->accelerations()[i];
            EXPECT_NEAR(f.x, -slope, 1e-8);
            force += f;
            torque += cross(s.positions[i], f);
            largest = std::max(largest, std::fabs(f.x));
        }
        EXPECT_GT(largest, 1e-3);
        EXPECT_NEAR(std::sqrt(dot(force, force)), 0, 1e-13);
        EXPECT_NEAR(std::sqrt(dot(torque, torque)), 0, 1e-12);
    }
}


TEST(springs, aTurnedSolidIsUnstressed)
{
    const solidMesh mesh = block(3, 2, 2, 2, 1, 0.1);
    const solidProperties p = material(mesh, "E 1; nu 0.4;");
    const springNetwork net = springNetwork::of(mesh, p);
    const double c = std::cos(1.0), s = std::sin(1.0);
    const vector rows[3] = {{c - 1, -s, 0}, {s, c - 1, 0}, {0, 0, 0}};
    hostSolid state;
    state.positions = strained(mesh, rows);
    EXPECT_LT(elasticEnergy(net, state.positions), 1e-28);
    addSolidFields(mesh, p, net, state);
    for (int i = 0; i < net.n; ++i)
    {
        EXPECT_NEAR(state.vonMises[i], 0, 1e-13);
        EXPECT_NEAR(state.rho[i], 1, 1e-13);
    }
}
