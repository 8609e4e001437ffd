// The same input gives the same bytes, on any number of threads.
#include "systemCase.H"

#include <gtest/gtest.h>

namespace
{

//- Without what tells the clock: error.dat and cost.dat have the seconds spent
fileTree results(const systemCase& c)
{
    fileTree files;
    for (const auto& [name, bytes] : c.tree())
    {
        if (name.find("error.dat") == std::string::npos
         && name.find("cost.dat") == std::string::npos)
        {
            files[name] = bytes;
        }
    }
    // Called as the case is, and empty
    files.erase(c.path().filename().string() + ".foam");
    return files;
}

//- All three programs, from the dictionaries to the pictures
fileTree runAll(const systemCase& dictionaries, const std::string& threads)
{
    const systemCase c(dictionaries);
    for (const app program :
        {app::seedParticles, app::gpuFsiFoam, app::particlesToVTK})
    {
        const outcome o =
            c.run(program, {}, {"OMP_NUM_THREADS=" + threads});
        EXPECT_EQ(o.code, 0) << o.out << o.err;
    }
    return results(c);
}

void expectSame(const systemCase& c)
{
    const fileTree two = runAll(c, "2");
    EXPECT_GT(two.size(), 40u);
    EXPECT_EQ(difference(runAll(c, "2"), two), "") << "the same again";
    EXPECT_EQ(difference(runAll(c, "1"), two), "") << "1 thread";
    EXPECT_EQ(difference(runAll(c, "3"), two), "") << "3 threads";
}

} // namespace


TEST(determinism, pulse)
{
    for (const char* precision : {"single", "double"})
    {
        systemCase c = systemCase::pulse();
        c.set("system/controlDict", "precision", precision);
        c.add("system/seedParticlesDict", "displace 0.1;");
        expectSame(c);
    }
}


TEST(determinism, momentWeights)
{
    systemCase c = systemCase::pulse();
    c.set("system/particleSchemes", "areaWeights", "moment");
    c.set("system/particleSchemes", "timeScheme", "RK2");
    c.add("system/particleSchemes", "faces hermite; dissipation 0.2;");
    c.add("system/particleSchemes", "shifting 0.5;");
    c.add("system/seedParticlesDict", "displace 0.1;");
    c.set("system/controlDict", "endTime", "0.4");
    expectSame(c);
}


TEST(determinism, piston)
{
    systemCase c = systemCase::piston();
    c.set("system/seedParticlesDict", "spacing", "0.015625");
    c.set("system/particleSchemes", "method", "localUpdate");
    c.set("system/controlDict", "deltaT", "0.004");
    c.set("system/controlDict", "endTime", "0.1");
    expectSame(c);
}
