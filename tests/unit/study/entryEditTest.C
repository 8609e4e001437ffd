#include "scratch.H"
#include "study/entryEdit.H"
#include "study/entryText.H"

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
    EXPECT_EQ
    (
        edited("a 2; b { a 1; }\n", "d:b:a", "z"), "a 2; b { a z; }\n"
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


TEST(setEntry, leavesTheOriginOfAMacroAlone)
{
    // As tutorials/gpuFsiFoam/collidingBars has its bars
    for (const char* text : {
        "first\n{\n    E 1;\n    nu 2;\n}\nsecond\n{\n    $first;\n}\n",
        "first { E 1; nu 2; } second { $first; }",
        // Within the span of second, as its first part stands before
        "second { a 1; }\nfirst { E 1;\n nu 2; }\nsecond { $first; }\n",
        "first { E 1; nu 2; }\nsecond { E 3;\n $first; }\n",
        "first { E 1; nu 2; }\n${x:-second} { $first; }\n"})
    {
        const scratch s;
        const auto file = s.write("d", text);
        setEntry(file, entryAddress("d:second:E", {}), "7");
        const dictionary d = dictionary::fromFile(file);
        EXPECT_EQ(d.subDict("first").get<double>("E"), 1) << text;
        EXPECT_EQ(d.subDict("second").get<double>("E"), 7) << text;
        EXPECT_EQ(d.subDict("second").get<double>("nu"), 2) << text;
    }
}


TEST(setEntry, passesOnWhatMacrosCopy)
{
    const scratch s;
    const auto file = s.write("d", "first { E 1; }\nsecond { $first; }\n");
    setEntry(file, entryAddress("d:first:E", {}), "7");
    const dictionary d = dictionary::fromFile(file);
    EXPECT_EQ(d.subDict("second").get<double>("E"), 7);
}


TEST(setEntry, leavesDictionariesInMacrosAlone)
{
    const scratch s;
    const auto file =
        s.write("d", "a\n{\n sub { x 1; y 2; }\n}\nb\n{\n $a;\n}\n");
    setEntry(file, entryAddress("d:b:sub:x", {}), "7");
    const dictionary d = dictionary::fromFile(file);
    EXPECT_EQ(d.subDict("a").subDict("sub").get<double>("x"), 1);
    EXPECT_EQ(d.subDict("b").subDict("sub").get<double>("x"), 7);
    EXPECT_EQ(d.subDict("b").subDict("sub").get<double>("y"), 2);
}


TEST(setEntry, refusesADictionaryOfAPattern)
{
    const std::string text = "f { \"(p|U)\" { tol 1; rel 0; } }\n";
    const scratch s;
    const auto file = s.write("d", text);
    expectIn("given by a pattern", messageOf([&]
    {
        setEntry(file, entryAddress("d:f:p:tol", {}), "7");
    }));
    EXPECT_EQ(dictionary::fromFile(file).toText(),
        dictionary::fromString(text).toText());
}


TEST(setEntry, refusesWhatDoesNotTake)
{
    const scratch s;
    s.write("common", "a 1;\n");
    const auto file =
        s.write("d", "#include \"common\"\n#inputMode protect\nb 2;\n");
    expectIn("does not take", messageOf([&]
    {
        setEntry(file, entryAddress("d:a", {}), "7");
    }));
}


TEST(setEntry, findsItsWayThroughText)
{
    const std::string text =
        "/* b { a 0; } */ \"b.*\" { a 1; }   // b { a 2; }\n"
        "#include \"none\"\nx #{ b { a 3; } #}; y \"{ b\"; ${z} { a 4; }\n"
        "c { b { a 5; } } l (b { a 6; }); e #eval{ 1 };\n"
        "b\n{ /* } */ c { a 7; } a 8; aa 9; }\n";
    const auto places = placesOf(text, {"b", "a"});
    ASSERT_EQ(places.size(), 1u);
    EXPECT_EQ(places[0].line, 6);
    EXPECT_EQ(text.substr(places[0].value, 3), " 8;");
    EXPECT_EQ(text[places[0].end], ';');
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
