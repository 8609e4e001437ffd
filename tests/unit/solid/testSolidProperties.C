// What the dictionary's errors say.

#include "blocks.H"

#include <gtest/gtest.h>

using namespace gpuFsi;

namespace
{

std::string complaint(const std::string& entries)
{
    const solidMesh mesh = block(2, 2, 2, 0, 1);
    try
    {
        material(mesh, entries);
    }
    catch (const userError& e)
    {
        return e.what();
    }
    return "";
}

bool says(const std::string& entries, const std::string& text)
{
    return complaint(entries).find(text) != std::string::npos;
}

} // namespace


TEST(solidProperties, wrongValuesAreNamed)
{
    EXPECT_EQ(complaint("E 1; nu 0.25;"), "");
    EXPECT_TRUE(says("E -1;", "must be positive"));
    EXPECT_TRUE(says("E 1; nu 0.5;", "nu"));
    EXPECT_TRUE(says("E 1; nu 0.4; volumetric off;", "0.25, not 0.4"));
    EXPECT_TRUE(says("springs uniform; k 0;", "must be positive"));
}


TEST(solidProperties, unknownPartListsThoseThereAre)
{
    const std::string text =
        complaint("E 1; parts { lfet { type fixed; } }");
    EXPECT_NE(text.find("left"), std::string::npos);
    EXPECT_NE(text.find("right"), std::string::npos);
}
