#include "lattice.H"

#include "functionObjects/internalEnergy.H"

using namespace gpuFsi;

TEST(internalEnergy, equalsClosedForms)
{
    // Linear, P = a + c^2 rho: e = c^2 (ln(rho/rho0) + rho0/rho - 1)
    const std::vector<double> delta{0, 0.01, -0.3, 1.5, 1e-7};
    const auto linear =
        internalEnergy(delta, 2, [](double rho) { return 5 + 3*rho; });
    // Tait, P = B ((rho/rho0)^7 - 1):
    // e = B/rho0 (s^6/6 + 1/s - 7/6), s = rho/rho0
    const auto tait = internalEnergy
    (
        delta, 2, [](double rho) { return 4*(std::pow(rho/2, 7) - 1); }
    );
    for (int i = 0; i < 4; ++i)
    {
        const double s = 1 + delta[i]/2;
        EXPECT_NEAR(linear[i], 3*(std::log(s) + 1/s - 1), 1e-11);
        EXPECT_NEAR(tait[i], 2*(std::pow(s, 6)/6 + 1/s - 7.0/6), 1e-11);
    }
    // Small: c^2/2 (deltaRho/rho0)^2
    EXPECT_NEAR(linear[4], 1.5*0.25e-14, 1e-20);
}


TEST(budgets, ofAUniformStateByHand)
{
    testRun run;
    run.info.gravity = {0, -10, 0};
    hostState state = lattice(10, 3, 0);             // mass 2, volume 1
    for (std::size_t i = 0; i < state.fluid.size(); ++i)
    {
        state.fluid.U[i] = {1, 2, -2};
    }
    state.walls.positions = {{0, 0, 0}, {0, 0, 0}};
    state.walls.U = {{0, 0, 0}, {0, 0, 0}};
    state.walls.deltaRho = {0, 1};
    state.walls.mass = {0.1, 0.15};
    state.area = {1, 1};                             // volumes 1/20
    state.volume = 1.1;

    const dictionary dict =
        dictionary::fromString("functions { b { type budgets; } }");
    functionObjectList list(dict, run.info);
    list.start(state, run.info);

    // Then compressed to twice the density, slower, and lifted
    for (std::size_t i = 0; i < state.fluid.size(); ++i)
    {
        state.fluid.U[i] = {1, 0, 0};
        state.fluid.deltaRho[i] = 2;
        state.fluid.positions[i].y += 0.25;
    }
    run.step(1);
    list.execute(state, run.info);
    EXPECT_TRUE(dict.unread().empty());

    const auto rows = run.rows("b/0/budgets.dat");
    ASSERT_EQ(rows.size(), 2u);
    const double e = 3*(std::log(2.0) + 0.5 - 1);
    const std::vector<double> first
    {
        0, 2, 0.25, 1, 1.1, 1.1, 2, 4, -4, 9, 0, 10,
        0.5, 0.5, 0.5, 0, 0, 0, 0, 0, 0
    };
    const std::vector<double> second
    {
        0.1, 2, 0.25, 0.5, 0.6, 1.1, 2, 0, 0, 1, 2*e, 15,
        0.5, 0.75, 0.5, 0, 0.6/1.1 - 1, 0, -4, 4, 2*e + 16 - 19
    };
    ASSERT_EQ(rows[0].size(), first.size());
    for (std::size_t i = 0; i < first.size(); ++i)
    {
        EXPECT_NEAR(rows[0][i], first[i], 1e-9) << i;
        EXPECT_NEAR(rows[1][i], second[i], 1e-9) << i;
    }
    const std::string text = run.text("b/0/budgets.dat");
    const std::string header = text.substr(0, text.find('\n'));
    EXPECT_EQ(std::count(header.begin(), header.end(), '\t'), 20);
}


//- Two kg at rest that a force pulls along: no potential but its work
TEST(budgets, bookTheWorkOfAForceThatVaries)
{
    testRun run;
    run.info.forceVaries = true;
    hostState state = lattice(4, 3, 0);              // mass 2
    const dictionary dict =
        dictionary::fromString("functions { b { type budgets; } }");
    functionObjectList list(dict, run.info);
    list.start(state, run.info);
    for (int n = 1; n <= 10; ++n)
    {
        // g = 3 t: U = 1.5 t^2, work = integral of 2 g U = 2.25 t^4
        run.step(n);
        const double t = run.info.time;
        run.info.gravity = {0, 3*t, 0};
        state.fluid.U.assign(state.fluid.size(), vector{0, 1.5*t*t, 0});
        list.execute(state, run.info);
    }
    const auto rows = run.rows("b/0/budgets.dat");
    ASSERT_EQ(rows.back().size(), 22u);
    EXPECT_EQ(rows.back()[11], 0);                   // potential
    EXPECT_NEAR(rows.back()[9], 2.25, 1e-9);         // kinetic
    EXPECT_NEAR(rows.back()[21], 2.25, 0.025);       // work, trapezoidal
    EXPECT_NEAR(rows.back()[20], 2.25 - rows.back()[21], 1e-9);
}
