// Solids that touch, against exact solutions.

#include "contactScene.H"

#include <gtest/gtest.h>

using namespace gpuFsi;

namespace
{

solidProperties read(const solidMesh& mesh, const std::string& text, vector g)
{
    return solidProperties::read(dictionary::fromString(text), g, mesh);
}

//- Two bars of length 1, endless across, apart by 2e-4, that meet at t = 0.1
struct barPair
{
    solidMesh mesh;
    solidState state;
    static constexpr double speed = 1e-3;

    explicit barPair(int cells)
    {
        const solidMesh bar = block(2, cells, 3, 0, 1.0/cells, 0, true);
        addBlock(mesh, bar, {-1.0001, 0, 0}, "one");
        addBlock(mesh, bar, {0.0001, 0, 0}, "two");
        for (const int s : mesh.solid)
        {
            state.U.push_back({s == 0 ? speed : -speed, 0, 0});
        }
    }
};

//- When contact ends, and how it was
struct collision
{
    double time = 0;            // s, of contact
    double restitution = 0;
    double momentum = 0;        // largest sum, kg m/s
    double energy = 0;          // largest change of the total, relative

    explicit collision(int cells)
    {
        const barPair pair(cells);
        const auto solver = elasticSolver::make
        (
            "cpu", pair.mesh,
            read(pair.mesh, "one { rho 1; E 1; } two { $one; } contact {}", {}),
            pair.state
        );
        const double before = total(solver->energies());
        const double dt = 0.25/cells;
        double first = 0, last = 0;
        for (double t = 0; t < 3; t += dt)
        {
            solver->advance(t, dt);
            if (solver->energies().contact > 0)
            {
                first = first > 0 ? first : t;
                last = t;
            }
            const double change = total(solver->energies())/before - 1;
            energy = std::max(energy, std::fabs(change));
            const motionOf all(pair.mesh, *solver);
            momentum = std::max(momentum, std::fabs(all.momentum.x));
        }
        time = last - first;
        restitution =
            motionOf(pair.mesh, *solver, 1).velocity().x/barPair::speed;
    }
};

//- A bar that a wall at x = 0 holds against gravity
struct restingBar
{
    double top;         // m, how far the end has sunk
    double reaction;    // N

    restingBar(const std::string& contact, double g)
    {
        const int cells = 32;
        solidMesh mesh;
        addBlock
        (
            mesh, block(2, cells, 4, 0, 1.0/cells, 0, true), vector{}, "bar"
        );
        contactWalls walls;
        addWall(walls, 2, vector{}, {1, 0, 0}, {0, 1, 0}, 1.0/cells, 8);
        const auto solver = elasticSolver::make
        (
            "cpu", mesh,
            read
            (
                mesh, "bar { rho 1; E 1; viscous 3; } contact {" + contact
              + "}", {-g, 0, 0}
            ),
            {}, walls
        );
        march(*solver, 800, 0.05);
        top = 1 - solver->positions()[cells].x;
        reaction = 0;
        for (const vector& f : solver->contactForces())
        {
            reaction += f.x;
        }
    }
};

//- Blocks that meet askew
solidMesh askew(int D)
{
    solidMesh mesh;
    addBlock(mesh, block(D, 8, 8, 4, 0.125, 0.05), {-1.1, 0, 0}, "one");
    addBlock(mesh, block(D, 6, 6, 4, 0.13, 0.05), {0, 0.55, D == 2 ? 0 : 0.1}, "two");
    return mesh;
}

struct run
{
    solidMesh mesh;
    std::unique_ptr<elasticSolver> solver;

    run(int D, const std::string& contact, const char* backend = "cpu")
    :
        mesh(askew(D))
    {
        solidState state;
        for (const int s : mesh.solid)
        {
            state.U.push_back
            (
                s == 0 ? vector{0.1, 0.04, 0} : vector{-0.1, 0, 0}
            );
        }
        solver = elasticSolver::make
        (
            backend, mesh,
            read
            (
                mesh, "one { rho 1; E 1; nu 0.3; } two { rho 2; E 3; }"
                " contact {" + contact + "} subSteps 2;", {}
            ),
            state
        );
    }
};

} // namespace


//- Exact: contact lasts 2 L/c, the bars exchange their velocities
TEST(contact, barsHeadOn)
{
    const double exact = 2/std::sqrt(1.2);
    for (const int cells : {16, 32, 64, 128})
    {
        const collision c(cells);
        fmt::print
        (
            "{} time {:.4f} restitution {:.4f} momentum {:.2g} energy {:.2g}\n",
            cells, c.time/exact, c.restitution, c.momentum, c.energy
        );
    }
}


TEST(contact, barRestsOnAWall)
{
    const double g = 0.01, M = 1.2, h = 1.0/32;
    for (const char* contact : {"", "stiffness 4;", "gap 0.01;"})
    {
        const restingBar bar(contact, g);
        fmt::print
        (
            "{} top {} exact {} + {} reaction {}\n", contact, bar.top,
            g/(2*M), g*h/(2*M), bar.reaction/(g*4*h)
        );
    }
}


TEST(contact, obliqueImpact)
{
    for (const int D : {2, 3})
    {
        for (const char* contact :
            {"", "friction 0.3; damping 0.1;", "stiffness 4;"})
        {
            run r(D, contact);
            const motionOf before(r.mesh, *r.solver);
            const double energy = total(r.solver->energies());
            double worst = 0;
            for (int k = 0; k < 400; ++k)
            {
                r.solver->advance(0.01*k, 0.01);
                worst = std::max(worst, std::fabs(total(r.solver->energies())/energy - 1));
            }
            const motionOf after(r.mesh, *r.solver);
            const motionOf a(r.mesh, *r.solver, 0);
            fmt::print
            (
                "{} {}: energy {:.2g} momentum {:.2g} {:.2g} spin {:.2g} of {:.3g} loss {:.3g} of {:.3g}, v {} {} of one\n",
                D, contact, worst, after.momentum.x - before.momentum.x,
                after.momentum.y - before.momentum.y,
                after.spin - before.spin, before.spin,
                r.solver->energies().contactLoss, energy, a.velocity().x, a.velocity().y
            );
        }
    }
}


TEST(contact, blockSlidesToAStop)
{
    for (double mu : {0.2, 0.5})
    {
        const double g = 0.01, h = 1.0/16, v = 0.05;
        solidMesh mesh;
        addBlock(mesh, block(2, 32, 8, 0, h), vector{0, 0, 0}, "bar");
        contactWalls walls;
        addWall(walls, 2, vector{2, 0, 0}, {0, 1, 0}, {-1, 0, 0}, h, 60);
        solidState s;
        s.U.assign(mesh.size(), vector{v, 0, 0});
        s.positions = mesh.points;
        for (auto& x : s.positions) x.y -= g*0.5*h/(2*3*1.2);
        const auto solver = elasticSolver::make
        (
            "cpu", mesh,
            read
            (
                mesh, fmt::format("bar {{ rho 1; E 3; dashpot 0.05; }} contact {{ damping 0.1; friction {}; }}", mu), {0, -g, 0}
            ),
            s, walls
        );
        const double x0 = motionOf(mesh, *solver).centre.x;
        double t = 0, last = 0;
        for (int k = 0; k < 3000; ++k)
        {
            solver->advance(t, 0.02); t += 0.02;
            if (motionOf(mesh, *solver).velocity().x > 1e-2*v) last = t;
        }
        const double x = motionOf(mesh, *solver).centre.x;
        fmt::print("mu {} distance {} of exact; time {} of {} loss {} of {} creep {}\n", mu, (x - x0)/(v*v/(2*mu*g)), last, v/(mu*g), solver->energies().contactLoss, 0.5*v*v*motionOf(mesh,*solver).mass, motionOf(mesh, *solver).velocity().x/v);
    }
}


TEST(contact, fastImpact)
{
    for (int D : {2, 3})
    for (double v : {0.1, 0.2, 0.3, 0.6})
    for (const char* more : {"", "subSteps 20;"})
    {
        solidMesh mesh;
        addBlock(mesh, block(D, 2, 12, 12, 0.1), vector{0, 0, 0}, "plate");
        addBlock(mesh, block(D, 4, 4, 4, 0.09), vector{-0.5, 0.4, D == 2 ? 0 : 0.4}, "ball");
        solidState s;
        for (int k : mesh.solid) s.U.push_back(k ? vector{v, 0, 0} : vector{0, 0, 0});
        const auto solver = elasticSolver::make
        (
            "cpu", mesh,
            read
            (
                mesh, std::string("plate { rho 1; E 1; } ball { rho 2; E 2; } contact { }") + more, {}
            ),
            s
        );
        double deepest = 1;
        const double e0 = total(solver->energies());
        double e = 0;
        for (int k = 0; k < 400; ++k)
        {
            solver->advance(0.02*k, 0.02);
            const hostSolid now = solver->download();
            double front = 1e9, tip = -1e9;
            for (size_t i = 0; i < mesh.size(); ++i)
            {
                if (mesh.solid[i] == 0 && mesh.points[i].x < 0.01 && mesh.points[i].y > 0.35 && mesh.points[i].y < 0.85 && (D == 2 || (mesh.points[i].z > 0.35 && mesh.points[i].z < 0.85))) front = std::min(front, now.positions[i].x);
                if (mesh.solid[i] == 1) tip = std::max(tip, now.positions[i].x);
            }
            deepest = std::min(deepest, front - tip);
            e = std::max(e, std::fabs(total(solver->energies())/e0 - 1));
        }
        fmt::print("D {} v {} {}: deepest {} energy {} vball {} vplate {}\n", D, v, more, deepest, e, motionOf(mesh, *solver, 1).velocity().x, motionOf(mesh, *solver, 0).velocity().x);
    }
}


TEST(contact, movingWallThrowsABar)
{
    const int cells = 64;
    const double h = 1.0/cells, v = 1e-3;
    solidMesh mesh;
    addBlock(mesh, block(2, cells, 4, 0, h, 0, true), vector{}, "bar");
    const dictionary d = dictionary::fromString(fmt::format("type translation; velocity ({} 0 0);", v));
    const auto motion = wallMotion::make(d);
    contactWalls walls;
    addWall(walls, 2, vector{-1e-4, 0, 0}, {1, 0, 0}, {0, 1, 0}, h, 8);
    walls.motions[0] = motion.get();
    const auto solver = elasticSolver::make
    (
        "cpu", mesh, read(mesh, "bar { rho 1; E 1; } contact { friction 0.5; }", {}), {}, walls
    );
    march(*solver, 3000, 0.001);
    const solidEnergies e = solver->energies();
    fmt::print("v {} driven {} kin {} total {}\n", motionOf(mesh, *solver).velocity().x/v, e.driven, e.kinetic, total(e));
}
