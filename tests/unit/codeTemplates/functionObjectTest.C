#include "../functionObjects/lattice.H"

using namespace gpuFsi;

TEST(functionObjectTemplate, writesTheGreatestSpeedAndItsPlace)
{
    testRun run;
    hostState state = lattice(4, 3, 0.2);
    state.fluid.U[10] = {0, 0, -5};
    state.fluid.U[20] = {3, 0, 4.5};
    const dictionary dict = dictionary::fromString
    (
        "functions { speed { type greatestSpeed; } }"
    );
    functionObjectList list(dict, run.info);
    list.start(state, run.info);
    run.step(1);
    list.execute(state, run.info);
    EXPECT_TRUE(dict.unread().empty());

    const auto rows = run.rows("speed/0/greatestSpeed.dat");
    ASSERT_EQ(rows.size(), 2u);
    const vector p = state.fluid.positions[20];
    const std::vector<double> expected
    {
        run.info.time, std::sqrt(9 + 20.25), p.x, p.y, p.z
    };
    ASSERT_EQ(rows[1].size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i)
    {
        EXPECT_NEAR(rows[1][i], expected[i], 1e-8);
    }
}


TEST(functionObjectTemplate, leavesOutWhatIsNotAbove)
{
    testRun run;
    hostState state = lattice(4, 3, 0.2);
    state.fluid.U[10] = {0, 0, -5};
    const dictionary dict = dictionary::fromString
    (
        "functions { speed { type greatestSpeed; above 6; } }"
    );
    functionObjectList list(dict, run.info);
    list.start(state, run.info);
    state.fluid.U[10] = {0, 8, 0};
    run.step(1);
    list.execute(state, run.info);

    const auto rows = run.rows("speed/0/greatestSpeed.dat");
    ASSERT_EQ(rows.size(), 1u);
    EXPECT_NEAR(rows[0][1], 8, 1e-8);
}
