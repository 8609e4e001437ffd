// Seeding of solids as a whole: which files there are, and that their bytes
// depend on nothing but the dictionary.
#include "systemCase.H"

#include <gtest/gtest.h>

namespace
{

constexpr const char* file = "system/seedParticlesDict";

constexpr const char* solids =
    "solids { ball { type sphere; centre (1 0 0); radius 3; U (0 \"x\" 0);"
    " parts { pole { surface yes; type box; min (-9 -9 2); max (9 9 9); } } }"
    " }";

fileTree seeded(systemCase& c, const std::string& threads = "1")
{
    const outcome o = c.run
    (
        app::seedParticles, {}, {"OMP_NUM_THREADS=" + threads}
    );
    EXPECT_EQ(o.code, 0) << o.out << o.err;
    fileTree files = c.tree();
    files.erase(c.path().filename().string() + ".foam");
    return files;
}

bool any(const fileTree& files, const std::string& folder)
{
    const auto at = files.lower_bound(folder);
    return at != files.end() && at->first.compare(0, folder.size(), folder)
        == 0;
}

} // namespace


TEST(seededSolids, sameBytesOnAnyNumberOfThreads)
{
    for (const char* format : {"ascii", "binary"})
    {
        systemCase c = systemCase::pulse();
        c.add(file, solids);
        c.set("system/controlDict", "writeFormat", format);
        const fileTree one = seeded(c);
        EXPECT_TRUE(any(one, "0/lagrangian/solid/referencePosition"));
        EXPECT_TRUE(any(one, "0/lagrangian/walls/node"));
        EXPECT_TRUE(any(one, "constant/solid/cells"));
        EXPECT_EQ(difference(seeded(c, "3"), one), "");
    }
}


TEST(seededSolids, comeAndGo)
{
    systemCase c = systemCase::pulse();
    const std::string before = c.text(file);
    const fileTree without = seeded(c);
    c.add(file, solids);
    EXPECT_TRUE(any(seeded(c), "constant/solid/"));

    // Nothing else
    c.add(file, "fluid no;");
    const fileTree alone = seeded(c);
    EXPECT_TRUE(any(alone, "0/lagrangian/solid/"));
    EXPECT_FALSE(any(alone, "0/lagrangian/fluid/"));
    EXPECT_FALSE(any(alone, "0/lagrangian/walls/"));

    c.write(file, before);
    EXPECT_EQ(difference(seeded(c), without), "");
}
