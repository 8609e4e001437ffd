#include "scratch.H"
#include "study/entryEdit.H"

using namespace gpuFsi;

namespace
{

//- The text after an entry is set
std::string edited
(
    const std::string& text,
    const std::string& address,
    const std::string& value
)
{
    const scratch s;
    const auto file = s.write("d", text);
    setEntry(file, entryAddress(address, {}), value);
    std::ifstream stream(file);
    return {std::istreambuf_iterator<char>(stream), {}};
}

} // namespace


TEST(setEntry, replacesInPlaceSoThatMacrosSeeIt)
{
    EXPECT_EQ
    (
        edited
        (
            "n 4;   // cells\nh #eval{ 1/$n };\n", "d:n", "10"
        ),
        "n 10;   // cells\nh #eval{ 1/$n };\n"
    );
}


TEST(setEntry, keepsWhatStandsAround)
{
    EXPECT_EQ
    (
        edited("aa 1; a 2;\nb { a \"x;y\"; c 3; }\n", "d:b:a", "z"),
        "aa 1; a 2;\nb { a z; c 3; }\n"
    );
    // Which of the two is meant? The last entry wins
    EXPECT_EQ
    (
        edited("a 2; b { a 1; }\n", "d:b:a", "z"),
        "a 2; b { a 1; }\n\nb { a z; }\n"
    );
    EXPECT_EQ
    (
        edited("a /* ; */ (1\n // ;\n 2); b 1;", "d:a", "(3)"),
        "a (3); b 1;"
    );
    EXPECT_EQ(edited("a #eval{ 1 + 2 };", "d:a", "5"), "a 5;");
}


TEST(setEntry, replacesTheLastOfSeveral)
{
    EXPECT_EQ(edited("a 1;\na 2;\n", "d:a", "3"), "a 1;\na 3;\n");
}


TEST(setEntry, appendsWhatIsNotThere)
{
    EXPECT_EQ(edited("a 1;", "d:b", "2"), "a 1;\nb 2;\n");
    EXPECT_EQ
    (
        edited("s { a 1; }", "d:s:b", "2"), "s { a 1; }\ns { b 2; }\n"
    );
    EXPECT_EQ(edited("\"a.*\" 1;", "d:ab", "2"), "\"a.*\" 1;\nab 2;\n");
}


TEST(setEntry, appendsWhatAnIncludeGives)
{
    const scratch s;
    s.write("common", "a 1;\n");
    const auto file = s.write("d", "#include \"common\"\nb 2;\n");
    setEntry(file, entryAddress("d:a", {}), "7");
    EXPECT_EQ(dictionary::fromFile(file).get<double>("a"), 7);
    EXPECT_EQ(dictionary::fromFile(s.path/"common").get<double>("a"), 1);
}


TEST(setEntry, refusesWhatIsNoDictionaryAfter)
{
    const scratch s;
    const auto file = s.write("d", "a 1;\n");
    expectIn("d at line", messageOf([&]
    {
        setEntry(file, entryAddress("d:a", {}), "1 }");
    }));
}
