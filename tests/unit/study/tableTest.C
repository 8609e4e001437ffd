#include "scratch.H"
#include "study/comparison.H"

#include <cmath>

using namespace gpuFsi;


TEST(textTable, readsQuotesAndComments)
{
    const scratch s;
    const textTable t = textTable::fromCsv
    (
        s.write("a.csv", "# said\na,\"b, \"\"c\"\"\"\n\n1,\"x,y\"\r\n2,z\n")
    );
    ASSERT_EQ(t.size(), 2u);
    EXPECT_EQ(t.number(0, "a"), 1);
    EXPECT_EQ(t.text(0, "b, \"c\""), "x,y");
    EXPECT_EQ(t.text(1, "b, \"c\""), "z");
    EXPECT_EQ(csvText("b, \"c\""), "\"b, \"\"c\"\"\"");
    EXPECT_EQ(csvText("plain"), "plain");
}


TEST(textTable, namesWhatIsWrong)
{
    const scratch s;
    const auto file = s.write("a.csv", "curve,error\nx,1\ny\n");
    expectIn("line 3", messageOf([&] { textTable::fromCsv(file); }));
    const auto good = s.write("b.csv", "curve,error\nx,one\n");
    const textTable t = textTable::fromCsv(good);
    expectIn("'one'", messageOf([&] { t.number(0, "error"); }));
    expectIn("seconds", messageOf([&] { t.number(0, "seconds"); }));
    expectIn("missing.csv", messageOf([&]
    {
        textTable::fromCsv(s.path/"missing.csv");
    }));
}


TEST(comparison, readsWhatAStudyWrites)
{
    curve c{"radial, \"single\"", false, {}};
    for (const double h : {0.5, 0.25})
    {
        curvePoint p;
        p.resolution = std::to_string(h);
        p.size = h;
        p.error = h*h;
        p.seconds = {1/h, 0.9/h, 1.2/h};
        p.repeats = 3;
        p.run.h = h;
        p.run.deltaT = h/10;
        p.run.ranks = 2;
        p.run.device = "cpu, 2 threads";
        p.run.machine = "a, b";
        p.run.particleSteps = 1e10;
        c.points.push_back(p);
    }
    const scratch s;
    s.write("errorVsRunTime.csv", csvOf({c}));
    const auto back = readCurves(s.path);
    ASSERT_EQ(back.size(), 1u);
    EXPECT_TRUE(back[0].compared);
    EXPECT_EQ(back[0].name, c.name);
    ASSERT_EQ(back[0].points.size(), 2u);
    const curvePoint& p = back[0].points[1];
    EXPECT_EQ(p.error, 0.0625);
    EXPECT_EQ(p.seconds.least, 3.6);
    EXPECT_EQ(p.seconds.greatest, 4.8);
    EXPECT_EQ(p.repeats, 3u);
    EXPECT_EQ(p.run.ranks, 2);
    EXPECT_EQ(p.run.device, "cpu, 2 threads");
    EXPECT_EQ(p.run.machine, "a, b");
    EXPECT_NEAR(p.order, 2, 1e-12);
}


TEST(comparison, takesAPeersShortTable)
{
    const scratch s;
    const auto file =
        s.write("p.csv", "curve,error,seconds\nA,0.1,2\nB,0.2,1\nA,0.05,8\n");
    const auto curves = readCurves(file);
    ASSERT_EQ(curves.size(), 2u);
    EXPECT_EQ(curves[0].points.size(), 2u);
    EXPECT_NEAR(curves[0].points[1].slope, 2, 1e-12);
    EXPECT_EQ(curves[0].points[0].run.machine, "machine not named");
    expectIn("no /nowhere", messageOf([&] { readCurves("/nowhere"); }));
}


TEST(comparison, leavesOutWhatLogarithmsCannotShow)
{
    const scratch s;
    const auto file = s.write
    (
        "q.csv",
        "curve,error,seconds\nB,0,2\nA,0.1,2\nA,-1,3\nA,0.01,0\nA,0.02,4\n"
    );
    testing::internal::CaptureStderr();
    const auto curves = readCurves(file);
    expectIn("Row 3 of", testing::internal::GetCapturedStderr());
    ASSERT_EQ(curves.size(), 1u);
    ASSERT_EQ(curves[0].points.size(), 2u);
    EXPECT_EQ(curves[0].points[1].error, 0.02);
}


TEST(runRecord, roundTrip)
{
    runRecord r;
    r.error = 0.1;
    r.loopSeconds = 2.5;
    r.totalSeconds = 3;
    r.wallSeconds = 4;
    r.particleSteps = 123456789;
    r.h = 0.25;
    r.deltaT = 0.02;
    r.time = 1.2;
    r.ranks = 4;
    r.device = "cpu, 2 threads";
    r.precision = "double";
    r.scheme = "areaWeights radial";
    r.machine = "a machine";
    const scratch s;
    writeRecords(s.path/"runs.dat", {r, r});
    const auto back = readRecords(s.path/"runs.dat");
    ASSERT_EQ(back.size(), 2u);
    EXPECT_EQ(back[1].error, r.error);
    EXPECT_EQ(back[1].wallSeconds, r.wallSeconds);
    EXPECT_EQ(back[1].particleSteps, r.particleSteps);
    EXPECT_EQ(back[1].machine, r.machine);
    EXPECT_EQ(back[1].ranks, 4);
    EXPECT_EQ(back[1].time, 1.2);
}


TEST(runRecord, takesTheNormAskedFor)
{
    const scratch s;
    const auto file = s.write
    (
        "cost.dat",
        "# Time\tL1\tL2\tLinf\trelL2\trelLinf\tloopSeconds\ttotalSeconds\t"
        "particleSteps\th\tdeltaT\tranks\tdevice\tprecision\tscheme\n"
        "7\t1\t2\t4\t0.5\t0.1\t3\t5\t60\t0.1\t0.01\t1\td\tsingle\ts\n"
    );
    EXPECT_EQ(recordOfCost(file, "L1").error, 1);
    EXPECT_EQ(recordOfCost(file, "relL2").error, 0.5);
    // The largest exact value is Linf/relLinf = 40
    EXPECT_DOUBLE_EQ(recordOfCost(file, "rmsByMax").error, 2/40.0);
    EXPECT_EQ(recordOfCost(file, "L1").totalSeconds, 5);
    EXPECT_EQ(recordOfCost(file, "L1").time, 7);
}


TEST(runRecord, readsALog)
{
    const scratch s;
    const auto file = s.write
    (
        "log",
        "Device      : cpu, 2 threads, double precision\n"
        "Particles   : 10 fluid, 4 wall, 0 solid, spacing 0.25, 2-D\n"
        "Schemes     : areaWeights radial, faces linear\n"
        "deltaT = 0.01\nTime = 1\ndeltaT = 0.02\n"
        "Particle-steps = 1.5e+06  loop = 0.75 s  total = 2.125 s  "
        "ranks = 4  rate = 2 MIPPS\n"
        "ExecutionTime = 3 s  ClockTime = 2 s\n"
    );
    const runRecord r = recordOfLog(file);
    EXPECT_EQ(r.device, "cpu, 2 threads");
    EXPECT_EQ(r.precision, "double");
    EXPECT_EQ(r.scheme, "areaWeights radial, faces linear");
    EXPECT_EQ(r.h, 0.25);
    EXPECT_EQ(r.deltaT, 0.02);
    EXPECT_EQ(r.time, 1);
    EXPECT_EQ(r.particleSteps, 1.5e6);
    EXPECT_EQ(r.loopSeconds, 0.75);
    EXPECT_EQ(r.totalSeconds, 2.125);
    EXPECT_EQ(r.ranks, 4);
    const auto other = s.write("log2", "nothing\n");
    expectIn("Particle-steps", messageOf([&] { recordOfLog(other); }));
}
