#include "fixture.H"

using namespace gpuFsi;

using words = std::vector<std::string>;


TEST(dictionaryStructure, commentsAndNesting)
{
    const dictionary d = parse
    (
        "// one\na /* two\n lines */ 1; sub { b 2; inner { c 3; } };;\n"
    );
    EXPECT_EQ(d.keys(), (words{"a", "sub"}));
    EXPECT_EQ(d.subDict("sub").subDict("inner").get<int>("c"), 3);
    EXPECT_EQ(d.subDict("sub").name(), "system/controlDict:sub");
    EXPECT_TRUE(d.isDict("sub"));
    EXPECT_FALSE(d.isDict("a"));
    EXPECT_EQ(d.subDictPtr("none"), nullptr);
    EXPECT_EQ(d.where("a").first, 2);
    EXPECT_EQ(d.where("a").last, 3);
}


TEST(dictionaryStructure, repeatsMergeLastWins)
{
    const dictionary d = parse
    (
        "a 1; s { x 1; y 1; t { p 1; } } a 2; s { y 2; t { q 2; } }"
    );
    EXPECT_EQ(d.get<int>("a"), 2);
    EXPECT_EQ(d.keys(), (words{"a", "s"}));
    EXPECT_EQ(d.subDict("s").keys(), (words{"x", "y", "t"}));
    EXPECT_EQ(d.subDict("s").get<int>("y"), 2);
    EXPECT_EQ(d.subDict("s").subDict("t").keys(), (words{"p", "q"}));
}


TEST(dictionaryStructure, patterns)
{
    const dictionary d = parse
    (
        "\"p.*\" 1; \"(p|rho)\" 2; p 3; \"U[0-9]{2}\" 4; \".*Dict\" { a 5; }"
    );
    EXPECT_EQ(d.get<int>("p"), 3);
    EXPECT_EQ(d.get<int>("rho"), 2);
    EXPECT_EQ(d.get<int>("pressure"), 1);
    EXPECT_EQ(d.get<int>("U12"), 4);
    EXPECT_FALSE(d.found("U1"));
    EXPECT_FALSE(d.found("xp"));
    EXPECT_EQ(d.subDict("controlDict").get<int>("a"), 5);
    EXPECT_SAYS(messageOf([] { parse("\n\"a(b\" 1;"); }), "at line 2.");
}


TEST(dictionaryStructure, inputModes)
{
    const std::string first = "a 1; s { x 1; } ";
    const std::string again = "a 2; s { y 2; } ";
    const auto keysOf = [](const dictionary& d)
    {
        return d.subDict("s").keys();
    };
    dictionary d = parse(first + "#inputMode overwrite\n" + again);
    EXPECT_EQ(d.get<int>("a"), 2);
    EXPECT_EQ(keysOf(d), (words{"y"}));
    d = parse(first + "#inputMode protect\n" + again + "b 3;");
    EXPECT_EQ(d.get<int>("a"), 1);
    EXPECT_EQ(d.get<int>("b"), 3);
    EXPECT_EQ(keysOf(d), (words{"x"}));
    d = parse(first + "#inputMode default\n" + again);
    EXPECT_EQ(d.get<int>("a"), 2);
    EXPECT_EQ(keysOf(d), (words{"x", "y"}));
    EXPECT_SAYS
    (
        messageOf([&] { parse(first + "#inputMode error\n" + again); }),
        "given at line 1 already"
    );
    EXPECT_SAYS(messageOf([] { parse("#inputMode mergee\n"); }),
        "did you mean merge?");
    testing::internal::CaptureStderr();
    d = parse(first + "#inputMode warn\n" + again);
    EXPECT_SAYS(testing::internal::GetCapturedStderr(), "Warning");
    EXPECT_EQ(d.get<int>("a"), 1);
}


TEST(dictionaryStructure, removes)
{
    const std::string all = "a 1; b1 1; b2 1; c 1; d 1; ";
    EXPECT_EQ(parse(all + "#remove a\n").keys(), (words{"b1", "b2", "c", "d"}));
    EXPECT_EQ(parse(all + "#remove \"b.*\"\n").keys(), (words{"a", "c", "d"}));
    EXPECT_EQ(parse(all + "#remove (a \"b.\" zz)\ne 1;").keys(),
        (words{"c", "d", "e"}));
}


TEST(dictionaryStructure, setAndCopiesShareMarks)
{
    dictionary d = parse("a 1; b 2; s { c 3; }");
    const dictionary copy = d;
    EXPECT_EQ(copy.get<int>("a"), 1);
    EXPECT_EQ(copy.subDict("s").get<int>("c"), 3);
    EXPECT_EQ(d.unread().size(), 1u);
    d.set("b", "(1 2 $a)");
    d.set("t", "{ x 5; }");
    d.set("s", "7");
    EXPECT_EQ(d.get<vector>("b").z, 1);
    EXPECT_EQ(d.subDict("t").get<int>("x"), 5);
    EXPECT_EQ(d.get<int>("s"), 7);
    EXPECT_EQ(copy.get<int>("b"), 2);
    EXPECT_TRUE(copy.isDict("s"));
    EXPECT_THROW(d.set("b", "1; c 2"), userError);
    EXPECT_THROW(d.set("b", "(1"), userError);
}


TEST(dictionaryStructure, textParsesBack)
{
    const std::string text =
        "a 1; \"p.*\" (a \"b \\\"c\" 3 { 0.5 }); empty; v #{ x\n;} #};"
        "s { nu [0 2 -1 0 0] 1e-6; t { deep ( x { y 1; } ); } none { } }";
    const dictionary d = parse(text);
    const std::string once = d.toText();
    EXPECT_EQ(parse(once).toText(), once);
    const dictionary back = parse(once);
    EXPECT_EQ(back.keys(), d.keys());
    ASSERT_EQ(back.tokens("pp").size(), d.tokens("pp").size());
    for (std::size_t i = 0; i < d.tokens("pp").size(); ++i)
    {
        EXPECT_EQ(back.tokens("pp")[i].text, d.tokens("pp")[i].text);
        EXPECT_EQ(back.tokens("pp")[i].type, d.tokens("pp")[i].type);
    }
    EXPECT_EQ(back.get<std::string>("v"), " x\n;} ");
    EXPECT_TRUE(back.subDict("s").subDict("none").keys().empty());
}


TEST(dictionaryStructure, unreadEntriesAreSentences)
{
    const dictionary d = parse
    (
        "FoamFile { class dictionary; }\n"
        "endTime 1;\n"
        "deltat 2;\n"
        "nothing { a 1; b 2; }\n"
        "s\n{\n    used 1;\n    spare 2;\n}\n"
        "base 4; twice $base;\n"
    );
    d.get<double>("endTime");
    d.getOrDefault<double>("deltaT", 1);
    d.get<int>("twice");
    d.subDict("s").get<int>("used");
    const words list = d.unread();
    ASSERT_EQ(list.size(), 3u);
    EXPECT_EQ(list[0], "Unused entry 'deltat' in \"system/controlDict\" at "
        "line 3: is 'deltaT' meant?");
    EXPECT_EQ(list[1],
        "Unused sub-dictionary 'nothing' in \"system/controlDict\" at line 4.");
    EXPECT_EQ(list[2],
        "Unused entry 'spare' in \"system/controlDict:s\" at line 8.");
    // Known, but its value was not asked for
    EXPECT_TRUE(d.found("nothing"));
    EXPECT_EQ(d.unread()[1], list[1]);

    testing::internal::CaptureStderr();
    d.warnUnread();
    EXPECT_SAYS(testing::internal::GetCapturedStderr(),
        "--> FOAM Warning : Unused entry 'deltat'");
}


TEST(dictionaryStructure, annotatedGrammarIsValid)
{
    const dictionary d = dictionary::fromFile
    (
        std::filesystem::path(FSI_TEST_ETC)/"caseDicts/annotated/grammar"
    );
    EXPECT_EQ(d.get<double>("twice"), 2e-3);
    EXPECT_EQ(d.get<vector>("start").z, 1e-3);
    EXPECT_EQ(d.get<std::string>("application"), "gpuFsiFoam");
    EXPECT_EQ(d.getDimensioned("rho", dimensions::density), 1000);
    EXPECT_EQ(d.getDimensioned("speed", dimensions::velocity), 1.5);
    EXPECT_EQ(d.subDict("fluid").get<int>("gamma"), 1);
    EXPECT_EQ(d.subDict("copy").get<std::string>("model"),
        "weaklyCompressible");
    const dictionary& inner = d.subDict("solid").subDict("inner");
    EXPECT_EQ(inner.get<int>("parent"), 3);
    EXPECT_EQ(inner.get<int>("orgParent"), 3);
    EXPECT_EQ(inner.get<double>("top"), 1e-3);
    EXPECT_EQ(inner.get<double>("orgTop"), 1e-3);
    EXPECT_EQ(inner.get<std::string>("orgSibling"), "weaklyCompressible");
    EXPECT_EQ(inner.get<int>("absent"), 5);
    EXPECT_NEAR(d.get<double>("area"), 0.78539816339744831, 1e-16);
    EXPECT_TRUE(d.get<bool>("stable"));
    EXPECT_EQ(d.get<std::string>("solver"), "ours");
    EXPECT_EQ(d.subDict("fields").get<std::string>("rho"), "cubic");
    EXPECT_FALSE(d.found("scratch1"));
}
