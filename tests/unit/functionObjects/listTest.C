#include "lattice.H"

using namespace gpuFsi;

namespace
{

dictionary controlDict(const std::string& functions)
{
    return dictionary::fromString
    (
        "functions { " + functions + " }", "controlDict"
    );
}

//- Steps at which `due` says yes, of steps 1 to n
std::vector<long> dueSteps
(
    testRun& run,
    const std::string& control,
    int n,
    double deltaT
)
{
    const dictionary dict = controlDict
    (
        "b { type budgets; log no; " + control + " }"
    );
    const hostState state = lattice(2, 3, 0);
    run.info.deltaT = deltaT;
    run.step(0);
    functionObjectList list(dict, run.info);
    list.start(state, run.info);
    std::vector<long> steps;
    for (int i = 1; i <= n; ++i)
    {
        run.step(i);
        run.info.writeTime = i == 4;
        if (list.due(run.info))
        {
            steps.push_back(i);
            list.execute(state, run.info);
            EXPECT_FALSE(control.find("runTime") != std::string::npos
                && list.due(run.info));
        }
    }
    return steps;
}

using steps = std::vector<long>;

} // namespace


TEST(functionObjectList, actsWhenItsControlSays)
{
    testRun run;
    EXPECT_EQ(dueSteps(run, "", 3, 0.1), (steps{1, 2, 3}));
    EXPECT_EQ
    (
        dueSteps(run, "writeControl timeStep; writeInterval 3;", 9, 0.1),
        (steps{3, 6, 9})
    );
    EXPECT_EQ
    (
        dueSteps(run, "writeControl runTime; writeInterval 0.2;", 7, 0.1),
        (steps{2, 4, 6})
    );
    // Not a multiple of the step: the nearest step
    EXPECT_EQ
    (
        dueSteps(run, "writeControl runTime; writeInterval 0.25;", 10, 0.1),
        (steps{2, 5, 7, 10})
    );
    EXPECT_EQ(dueSteps(run, "writeControl writeTime;", 9, 0.1), (steps{4}));
    EXPECT_EQ(dueSteps(run, "writeControl none;", 9, 0.1), (steps{}));
    EXPECT_EQ
    (
        dueSteps(run, "executeControl timeStep; executeInterval 4;", 9, 0.1),
        (steps{4, 8})
    );
    EXPECT_EQ
    (
        dueSteps(run, "timeStart 0.3; timeEnd 0.5;", 9, 0.1),
        (steps{3, 4, 5})
    );
}


TEST(functionObjectList, writesTheStartUnlessToldNot)
{
    testRun run;
    const dictionary dict = controlDict
    (
        "with { type budgets; log no; }"
        "without { type budgets; log no; executeAtStart no; }"
    );
    functionObjectList list(dict, run.info);
    EXPECT_EQ(list.size(), 2u);
    const hostState state = lattice(2, 3, 0);
    list.start(state, run.info);
    run.step(1);
    list.execute(state, run.info);
    EXPECT_EQ(run.rows("with/0/budgets.dat").size(), 2u);
    EXPECT_EQ(run.rows("without/0/budgets.dat").size(), 1u);
}


TEST(functionObjectList, neverOverwritesAnOldFile)
{
    testRun run;
    const dictionary dict = controlDict("b { type budgets; log no; }");
    const hostState state = lattice(2, 3, 0);
    std::string first;
    for (int i = 0; i < 3; ++i)
    {
        functionObjectList list(dict, run.info);
        list.start(state, run.info);
        first = first.empty() ? run.text("b/0/budgets.dat") : first;
    }
    EXPECT_EQ(run.text("b/0/budgets.dat"), first);
    EXPECT_EQ(run.text("b/0/budgets_0.dat"), first);
    EXPECT_EQ(run.text("b/0/budgets_0_1.dat"), first);
}


TEST(functionObjectList, whatIsSwitchedOffIsNotMadeNorReported)
{
    testRun run;
    const std::string text =
        "b { type nonsense; enabled no; deep { key 1; } libs (\"x.so\"); }";
    const dictionary dict = controlDict(text);
    EXPECT_TRUE(functionObjectList(dict, run.info).empty());
    EXPECT_TRUE(dict.unread().empty());

    const dictionary other = controlDict("b { type nonsense; }");
    EXPECT_TRUE(functionObjectList(other, run.info, false).empty());
    EXPECT_TRUE(other.unread().empty());

    const dictionary none = dictionary::fromString("deltaT 1;");
    EXPECT_TRUE(functionObjectList(none, run.info).empty());
}


TEST(functionObjectList, acceptsOpenFoamsKeysAndReportsOthers)
{
    testRun run;
    const dictionary dict = controlDict
    (
        "b { type budgets; libs (\"libfieldFunctionObjects.so\"); log no;"
        " enabled yes; executeControl writeTime; writeControl writeTime;"
        " writeIntervall 2; }"
    );
    functionObjectList list(dict, run.info);
    const auto unread = dict.unread();
    ASSERT_EQ(unread.size(), 1u);
    expectIn("writeIntervall", unread[0]);
    expectIn("writeInterval", unread[0]);
}


TEST(functionObjectList, badEntriesAreErrors)
{
    testRun run;
    const auto message = [&](const std::string& text)
    {
        const dictionary dict = controlDict(text);
        return messageOf([&] { functionObjectList(dict, run.info); });
    };
    const std::string unknown = message("b { type budget; }");
    expectIn("Unknown function object type budget", unknown);
    for (const char* type : {"budgets", "error", "probes", "sets"})
    {
        expectIn(type, unknown);
    }
    expectIn("controlDict", message("b { writeControl none; }"));
    expectIn("b is not a sub-dictionary", message("b 1;"));
    expectIn("everyNow", message("b { type budgets; writeControl everyNow; }"));
    expectIn
    (
        "whole number of steps",
        message("b { type budgets; writeInterval 0.5; }")
    );
    expectIn
    (
        "must be 1 with writeControl writeTime",
        message("b { type budgets; writeControl writeTime; writeInterval 2; }")
    );
    expectIn
    (
        "timeEnd lies before timeStart",
        message("b { type budgets; timeStart 2; timeEnd 1; }")
    );
}
