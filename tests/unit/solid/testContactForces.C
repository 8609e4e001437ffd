// Nearest points against brute force; forces of contact against differences of
// their energy.

#include "contactScene.H"
#include "solid/contactSearch.H"
#include "solid/contactShape.H"
#include "solid/wallsAtOnce.H"

#include <gtest/gtest.h>

#include <random>

using namespace gpuFsi;

namespace
{

//- The least distance of the origin from a fine grid of points of a triangle
double leastDistance(const vector& a, const vector& b, const vector& c)
{
    const int n = 200;
    double least = 1e300;
    for (int i = 0; i <= n; ++i)
    {
        for (int j = 0; i + j <= n; ++j)
        {
            const double u = double(i)/n, v = double(j)/n;
            const vector p = (1 - u - v)*a + u*b + v*c;
            least = std::min(least, dot(p, p));
        }
    }
    return std::sqrt(least);
}

//- Two blocks that overlap a little, at rest
struct overlap
{
    solidMesh mesh;
    solidProperties properties;
    std::vector<vector> x;

    explicit overlap(int D, const std::string& contact = "")
    {
        addBlock(mesh, block(D, 3, 3, 3, 0.2, 0.1), {-0.75, 0, 0}, "one");
        addBlock
        (
            mesh, block(D, 3, 3, 3, 0.17, 0.1), {0.05, 0.07, D == 2 ? 0 : 0.04},
            "two"
        );
        properties = propertiesOf
        (
            mesh, "one { rho 1; E 1; } two { rho 2; E 3; } contact {"
          + contact + "}"
        );
        x = mesh.points;
        for (std::size_t i = 0; i < x.size(); ++i)
        {
            x[i].x -= mesh.solid[i] == 1 ? 0.24 : 0;
        }
    }

    std::unique_ptr<elasticSolver> solver(const std::vector<vector>& at) const
    {
        solidState s;
        s.positions = at;
        return elasticSolver::make("cpu", mesh, properties, s);
    }
};

//- Two walls that meet in the origin at this angle, rad
contactWalls groove(double angle, double h)
{
    const double s = std::sin(angle/2), c = std::cos(angle/2);
    contactWalls walls;
    for (const double side : {-1, 1})
    {
        const vector along{side*s, c, 0}, normal{-side*c, s, 0};
        addWall(walls, 2, (8.5*h)*along, normal, along, h, 8);
    }
    return walls;
}

//- A block on its corner, particle 0, which is this far below the ground of a
//  groove of 20 degrees
struct wedgedCorner
{
    static constexpr double h = 0.1, angle = M_PI/9;
    solidMesh mesh;
    solidState state;

    wedgedCorner()
    {
        solidMesh square = block(2, 4, 4, 0, h);
        for (vector& x : square.points)
        {
            x = vector{M_SQRT1_2*(x.x - x.y), M_SQRT1_2*(x.x + x.y), 0};
        }
        addBlock(mesh, square, {0, 40*h, 0}, "bar");
        for (const vector& x : mesh.points)
        {
            state.positions.push_back(x - vector{0, 40.3*h, 0});
        }
    }

    std::unique_ptr<elasticSolver> solver
    (
        const vector& moved,
        const contactWalls& walls
    ) const
    {
        solidState s = state;
        s.positions[0] += moved;
        return elasticSolver::make
        (
            "cpu", mesh,
            propertiesOf
            (
                mesh, "bar { rho 1; E 1; } contact { stiffness 10; }"
            ),
            s, walls
        );
    }
};

} // namespace


TEST(contactShape, nearestPointOfAFace)
{
    std::mt19937 random(3);
    std::uniform_real_distribution<double> number(-1, 1);
    const auto somewhere = [&]
    {
        return vector{number(random), number(random), number(random)};
    };
    for (int k = 0; k < 40; ++k)
    {
        const vector shift = 1.5*somewhere();
        vector y[4] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
        for (vector& corner : y)
        {
            corner += shift + 0.2*somewhere();
        }
        const vector centre = 0.25*(y[0] + y[1] + y[2] + y[3]);
        double least = 1e300;
        for (int e = 0; e < 4; ++e)
        {
            least = std::min(least, leastDistance(y[e], y[(e + 1)%4], centre));
        }
        const facePoint<3> p = nearestPoint(y);
        EXPECT_LE(std::sqrt(p.square), least + 1e-12);
        EXPECT_GE(std::sqrt(p.square), least - 0.01);
        vector rest = p.away;
        double sum = 0;
        for (int a = 0; a < 4; ++a)
        {
            rest += p.weight[a]*y[a];
            sum += p.weight[a];
            EXPECT_GE(p.weight[a], 0);
        }
        EXPECT_LT(dot(rest, rest), 1e-28);
        EXPECT_NEAR(sum, 1, 1e-14);
        EXPECT_NEAR(dot(p.normal, p.normal), 1, 1e-14);
    }
}


TEST(contactShape, nearestPointOfAnEdge)
{
    const vector right[2] = {{1, -1, 0}, {1, 3, 0}};
    const facePoint<2> within = nearestPoint(right);
    EXPECT_EQ(within.square, 1);
    EXPECT_EQ(within.weight[1], 0.25);
    EXPECT_EQ(within.height(), -1);     // its outside is further right
    const vector beyond[2] = {{1, 1, 0}, {1, 3, 0}};
    EXPECT_EQ(nearestPoint(beyond).square, 2);
    EXPECT_EQ(nearestPoint(beyond).weight[0], 1);
}


//- The energy alone knows nothing of how forces are shared out
TEST(contact, forceIsMinusTheGradientOfTheEnergy)
{
    for (const int D : {2, 3})
    {
        const overlap scene(D);
        const auto solver = scene.solver(scene.x);
        const std::vector<vector> force = solver->contactForces();
        EXPECT_GT(solver->energies().contact, 0);
        const double step = 1e-6;
        int touched = 0;
        for (std::size_t i = 0; i < scene.mesh.size(); ++i)
        {
            // Of those that touch nothing in 3-D a few will do
            touched += dot(force[i], force[i]) > 0;
            if (D == 3 && dot(force[i], force[i]) == 0 && i%9)
            {
                continue;
            }
            for (double vector::*axis : {&vector::x, &vector::y, &vector::z})
            {
                if (D == 2 && axis == &vector::z)
                {
                    continue;
                }
                std::vector<vector> to = scene.x, fro = scene.x;
                to[i].*axis += step;
                fro[i].*axis -= step;
                const double slope =
                    (scene.solver(to)->energies().contact
                  - scene.solver(fro)->energies().contact)/(2*step);
                EXPECT_NEAR(force[i].*axis, -slope, 1e-7) << D << " " << i;
            }
        }
        EXPECT_GT(touched, D == 2 ? 5 : 20);
    }
}


TEST(contact, gapIsNoWiderThanAsSeeded)
{
    // The blocks are seeded 0.15 apart at most, but touch only where pushed in
    const overlap wide(2, "gap 0.5;");
    EXPECT_EQ(wide.solver(wide.mesh.points)->energies().contact, 0);
    const overlap narrow(2);
    EXPECT_GT
    (
        wide.solver(wide.x)->energies().contact,
        narrow.solver(narrow.x)->energies().contact
    );
}


//- As for mm: more than ten spacings of 0.2
TEST(contact, lengthsInAnotherUnit)
{
    for (const char* length : {"gap 2.1;", "margin 2.1;"})
    {
        const overlap scene(2, length);
        try
        {
            scene.solver(scene.mesh.points);
            ADD_FAILURE() << length;
        }
        catch (const userError& e)
        {
            const std::string text = e.what();
            EXPECT_NE(text.find("is 2.1 m"), std::string::npos) << text;
            EXPECT_NE(text.find("spacing, 0."), std::string::npos) << text;
        }
    }
}


TEST(contact, candidatesPastAnInt)
{
    EXPECT_EQ(contactRowEnd(2147483647u), 2147483647);
    EXPECT_THROW(contactRowEnd(2147483648u), userError);
}


TEST(contact, wallsTouchedAtOnce)
{
    const double h = 0.1;
    const auto atOnce = [&](const contactWalls& walls)
    {
        return wallsAtOnce(walls, 5*h, {});
    };
    EXPECT_EQ(atOnce({}), 0);
    EXPECT_NEAR(atOnce(groove(M_PI, h)), 1, 1e-12);
    EXPECT_NEAR(atOnce(groove(M_PI/2, h)), 1, 1e-12);
    EXPECT_NEAR(atOnce(groove(M_PI/9, h)), 1 + std::cos(M_PI/9), 1e-12);
    EXPECT_NEAR(atOnce(groove(1.9*M_PI, h)), 1, 1e-12);
    for (const double side : {-1, 1})
    {
        contactWalls pair;      // a plate, or a slot
        addWall(pair, 3, {0, 0, -side*h}, {0, 0, side}, {1, 0, 0}, h, 4);
        addWall(pair, 3, {0, 0, side*h}, {0, 0, -side}, {1, 0, 0}, h, 4);
        EXPECT_NEAR(atOnce(pair), 2, 1e-12);
        for (vector& normal : pair.normals)
        {
            normal = -1.0*normal;
        }
        EXPECT_NEAR(atOnce(pair), 1, 1e-12);
    }
}


//- The stiffness that a corner feels between two walls is what sub-steps are
//  chosen by: exact, as the corner has the largest share of area over mass
TEST(contact, subStepsInAGroove)
{
    const wedgedCorner scene;
    const contactWalls walls = groove(scene.angle, scene.h);
    const double step = 1e-6;
    const auto push = [&](double x)
    {
        return scene.solver({x, 0, 0}, walls)->contactForces()[0].x;
    };
    const auto square = [](double x) { return x*x; };
    const auto solver = scene.solver({}, walls);
    const double stiffness = (push(-step) - push(step))/(2*step);
    const double added = square(solver->omegaMax())
      - square(scene.solver({}, {})->omegaMax());
    EXPECT_NEAR(stiffness/solver->masses()[0]/added, 1, 1e-6);
}
