// A run that is broken off and taken up again ends in the same bytes.
#include "systemCase.H"

#include <gtest/gtest.h>

namespace
{

constexpr const char* control = "system/controlDict";
constexpr const char* schemes = "system/particleSchemes";

void expectRun(const systemCase& c)
{
    const outcome o = c.run(app::gpuFsiFoam);
    ASSERT_EQ(o.code, 0) << o.out << o.err;
    ASSERT_NE(o.out.find("\nEnd"), std::string::npos);
}

//- Runs `seeded`, then once more from every time written, and compares all
//  folders after that time
void expectSameFromEveryTime(const systemCase& seeded)
{
    const systemCase whole(seeded);
    expectRun(whole);
    const std::vector<std::string> names = whole.timeNames();
    ASSERT_GE(names.size(), 4u);    // 0 and three written
    const fileTree wanted = whole.times();
    for (std::size_t from = 1; from + 1 < names.size(); ++from)
    {
        systemCase again(whole);
        for (std::size_t later = from + 1; later < names.size(); ++later)
        {
            again.remove(names[later]);
        }
        again.set(control, "startFrom", "latestTime");
        expectRun(again);
        EXPECT_EQ(difference(again.times(), wanted), "")
            << "from " << names[from];
    }
}

void chooseNeighbours
(
    systemCase& c,
    const std::string& method,
    const std::string& update
)
{
    c.set(schemes, "method", method);
    c.set(schemes, "update", update);
}

void expectSameForAllNeighbours(const systemCase& base)
{
    for (const char* precision : {"single", "double"})
    {
        for (const char* method : {"cellSearch", "localUpdate"})
        {
            for (const char* update :
                {"interval; interval 3", "displacement; displacement 0.02"})
            {
                SCOPED_TRACE
                (
                    std::string(precision) + ' ' + method + ' ' + update
                );
                systemCase c(base);
                c.set(control, "precision", precision);
                chooseNeighbours(c, method, update);
                expectSameFromEveryTime(c);
            }
        }
    }
}

systemCase quietPulse()
{
    systemCase c = systemCase::pulse();
    c.set(control, "writeInterval", "0.15");
    c.set(control, "endTime", "0.45");
    c.set("system/seedParticlesDict", "rho", "\"1 + 0.2*exp(-r^2/5)\"");
    return c;
}

} // namespace


TEST(restart, fixedWalls)
{
    const systemCase c = quietPulse();
    c.seed();
    expectSameForAllNeighbours(c);
}


TEST(restart, movingWalls)
{
    systemCase c = systemCase::piston();
    c.set(control, "endTime", "0.3");
    c.seed();
    expectSameForAllNeighbours(c);
}


TEST(restart, movingWallsInSecondOrder)
{
    systemCase c = systemCase::piston();
    c.set(control, "endTime", "0.3");
    c.add(schemes, "areaWeights radial; timeScheme RK2;");
    c.seed();
    for (const char* precision : {"single", "double"})
    {
        c.set(control, "precision", precision);
        expectSameFromEveryTime(c);
    }
}


TEST(restart, turningWall)
{
    systemCase c = quietPulse();
    c.write
    (
        "constant/wallProperties",
        "cylinder { type rotation; origin (0 0 0); axis (0 1 0); omega 1; }\n"
    );
    c.seed();
    for (const char* precision : {"single", "double"})
    {
        c.set(control, "precision", precision);
        expectSameFromEveryTime(c);
    }
}


TEST(restart, superSteps)
{
    systemCase c = systemCase::piston();
    c.set(control, "endTime", "0.3");
    c.set("constant/fluidProperties", "mu", "0.4");
    c.set(control, "writeInterval", "4");
    c.add(schemes, "areaWeights moment; timeScheme symplecticEuler;");
    c.add("system/seedParticlesDict", "displace 0.1;");
    c.seed();
    for (const char* precision : {"single", "double"})
    {
        for (const char* more : {"", "adjustTimeStep yes; maxCo 0.4;"})
        {
            SCOPED_TRACE(std::string(precision) + ' ' + more);
            systemCase run(c);
            run.set(control, "precision", precision);
            run.add(control, more);
            expectSameFromEveryTime(run);
        }
    }
}


//- Every term that the published scheme does not have
TEST(restart, momentWeights)
{
    systemCase c = systemCase::piston();
    c.set(control, "endTime", "0.3");
    c.add
    (
        schemes,
        "areaWeights moment; faces hermite; dissipation 0.2; shifting 0.5;"
    );
    c.add(schemes, "timeScheme RK2;");
    c.add("system/seedParticlesDict", "displace 0.1;");
    c.seed();
    for (const char* precision : {"single", "double"})
    {
        for (const char* method : {"cellSearch", "localUpdate"})
        {
            SCOPED_TRACE(std::string(precision) + ' ' + method);
            c.set(control, "precision", precision);
            c.set(schemes, "method", method);
            expectSameFromEveryTime(c);
        }
    }
}


TEST(restart, bodyForceInTime)
{
    systemCase c = systemCase::piston();
    c.set(control, "endTime", "0.3");
    c.write("constant/g", "value (\"0.3*cos(20*t)\" \"0.1*t\" 0);\n");
    c.seed();
    expectSameFromEveryTime(c);
    c.add(schemes, "areaWeights moment;");
    for (const char* time : {"symplecticEuler", "RK2"})
    {
        systemCase moment(c);
        moment.add(schemes, std::string("timeScheme ") + time + ";");
        expectSameFromEveryTime(moment);
    }
}


TEST(restart, stepThatAdjustsItself)
{
    systemCase c = systemCase::piston();
    c.set(control, "writeControl", "adjustableRunTime");
    c.set(control, "writeInterval", "0.1");
    c.add(control, "adjustTimeStep yes;");
    c.add(control, "maxCo 0.2;");
    c.seed();
    expectSameFromEveryTime(c);
}


//- By a limit that changes with the flow and with time
TEST(restart, stepThatFollowsTheForce)
{
    systemCase c = systemCase::piston();
    c.set(control, "endTime", "0.09");
    c.set(control, "writeControl", "adjustableRunTime");
    c.set(control, "writeInterval", "0.03");
    c.add(control, "adjustTimeStep yes; logInterval 1;");
    c.add
    (
        schemes,
        "areaWeights moment; timeScheme symplecticEuler; dissipation 0.1;"
    );
    c.write("constant/g", "value (0 \"80*cos(60*t)\" 0);\n");
    c.seed();
    for (const char* precision : {"single", "double"})
    {
        c.set(control, "precision", precision);
        expectSameFromEveryTime(c);
    }
    EXPECT_TRUE(c.run(app::gpuFsiFoam).says("limited by bodyForce"));
}


TEST(restart, oddStepAndOffset)
{
    systemCase c = systemCase::piston();
    c.set(control, "deltaT", "0.0137");
    c.set(control, "writeInterval", "7");
    c.set(control, "precision", "single");
    c.add(control, "timePrecision 4;");
    c.seed();
    expectSameFromEveryTime(c);
}


//- What purgeWrite leaves is enough
TEST(restart, afterPurgeWrite)
{
    systemCase c = systemCase::piston();
    c.seed();
    const systemCase all(c);
    expectRun(all);
    c.set(control, "endTime", "0.3");
    c.add(control, "purgeWrite 1;");
    expectRun(c);
    EXPECT_EQ(c.timeNames(), (std::vector<std::string>{"0", "0.3"}));
    c.set(control, "startFrom", "latestTime");
    c.set(control, "endTime", "0.4");
    expectRun(c);
    const fileTree wanted = within(all.tree(), "0.4");
    EXPECT_FALSE(wanted.empty());
    EXPECT_EQ(difference(within(c.tree(), "0.4"), wanted), "");
}


//- An end that lies behind is a warning: nothing is run or changed
TEST(restart, endBeforeStart)
{
    systemCase c = systemCase::piston();
    c.seed();
    expectRun(c);
    c.set(control, "startFrom", "latestTime");
    c.set(control, "endTime", "0.1");
    const fileTree before = c.tree();
    const outcome o = c.run(app::gpuFsiFoam);
    EXPECT_EQ(o.code, 0);
    EXPECT_NE(o.err.find("nothing to run"), std::string::npos) << o.err;
    EXPECT_EQ(difference(c.tree(), before), "");
}
