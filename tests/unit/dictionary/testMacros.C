#include "fixture.H"

#include <cstdlib>

using namespace gpuFsi;


TEST(dictionaryMacros, everyScopeForm)
{
    const dictionary d = parse
    (
        "x 1; y 2; a.b 9; s { k 3; t { k 4; } }\n"
        "p { x 5; q { v1 $x; v2 ${y}; v3 $..x; v4 $...x; v5 $:x; v6 $^x;"
        " v7 $s.k; v8 $s.t.k; v9 $:s.t.k; w1 $s/k; w2 $../x; w3 $!s/t/k;"
        " w4 ${../../x}; w5 $.v1; w6 $a.b; } }"
    );
    const dictionary& q = d.subDict("p").subDict("q");
    const std::pair<const char*, int> expected[] =
    {
        {"v1", 5}, {"v2", 2}, {"v3", 5}, {"v4", 1}, {"v5", 1}, {"v6", 1},
        {"v7", 3}, {"v8", 4}, {"v9", 4}, {"w1", 3}, {"w2", 5}, {"w3", 4},
        {"w4", 1}, {"w5", 5}, {"w6", 9}
    };
    for (const auto& [key, value] : expected)
    {
        EXPECT_EQ(q.get<int>(key), value) << key;
    }
}


TEST(dictionaryMacros, listsDictionariesAndKeys)
{
    const dictionary d = parse
    (
        "n 2; v (1 2 3); s { a 1; b { c 2; } } list ($v ($n 0 0)); fill $n{7};"
        "copy $s; t { b { d 4; } $s; a 5; } key U; ${key} 6; x 1; x $x;"
    );
    EXPECT_EQ(d.get<std::vector<vector>>("list")[1].x, 2);
    EXPECT_EQ(d.get<std::vector<int>>("fill"), (std::vector<int>{7, 7}));
    EXPECT_EQ(d.subDict("copy").subDict("b").get<int>("c"), 2);
    EXPECT_EQ(d.subDict("copy").subDict("b").name(),
        "system/controlDict:copy:b");
    EXPECT_EQ(d.subDict("t").get<int>("a"), 5);
    EXPECT_EQ(d.subDict("t").subDict("b").keys(),
        (std::vector<std::string>{"d", "c"}));
    EXPECT_EQ(d.get<int>("U"), 6);
    EXPECT_EQ(d.get<int>("x"), 1);
}


TEST(dictionaryMacros, environmentAndDefaults)
{
    setenv("FSI_TEST_NUMBER", "42", 1);
    setenv("FSI_TEST_PATH", "/a b/c", 1);
    const dictionary d = parse
    (
        "a $FSI_TEST_NUMBER; b ${FSI_TEST_PATH}; c ${none:-3}; d 5;"
        "e ${d:-6};"
    );
    EXPECT_EQ(d.get<int>("a"), 42);
    EXPECT_EQ(d.get<std::string>("b"), "/a b/c");
    EXPECT_EQ(d.get<int>("c"), 3);
    EXPECT_EQ(d.get<int>("e"), 5);
}


TEST(dictionaryMacros, arithmetic)
{
    const dictionary d = parse
    (
        "a 4; m -3; s { h 0.5; } e1 #eval{ sqrt($a) }; e2 #eval \"$a/2\";"
        "e3 #calc \"2-$m\"; e4 #calc #{ $s.h*2 #}; e5 (0 #eval{$a-1} 0);"
        "e6 #eval{ ${s.h} > 0 ? $a:$m }; e7 #eval{ $m^2 }; e8 #eval { 10 };"
    );
    EXPECT_EQ(d.get<int>("e1"), 2);
    EXPECT_EQ(d.get<int>("e2"), 2);
    EXPECT_EQ(d.get<int>("e3"), 5);
    EXPECT_EQ(d.get<int>("e4"), 1);
    EXPECT_EQ(d.get<vector>("e5").y, 3);
    EXPECT_EQ(d.get<int>("e6"), 4);
    EXPECT_EQ(d.get<int>("e7"), 9);
    EXPECT_EQ(d.get<int>("e8"), 10);
    EXPECT_SAYS(messageOf([] { parse("\na #calc \"foo(1)\";"); }), "line 2");
    EXPECT_SAYS
    (
        messageOf([] { parse("a #calc #{ int i = 1; return i; #};"); }),
        "has an assignment"
    );
}


TEST(dictionaryMacros, conditions)
{
    const auto chosen = [](const std::string& head)
    {
        return parse
        (
            "n 3; on1 yes; w linear;\n" + head
          + "\nv 1;\n#if off\nv 8;\n#else\n#endif\n"
            "#elif #eval{ $n > 2 }\nv 2;\n#else\nv 3;\n#endif\nz 0;"
        ).get<int>("v");
    };
    EXPECT_EQ(chosen("#if true"), 1);
    EXPECT_EQ(chosen("#if $on1"), 1);
    EXPECT_EQ(chosen("#if 0"), 2);
    EXPECT_EQ(chosen("#if ${n}"), 1);
    EXPECT_EQ(chosen("#if #eval{ $n < 2 }"), 2);
    EXPECT_EQ(chosen("#ifeq $w linear"), 1);
    EXPECT_EQ(chosen("#ifeq $w cubic"), 2);
    EXPECT_EQ(chosen("#ifeq $n 3.0"), 1);
    EXPECT_EQ
    (
        parse("s { #if no\na 1;\n#elif no\na 2;\n#else\na 3;\n#endif\n } b 1;")
            .subDict("s").get<int>("a"),
        3
    );
    EXPECT_SAYS(messageOf([] { parse("\n#if yes\na 1;"); }), "at line 2.");
    EXPECT_SAYS(messageOf([] { parse("\n#if no\na 1;"); }), "at line 2.");
    EXPECT_SAYS(messageOf([] { parse("a 1;\n#endif"); }), "without an #if");
    EXPECT_SAYS(messageOf([] { parse("#if perhaps\n#endif"); }), "perhaps");
    EXPECT_SAYS(messageOf([] { parse("s { #if yes\n }\n#endif"); }), "#if");
}


TEST(dictionaryMacros, includes)
{
    const scratchDirectory at;
    at.write("common/part", "b $a;\nsub { c 3; }\n");
    at.write("system/residuals", "type residuals; fields (p);\n");
    at.write("etc/site", "e 5;\n");
    at.write("etc/caseDicts/probes", "probes { type probes; }\n");
    at.write("common/points", "(0 0 0)\n(1 1 1)\n");
    setenv("FSI_ETC", (at.path/"etc").c_str(), 1);
    const std::string file = at.write
    (
        "system/controlDict",
        "a 1;\ndir \"../common\";\n#include \"$dir/part\"\n"
        "#includeIfPresent \"none\"\n#sinclude \"none\"\n#includeEtc \"site\"\n"
        "#include \"<etc>/site\"\n"
        "functions { #includeFunc residuals\n#includeFunc probes\n }\n"
        "points (\n#include \"../common/points\"\n);\nz 1;\n"
    );
    const dictionary d = dictionary::fromFile(file);
    EXPECT_EQ(d.get<int>("b"), 1);
    EXPECT_EQ(d.where("b").file, at.path/"common/part");
    EXPECT_EQ(d.subDict("sub").get<int>("c"), 3);
    EXPECT_EQ(d.get<int>("e"), 5);
    EXPECT_EQ(d.get<std::vector<vector>>("points").size(), 2u);
    const dictionary& functions = d.subDict("functions");
    EXPECT_EQ(functions.subDict("residuals").get<std::string>("type"),
        "residuals");
    EXPECT_EQ(functions.subDict("probes").get<std::string>("type"), "probes");
    EXPECT_EQ(d.get<int>("z"), 1);
    unsetenv("FSI_ETC");

    const auto problem = [&](const std::string& text)
    {
        const auto bad = at.write("bad", text);
        return messageOf([&] { dictionary::fromFile(bad); });
    };
    EXPECT_SAYS(problem("a 1;\n#include \"none\"\n"), "\"none\" is not found");
    EXPECT_SAYS(problem("a 1;\n#include \"none\"\n"), "bad at line 2.");
    EXPECT_SAYS(problem("#include \"bad\"\n"), "includes itself");
    EXPECT_SAYS(problem("#includeEtc \"none\"\n"), "$FSI_ETC");
    EXPECT_SAYS(problem("#includeFunc none\n"), "system");
    EXPECT_SAYS(problem("#include\nfile 1;"), "file name");
    at.write("keys", "1; b 2");
    EXPECT_SAYS(problem("a\n#include \"keys\"\n;"), "plain values");
    EXPECT_EQ(dictionary::fromFile(at.write("bom", "\xEF\xBB\xBF" "a 1;"))
        .get<int>("a"), 1);
    at.write("loop1", "#include \"loop2\"\n");
    const auto loop2 = at.write("loop2", "\n#include \"loop1\"\n");
    const std::string loop =
        messageOf([&] { dictionary::fromFile(loop2); });
    EXPECT_SAYS(loop, "includes itself");
    EXPECT_SAYS(loop, "loop1 at line 1.");
    EXPECT_SAYS(messageOf([&] { dictionary::fromFile(at.path/"none"); }),
        "Cannot read the file");
    EXPECT_SAYS(messageOf([&] { dictionary::fromFile(at.path); }),
        "Cannot read the file");
}
