// displacementProbe, forces and solidEnergy against values by hand.
#include "lattice.H"

using namespace gpuFsi;

namespace
{

//- Two solids, of two particles and of one, beside a fluid at rest
hostState twoSolids(int dimensions = 3)
{
    hostState state = lattice(4, dimensions, 0);
    solidSet& s = state.solid;
    s.reference = {{2, 0, 0}, {2, 1, 0}, {5, 0, 0.4}};
    s.positions = {{2.25, 0, 0}, {2, 1.5, -0.125}, {5, 0, 0.5}};
    s.U = {{1, 2, 3}, {4, 5, 6}, {-7, -8, -9}};
    s.pressureForce = {{1, 0, 0}, {0, 2, 0}, {0, 0, 4}};
    s.load = {{1, 0, 3}, {0.5, 2, 0}, {0, -1, 4}};    // viscous: the rest
    s.solid = {0, 0, 1};
    s.names = {"plate", "ball"};
    return state;
}

void runOnce
(
    const std::string& functions,
    const hostState& state,
    testRun& run
)
{
    const dictionary dict =
        dictionary::fromString("functions { " + functions + " }");
    functionObjectList list(dict, run.info);
    list.start(state, run.info);
    EXPECT_TRUE(dict.unread().empty());
}

void expectRow
(
    const std::vector<double>& found,
    const std::vector<double>& wanted
)
{
    ASSERT_EQ(found.size(), wanted.size());
    for (std::size_t i = 0; i < wanted.size(); ++i)
    {
        EXPECT_NEAR(found[i], wanted[i], 1e-10*(1 + std::abs(wanted[i])))
            << "column " << i;
    }
}

} // namespace


TEST(displacementProbe, takesTheNearestUnstrainedParticle)
{
    testRun run;
    runOnce
    (
        "tip { type displacementProbe; points ((2.1 0.9 0) (5 0 0)); }",
        twoSolids(), run
    );
    const auto rows = run.rows("tip/0/displacement.dat");
    ASSERT_EQ(rows.size(), 1u);
    expectRow
    (
        rows[0], {0, 0, 0.5, -0.125, 4, 5, 6, 0, 0, 0.1, -7, -8, -9}
    );
    expectIn
    (
        "# Probe 0: particle 1 at (2 1 0)", run.text("tip/0/displacement.dat")
    );
}


//- In 2-D a point's z is without meaning
TEST(displacementProbe, ignoresHeightIn2D)
{
    testRun run;
    runOnce
    (
        "tip { type displacementProbe; points ((5 0 9)); }", twoSolids(2), run
    );
    expectRow
    (
        run.rows("tip/0/displacement.dat")[0], {0, 0, 0, 0.1, -7, -8, -9}
    );
}


TEST(displacementProbe, refusesWhatIsFarFromEverySolid)
{
    testRun run;
    const std::string message = messageOf([&]
    {
        runOnce
        (
            "tip { type displacementProbe; points ((2 2 0)); }", twoSolids(),
            run
        );
    });
    expectIn("is 1 m from the nearest particle of a solid, (2 1 0)", message);
    expectIn("Choose a point of the unstrained solid", message);
}


TEST(forces, addsUpForcesAndMomentsOfEachSolid)
{
    testRun run;
    runOnce
    (
        "push { type forces; CofR (2 0 0); }", twoSolids(), run
    );
    // Arms (0.25 0 0), (0 1.5 -0.125); of the ball (3 0 0.5)
    expectRow
    (
        run.rows("push/0/plate.dat")[0],
        {
            0, 1, 2, 0, 0.5, 0, 3, 0.25, 0, 0,
            0, -0.0625 - 0.75, -0.75
        }
    );
    expectRow
    (
        run.rows("push/0/ball.dat")[0],
        {0, 0, 0, 4, 0, -1, 0, 0, -12, 0, 0.5, 0, -3}
    );
}


TEST(forces, ofOneSolidOnly)
{
    testRun run;
    runOnce("push { type forces; solids (ball); }", twoSolids(), run);
    EXPECT_EQ(run.rows("push/0/ball.dat").size(), 1u);
    EXPECT_FALSE
    (
        std::filesystem::exists(run.info.casePath/"postProcessing/push/0/"
            "plate.dat")
    );
    const std::string message = messageOf([&]
    {
        runOnce("push { type forces; solids (bell); }", twoSolids(), run);
    });
    expectIn("there is no solid 'bell'", message);
    expectIn("Valid are: plate ball", message);
}


//- What was done before the start is no work of this run
TEST(solidEnergy, closesTheLedger)
{
    testRun run;
    hostState state = twoSolids();
    solidEnergies& s = state.solid.energies;
    s.kinetic = 5;
    s.elastic = 2;
    s.fluid = 10;
    const dictionary dict =
        dictionary::fromString("functions { e { type solidEnergy; } }");
    functionObjectList list(dict, run.info);
    list.start(state, run.info);
    EXPECT_TRUE(dict.unread().empty());

    s.kinetic = 6;
    s.elastic = 4;
    s.dissipated = 0.5;
    s.gravity = 1;
    s.loads = 2;
    s.driven = 0.25;
    s.fluid = 10.25;
    s.contact = 1.5;
    s.contactLoss = 0.125;
    for (std::size_t i = 0; i < state.fluid.size(); ++i)
    {
        state.fluid.U[i] = {0, 3, 0};          // mass 2
        state.fluid.deltaRho[i] = 2;           // P = 3 rho + 5
    }
    run.step(1);
    list.execute(state, run.info);
    const auto rows = run.rows("e/0/solidEnergy.dat");
    ASSERT_EQ(rows.size(), 2u);
    expectRow(rows[0], {0, 5, 2, 0, 0, 0, 0, 10, 0, 0, 0, 7, 0, 0});
    const double internal = 2*3*(std::log(2.0) + 0.5 - 1);
    expectRow
    (
        rows[1],
        {
            0.1, 6, 4, 0.5, 1, 2, 0.25, 10.25, 0, 9, internal,
            6 + 4 + 0.5 - 3.25 + 9 + internal, 1.5, 0.125
        }
    );
}


TEST(functionsOfSolids, refuseACaseWithout)
{
    const hostState fluid = lattice(4, 3, 0);
    for (const char* type :
        {"forces", "solidEnergy", "displacementProbe; points ((0 0 0))"})
    {
        testRun run;
        const std::string message = messageOf([&]
        {
            runOnce(std::string("f { type ") + type + "; }", fluid, run);
        });
        expectIn("is about solids, but there are none", message);
        expectIn("Seed solids", message);
    }
}


//- Every column by hand; the residual is what no term has
TEST(energyLedger, sharesOutTheEnergy)
{
    testRun run;
    hostState state = twoSolids();
    state.works.kept = true;
    state.solid.mass = {1, 1, 1};
    const dictionary dict =
        dictionary::fromString("functions { e { type energyLedger; } }");
    functionObjectList list(dict, run.info);
    EXPECT_TRUE(list.needsLedger());
    list.start(state, run.info);
    EXPECT_TRUE(dict.unread().empty());

    solidEnergies& s = state.solid.energies;
    s.kinetic = 4;
    s.elastic = 3;
    s.dissipated = 0.5;
    s.gravity = 1;
    s.loads = 2;
    s.driven = 0.25;
    s.fluid = 6;
    fluidWorks& f = state.works;
    f.boundary = 3.5;
    f.viscousLoss = 0.125;
    f.momentumLoss = 0.25;
    f.densityLoss = 0.5;
    f.shifting = 0.0625;
    f.body = 2;
    f.staggering = 0.1;
    f.walls = 10;
    f.couplingLag = 0.75;
    f.faceForce = {1, 2, 3};
    for (vector& u : state.fluid.U)
    {
        u = {0, 3, 0};                     // mass 2
    }
    run.step(1);
    list.execute(state, run.info);
    const auto rows = run.rows("e/0/energyLedger.dat");
    ASSERT_EQ(rows.size(), 2u);
    const double works = 3 + 10 + 0.25 + 2 + 0.0625 + 0.1;
    const double losses = 0.125 + 0.25 + 0.5 + 0.5 + 0.75;
    const double residual = 9 + 4 + 3 - (works - losses);
    const double surfaces = 10 - 6 - 0.75;
    expectRow
    (
        rows[1],
        {
            0.1, 9, 0, 4, 3, 0.125, 0.25, 0.5, 0.5, 0.75, 0.0625, 0.1, 3,
            10, 0.25, 2, residual, 10, residual/10,
            3.5, surfaces, 3.5 - surfaces, 1, 2, 3,
            1.5, 1, 7, -2, 6 - 1, 0
        }
    );
}


//- Nothing else asks for the ledger
TEST(energyLedger, isNotKeptForOthers)
{
    testRun run;
    const dictionary dict =
        dictionary::fromString("functions { e { type solidEnergy; } }");
    EXPECT_FALSE(functionObjectList(dict, run.info).needsLedger());
}
