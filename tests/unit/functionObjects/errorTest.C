#include "lattice.H"

#include "exact/exactSolution.H"
#include "functionObjects/errorNorms.H"

#include <algorithm>
#include <limits>
#include <omp.h>

using namespace gpuFsi;

namespace
{

std::vector<double> measure
(
    testRun& run,
    const hostState& state,
    const std::string& keys
)
{
    static int number = 0;
    const std::string name = "e" + std::to_string(number++);
    const dictionary dict = dictionary::fromString
    (
        "functions { " + name + " { type error; log no; " + keys + " } }"
    );
    functionObjectList list(dict, run.info);
    list.start(state, run.info);
    EXPECT_TRUE(dict.unread().empty());
    return run.rows(name + "/" + run.info.startTime + "/error.dat").at(0);
}

} // namespace


TEST(errorNorms, equalAHandCalculation)
{
    // e = 1, 3, 2 with volumes 1, 2, 5
    const norms n = normsOf({1, 3, 2}, {1, 2, 5});
    EXPECT_DOUBLE_EQ(n.L1, 17.0/8);
    EXPECT_DOUBLE_EQ(n.L2, std::sqrt(39.0/8));
    EXPECT_EQ(n.Linf, 3);

    const double nan = std::numeric_limits<double>::quiet_NaN();
    const norms m = normsOf({1, nan, 2}, {1, 1, 1});
    EXPECT_TRUE(std::isnan(m.L1) && std::isnan(m.L2) && std::isnan(m.Linf));

    EXPECT_EQ
    (
        distances({1, 2, 3, 0, 0, 0}, {1, 5, 7, 0, 0, 2}, 3),
        (std::vector<double>{5, 2})
    );
}


TEST(error, ofTwoParticlesByHand)
{
    testRun run;
    hostState state = lattice(2, 3, 0);
    state.fluid.positions = {{1, 0, 0}, {0, 2, 0}};
    state.fluid.deltaRho = {0.5, -0.5};
    state.fluid.mass = {5, 6};              // volumes 2, 4
    state.fluid.U = {{1, 0, 0}, {0, 3, 0}};
    run.info.loopSeconds = 12.5;
    run.step(3);

    // Reference x + t: 1.3, 0.3: errors 0.8, 0.8
    const auto a =
        measure(run, state, "field deltaRho; reference \"x + t\";");
    ASSERT_EQ(a.size(), 8u);
    EXPECT_NEAR(a[0], 0.3, 1e-12);
    EXPECT_NEAR(a[1], 0.8, 1e-8);
    EXPECT_NEAR(a[2], 0.8, 1e-8);
    EXPECT_NEAR(a[3], 0.8, 1e-8);
    EXPECT_NEAR(a[4], 0.8*6/(2*1.3 + 4*0.3), 1e-8);
    EXPECT_NEAR
    (
        a[5], 0.8*std::sqrt(6/(2*1.69 + 4*0.09)), 1e-8
    );
    EXPECT_NEAR(a[6], 0.8/1.3, 1e-8);
    EXPECT_EQ(a[7], 12.5);

    // rho and p: relative to the perturbation
    const auto b =
        measure(run, state, "field rho; reference \"2 + x + t\";");
    const auto c =
        measure(run, state, "field p; reference \"11 + 3*(x + t)\";");
    for (int i = 4; i < 7; ++i)
    {
        EXPECT_NEAR(b[i], a[i], 1e-8);
        EXPECT_NEAR(c[i], a[i], 1e-8);
    }
    EXPECT_NEAR(c[1], 3*a[1], 1e-8);

    // U against (x 0 0): errors 0, 3
    const auto d = measure
    (
        run, state, "field U; reference (\"x\" \"0\" \"0\");"
    );
    EXPECT_NEAR(d[1], 12.0/6, 1e-8);
    EXPECT_NEAR(d[2], std::sqrt(36.0/6), 1e-8);
    EXPECT_NEAR(d[3], 3, 1e-8);
    EXPECT_NEAR(d[6], 3, 1e-8);

    // Only the first lies within 1.5 of (0 1 0) shifted
    const auto e = measure
    (
        run,
        state,
        "field deltaRho; reference \"x\"; region \"r > 1.2\";"
        " centre (0 1 0);"
    );
    EXPECT_NEAR(e[1], 0.5, 1e-8);
    EXPECT_NEAR(e[4], 0.5, 1e-8);
}


TEST(error, wallsCountOnRequest)
{
    testRun run;
    hostState state = lattice(2, 3, 0);          // 8 particles of volume 1/8
    state.walls.positions = {{0, 0, 0}};
    state.walls.U = {{0, 0, 0}};
    state.walls.deltaRho = {9};
    state.walls.mass = {11};
    state.area = {2};                            // volume 2 h/2 = 1/2
    const std::string keys = "field deltaRho; reference 0;";
    EXPECT_EQ(measure(run, state, keys)[1], 0);
    EXPECT_NEAR
    (
        measure(run, state, keys + " includeWalls yes;")[1], 9*0.5/1.5, 1e-8
    );
}


TEST(error, ofTheExactSolutionItselfVanishes)
{
    testRun run;
    run.info.mu = 2;
    run.step(7);
    hostState state = lattice(6, 3, 0.2);
    fluidConstants fluid;
    fluid.rho0 = 2;
    fluid.c = run.info.c;
    fluid.nu = 1;
    const dictionary parameters =
        dictionary::fromString("centre (0.5 0.5 0.5); width 0.1;");
    const auto exact =
        exactSolution::make("acousticPulse", parameters, fluid);
    const auto& points = state.fluid.positions;
    state.fluid.deltaRho = exact->scalar("deltaRho", points, 0.7);
    state.fluid.U = exact->vectors("U", points, 0.7);
    const std::string keys =
        "exact acousticPulse; centre (0.5 0.5 0.5); width 0.1;"
        " region \"r < 0.45\"; ";
    for (const char* field : {"deltaRho", "rho", "p", "U"})
    {
        const auto row =
            measure(run, state, keys + "field " + field + ";");
        for (int i = 1; i < 7; ++i)
        {
            EXPECT_LT(row[i], 1e-9) << field << i;
        }
    }
    const auto other = measure
    (
        run,
        state,
        "field deltaRho; exact acousticPulse;"
        "acousticPulseCoeffs { centre (0.5 0.5 0.5); width 0.1;"
        " amplitude 0.02; }"
    );
    EXPECT_NEAR(other[5], 0.5, 1e-8);
}


TEST(error, isTheSameForAnyNumberOfThreads)
{
    const hostState state = lattice(20, 3, 0.2);
    const int threads = omp_get_max_threads();
    std::string first;
    for (int n : {1, 2, 5})
    {
        omp_set_num_threads(n);
        testRun run;
        run.step(1);
        measure
        (
            run,
            state,
            "field p; exact acousticPulse; width 0.1; region \"r < 1\";"
        );
        const auto file = std::filesystem::directory_iterator
        (
            run.info.casePath/"postProcessing"
        )->path().filename().string();
        const std::string text = run.text(file + "/0/error.dat");
        first = first.empty() ? text : first;
        EXPECT_EQ(text, first);
    }
    omp_set_num_threads(threads);
}


TEST(error, fileHasOneHeaderLineAndTabs)
{
    testRun run;
    run.info.startTime = "0.6";
    const dictionary dict = dictionary::fromString
    (
        "functions { pulse { type error; field deltaRho; exact acousticPulse;"
        " log no; } }"
    );
    functionObjectList list(dict, run.info);
    const hostState state = lattice(3, 3, 0);
    list.start(state, run.info);
    run.step(1);
    list.execute(state, run.info);
    const std::string text = run.text("pulse/0.6/error.dat");
    EXPECT_EQ
    (
        text.substr(0, text.find('\n')),
        "# Time\tL1\tL2\tLinf\trelL1\trelL2\trelLinf\tloopSeconds"
    );
    EXPECT_EQ(text.find('#', 1), std::string::npos);
    EXPECT_EQ(std::count(text.begin(), text.end(), '\t'), 21);
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 3);
}


TEST(error, badEntriesAreErrors)
{
    testRun run;
    const hostState state = lattice(2, 3, 0);
    const auto message = [&](const std::string& keys)
    {
        return messageOf([&] { measure(run, state, keys); });
    };
    const std::string unknown = message("field T; reference 0;");
    expectIn("Unknown field type T", unknown);
    expectIn("deltaRho", unknown);
    expectIn("nothing to compare with", message("field rho;"));
    expectIn("hydrostatic", message("field rho;"));
    expectIn
    (
        "both exact and reference",
        message("field rho; exact hydrostatic; reference 1;")
    );
    expectIn
    (
        "three expressions", message("field U; reference (\"x\" \"y\");")
    );
    expectIn
    (
        "No particle lies inside the region",
        message("field rho; reference 0; region \"x > 5\";")
    );
    expectIn("acousticPulse", message("field rho; exact pulse;"));
}


TEST(errorCost, tiesTheLatestErrorToItsCost)
{
    testRun run;
    run.info.h = 0.25;
    run.info.ranks = 3;
    run.info.device = "cpu, 2 threads";
    run.info.precision = "double";
    run.info.scheme = "areaWeights radial";
    const dictionary dict = dictionary::fromString
    (
        "functions { e { type error; field deltaRho; reference \"3\"; } }"
    );
    functionObjectList list(dict, run.info);
    hostState state = lattice(2, 3, 0);
    list.start(state, run.info);
    run.step(4);
    run.info.loopSeconds = 2;
    run.info.particleSteps = 32;
    std::fill
    (
        state.fluid.deltaRho.begin(), state.fluid.deltaRho.end(), 2.0
    );
    list.execute(state, run.info);

    // Time goes on: the error stays that of the latest look
    run.step(5);
    run.info.loopSeconds = 7;
    run.info.particleSteps = 40;
    run.info.totalSeconds = 11;
    list.end(run.info);

    std::istringstream lines(run.text("e/0/cost.dat"));
    std::string names, values;
    std::getline(lines, names);
    std::getline(lines, values);
    EXPECT_EQ
    (
        names,
        "# Time\tL1\tL2\tLinf\trelL1\trelL2\trelLinf\tloopSeconds\t"
        "totalSeconds\tparticleSteps\tparticleStepsPerSecond\th\tdeltaT\t"
        "ranks\tdevice\tprecision\tscheme"
    );
    EXPECT_EQ
    (
        values,
        "0.4\t1.00000000e+00\t1.00000000e+00\t1.00000000e+00\t"
        "3.33333333e-01\t3.33333333e-01\t3.33333333e-01\t2.00000000e+00\t"
        "1.10000000e+01\t32\t1.60000000e+01\t0.25\t0.1\t3\t"
        "cpu, 2 threads\tdouble\tareaWeights radial"
    );
}
