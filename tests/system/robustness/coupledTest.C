// An elastic solid in its fluid: a run that is taken up again, and one on any
// number of threads, ends in the same bytes.
#include "systemCase.H"

#include <gtest/gtest.h>

namespace
{

constexpr const char* control = "system/controlDict";
constexpr const char* schemes = "system/particleSchemes";

//- The piston's column with an elastic wall across it, light and damped, that
//  springs hold
systemCase elasticWall(const std::string& law)
{
    systemCase c = systemCase::piston();
    c.set(control, "endTime", "0.3");
    c.add
    (
        schemes,
        "areaWeights moment; timeScheme symplecticEuler; dissipation 0.1;"
    );
    c.add
    (
        "system/seedParticlesDict",
        "solids { wall { type box; min (0.5 -1 -1); max (0.75 2 1);"
        " U (\"0.1*y\" \"0.05\" 0); parts { middle { type box;"
        " min (0.6 -1 -1); max (0.65 2 1); } } } }"
    );
    c.write
    (
        "constant/solidProperties",
        "wall { rho 0.5; E 3; nu 0.3; dashpot 0.001; viscous 0.1;\n"
        "parts { middle { type anchor; stiffness (1 0 0); } } }\n"
    );
    c.write
    (
        "constant/couplingProperties",
        "force " + law + "; referencePressure 0.01;\n"
    );
    c.write("constant/g", "value (\"0.2*sin(9*t)\" 0 0);\n");
    c.add
    (
        control,
        "functions { ledger { type solidEnergy; } push { type forces; }\n"
        "probe { type displacementProbe; points ((0.5 0 0)); } }"
    );
    return c;
}

//- And a second solid, which it meets
systemCase meeting()
{
    systemCase c = elasticWall("surface");
    c.replace
    (
        "system/seedParticlesDict", "solids {",
        "solids { stop { type box; min (0.8 -1 -1); max (0.95 2 1);"
        " U (\"-0.3\" \"0\" \"0\"); }"
    );
    c.add
    (
        "constant/solidProperties",
        "stop { rho 2; E 10; } contact { friction 0.3; damping 0.1; }\n"
    );
    return c;
}

void expectRun(const systemCase& c, const std::string& threads = "1")
{
    const outcome o =
        c.run(app::gpuFsiFoam, {}, {"OMP_NUM_THREADS=" + threads});
    ASSERT_EQ(o.code, 0) << o.out << o.err;
    ASSERT_NE(o.out.find("\nEnd"), std::string::npos);
}

//- Times and tables, but for the case's own name
fileTree results(const systemCase& c)
{
    fileTree files = c.times();
    files.merge(within(c.tree(), "postProcessing"));
    return files;
}

} // namespace


TEST(coupled, restartsToTheSameBytes)
{
    for (const char* law : {"surface", "reaction"})
    {
        systemCase c = elasticWall(law);
        c.seed();
        for (const char* precision : {"single", "double"})
        {
            SCOPED_TRACE(std::string(law) + ' ' + precision);
            c.set(control, "precision", precision);
            const systemCase whole(c);
            expectRun(whole);
            const fileTree wanted = whole.times();
            ASSERT_GE(whole.timeNames().size(), 4u);
            ASSERT_TRUE(wanted.count("0.3/lagrangian/solid/acceleration"));
            for (const char* from : {"0.1", "0.2"})
            {
                systemCase again(whole);
                again.remove("0.3");
                if (from == std::string("0.1"))
                {
                    again.remove("0.2");
                }
                again.set(control, "startFrom", "latestTime");
                expectRun(again);
                EXPECT_EQ(difference(again.times(), wanted), "")
                    << "from " << from;
            }
        }
    }
}


TEST(coupled, sameBytesOnAnyNumberOfThreads)
{
    for (const char* law : {"surface", "reaction"})
    {
        systemCase c = elasticWall(law);
        c.set("system/seedParticlesDict", "spacing", "0.015625");
        c.set(control, "deltaT", "0.004");
        c.replace("constant/solidProperties", "rho 0.5", "rho 2");
        c.set(control, "endTime", "0.1");
        c.seed();
        for (const char* precision : {"single", "double"})
        {
            SCOPED_TRACE(std::string(law) + ' ' + precision);
            c.set(control, "precision", precision);
            const systemCase one(c);
            expectRun(one);
            const fileTree wanted = results(one);
            ASSERT_GT(wanted.size(), 40u);
            for (const char* threads : {"2", "3"})
            {
                const systemCase other(c);
                expectRun(other, threads);
                EXPECT_EQ(difference(results(other), wanted), "") << threads;
            }
        }
    }
}


TEST(coupled, contactRestartsToTheSameBytes)
{
    systemCase c = meeting();
    c.seed();
    const systemCase whole(c);
    expectRun(whole);
    const std::string ledger = whole.text
    (
        "postProcessing/ledger/0/solidEnergy.dat"
    );
    EXPECT_NE(ledger.find("contactLoss"), std::string::npos);
    const fileTree wanted = whole.times();
    ASSERT_TRUE(wanted.count("0.2/lagrangian/solid/contactForce"));
    for (const char* later : {"0.3", "0.2"})
    {
        systemCase again(whole);
        again.remove("0.3");
        again.remove(later);
        again.set(control, "startFrom", "latestTime");
        expectRun(again);
        EXPECT_EQ(difference(again.times(), wanted), "") << later;
    }
    const systemCase threads(c);
    expectRun(threads, "3");
    EXPECT_EQ(difference(threads.times(), wanted), "");
}
