// checkParticles on good folders and on bad ones.
#include "systemCase.H"

#include <gtest/gtest.h>

namespace
{

constexpr const char* positions = "0/lagrangian/fluid/positions";

//- 16 x 4 particles, rows at 1/32, 3/32, ...; ascii
systemCase seeded()
{
    systemCase c = systemCase::piston();
    c.set("system/controlDict", "writeFormat", "ascii");
    c.set("system/controlDict", "deltaT", "0.005");
    c.seed();
    return c;
}

outcome check(const systemCase& c, const std::vector<std::string>& options = {})
{
    const fileTree before = c.tree();
    const outcome o = c.run(app::checkParticles, options);
    EXPECT_EQ(difference(c.tree(), before), "");
    return o;
}

void expectFailed
(
    const systemCase& c,
    const std::string& what,
    int checks = 1
)
{
    const outcome o = check(c);
    EXPECT_EQ(o.code, 1);
    EXPECT_TRUE(o.says(" ***" + what)) << o.out << o.err;
    EXPECT_TRUE
    (
        o.says
        (
            "Failed " + std::to_string(checks)
          + (checks == 1 ? " check.\n" : " checks.\n")
        )
    ) << o.out;
    EXPECT_FALSE(o.says("Particles OK."));
}

} // namespace


TEST(checkParticles, soundOnes)
{
    const systemCase c = seeded();
    const outcome o = check(c);
    EXPECT_EQ(o.code, 0) << o.out << o.err;
    for (const char* line :
        {
            "Time = 0", "64 fluid, 8 wall, 0 solid", "min = 0.500",
            "max = 1.000 h", "0.95 to 1.05 h           56   87.5 %",
            "No particles overlap OK.", "No holes OK.",
            "deltaT 0.005 within the limits OK.", "\nParticles OK.\n", "End"
        })
    {
        EXPECT_TRUE(o.says(line)) << line << '\n' << o.out;
    }
}


TEST(checkParticles, timesOfARun)
{
    const systemCase c = seeded();
    EXPECT_EQ(c.run(app::gpuFsiFoam).code, 0);
    const outcome all = check(c);
    EXPECT_EQ(all.code, 0) << all.out;
    EXPECT_TRUE(all.says("Time = 0\n"));
    EXPECT_TRUE(all.says("Time = 0.4\n"));
    const outcome last = check(c, {"-latestTime"});
    EXPECT_FALSE(last.says("Time = 0\n"));
    EXPECT_TRUE(last.says("Time = 0.4\n"));
}


//- In a period of four spacings the place that it leaves is a hole, too
TEST(checkParticles, overlap)
{
    systemCase c = seeded();
    c.replace(positions, "(0.46875 0.09375 0)", "(0.5313 0.097 0)");
    expectFailed(c, "2 particles overlap (nearer than 0.2 h), the nearest", 2);
}


TEST(checkParticles, outside)
{
    systemCase c = seeded();
    c.replace(positions, "(0.46875 0.09375 0)", "(5 0.09375 0)");
    expectFailed
    (
        c,
        "1 particles outside the domain, the first fluid 23 at (5 0.09375 0)",
        2
    );
}


//- Four particles go to stand between others
TEST(checkParticles, hole)
{
    systemCase c = seeded();
    c.replace(positions, "(0.46875 0.09375 0)", "(0.125 0.125 0)");
    c.replace(positions, "(0.53125 0.09375 0)", "(0.25 0.125 0)");
    c.replace(positions, "(0.46875 0.15625 0)", "(0.75 0.125 0)");
    c.replace(positions, "(0.53125 0.15625 0)", "(0.875 0.125 0)");
    const outcome o = check(c);
    EXPECT_EQ(o.code, 1);
    EXPECT_TRUE(o.says("particles beside a hole, the first fluid"))
        << o.out;
    EXPECT_TRUE(o.says("No particles overlap OK."));
}


TEST(checkParticles, stepTooLong)
{
    systemCase c = seeded();
    c.set("system/controlDict", "deltaT", "0.5");
    expectFailed
    (
        c, "deltaT 0.5 of system/controlDict is beyond the limit (acoustic)"
    );
    c.add("system/controlDict", "adjustTimeStep yes;");
    EXPECT_EQ(check(c).code, 0);
}


TEST(checkParticles, solidTurnedInsideOut)
{
    systemCase c = seeded();
    c.add
    (
        "system/seedParticlesDict",
        "solids { wall { type box; min (0.5 -1 -1); max (0.75 2 1); } }"
    );
    c.write("constant/solidProperties", "wall { rho 1; E 3; nu 0.3; }\n");
    c.seed();
    const outcome o = check(c);
    EXPECT_EQ(o.code, 0) << o.out << o.err;
    EXPECT_TRUE(o.says("All cells have a volume OK."));
    EXPECT_TRUE(o.says("0 broken"));
    c.replace("0/lagrangian/solid/positions", "(0.5625 0.0625 0)",
        "(0.75 0.0625 0)");
    expectFailed(c, "2 cells of the solids turned inside out");
}


TEST(checkParticles, badInput)
{
    systemCase none = systemCase::piston();
    none.write("constant/domain", bytesOf(seeded().path()/"constant/domain"));
    const outcome empty = check(none);
    EXPECT_EQ(empty.code, 1);
    EXPECT_TRUE(empty.says("There is no time to check")) << empty.err;
    EXPECT_TRUE(empty.says("seedParticles"));

    systemCase cut = seeded();
    cut.remove("0/lagrangian/fluid/U");
    const outcome o = check(cut);
    EXPECT_EQ(o.code, 1);
    EXPECT_TRUE(o.says("FOAM FATAL")) << o.err;
    EXPECT_TRUE(o.says("lagrangian/fluid"));
    EXPECT_EQ(check(cut, {"-tim", "0"}).code, 1);
}
