// What the dictionary's errors say.

#include "blocks.H"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <unistd.h>

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


TEST(solidProperties, nothingLeavesThePlane)
{
    const auto part = [](const char* entries)
    {
        return says
        (
            std::string("E 1; parts { left { ") + entries + " } }",
            "leaves the plane"
        );
    };
    EXPECT_TRUE(part("type force; force (0 0 1);"));
    EXPECT_TRUE(part("type traction; traction (1 0 1);"));
    EXPECT_TRUE(part("type slide; normal (0 0 1);"));
    EXPECT_TRUE(part("type oscillation; amplitude (0 0 1); omega 1;"));
    EXPECT_TRUE
    (
        part("type rotation; origin (0 0 0); axis (1 0 0); omega 1;")
    );
    EXPECT_FALSE(part("type force; force (0 1 0);"));
    const solidMesh mesh = block(2, 2, 2, 0, 1);
    EXPECT_THROW(material(mesh, "E 1;", vector{0, 0, -9.81}), userError);
}


TEST(solidProperties, unknownPartListsThoseThereAre)
{
    const std::string text =
        complaint("E 1; parts { lfet { type fixed; } }");
    EXPECT_NE(text.find("left"), std::string::npos);
    EXPECT_NE(text.find("right"), std::string::npos);
}


TEST(solidProperties, contactIsReadAndChecked)
{
    const solidMesh mesh = block(2, 2, 2, 0, 1);
    const auto contactOf = [&](const std::string& more)
    {
        return material(mesh, "E 1;", {}, more).contact;
    };
    const auto complains = [&](const std::string& more, const char* text)
    {
        try
        {
            contactOf(more);
        }
        catch (const userError& e)
        {
            return std::string(e.what()).find(text) != std::string::npos;
        }
        return false;
    };
    EXPECT_FALSE(contactOf("").active);
    EXPECT_FALSE(contactOf("contact { active no; }").active);
    EXPECT_TRUE(contactOf("contact {}").active);
    const contactProperties p = contactOf
    (
        "contact { stiffness 2; friction 0.3; damping 0.1; walls no; gap 0.5;"
        " margin 0.25; }"
    );
    EXPECT_EQ(p.stiffness, 2);
    EXPECT_EQ(p.friction, 0.3);
    EXPECT_EQ(p.damping, 0.1);
    EXPECT_FALSE(p.walls);
    EXPECT_EQ(p.gap.value(), 0.5);
    EXPECT_FALSE(contactOf("contact {}").gap.has_value());
    EXPECT_EQ(p.margin, 0.25);
    EXPECT_TRUE(complains("contact { stiffness 0; }", "stiffness"));
    EXPECT_TRUE(complains("contact { friction -0.1; }", "friction"));
    EXPECT_TRUE(complains("contact { damping 2; }", "damping"));
    EXPECT_TRUE(complains("contact { gap -1; }", "must not be negative"));
    EXPECT_TRUE(complains("contact { margin 0; }", "must be positive"));
    EXPECT_TRUE
    (
        complains("contact {} stepping implicit;", "Implicit steps have no")
    );
}


TEST(solidProperties, filesOfACase)
{
    namespace fs = std::filesystem;
    const fs::path casePath = fs::temp_directory_path()
        /("solidProperties" + std::to_string(getpid()));
    fs::create_directories(casePath/"constant");
    std::ofstream(casePath/"constant"/"solidProperties")
        << "bar { rho 7; E 8; nu 0; breakStrain 0.2; parts {"
           " middle { type fixed; } } }";
    const solidMesh mesh = block(2, 2, 2, 0, 1);
    EXPECT_THROW(solidProperties::read(casePath, mesh), userError);

    std::ofstream(casePath/"constant"/"solidProperties")
        << "bar { rho 7; E 8; nu 0; breakStrain 0.2; parts {"
           " right { type force; force (0 1 0); ramp 3; }"
           " left { type fixed; } } }"
           " stepping implicit; tolerance 1e-6; subSteps 2;";
    const solidProperties still = solidProperties::read(casePath, mesh);
    EXPECT_FALSE(still.g.acts());
    std::ofstream(casePath/"constant"/"g")
        << "dimensions [0 1 -2 0 0 0 0]; value (0 -9.81 0);";
    const solidProperties p = solidProperties::read(casePath, mesh);
    EXPECT_EQ(p.g.at(0).y, -9.81);
    EXPECT_EQ(p.materials[0].rho, 7);
    EXPECT_EQ(p.materials[0].mu, 4);
    EXPECT_EQ(p.materials[0].breakStrain, 0.2);
    EXPECT_EQ(p.parts[0].kind, solidPart::type::fixed);
    EXPECT_EQ(p.parts[1].force.y, 1);
    EXPECT_EQ(p.parts[1].ramp, 3);
    EXPECT_EQ(p.stepping, solidProperties::scheme::midpoint);
    EXPECT_EQ(p.tolerance, 1e-6);
    EXPECT_EQ(p.subSteps, 2);
    fs::remove_all(casePath);
}
