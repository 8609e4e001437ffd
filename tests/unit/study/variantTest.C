#include "scratch.H"
#include "study/studyLock.H"
#include "study/variant.H"
#include "study/variantDirectory.H"

#include <cmath>
#include <set>

using namespace gpuFsi;

namespace
{

parameter read(const std::string& text)
{
    const dictionary dict = dictionary::fromString(text);
    return readParameter("p", dict);
}

//- A case of one dictionary, and a study of it
struct smallStudy
{
    scratch place;

    smallStudy()
    {
        place.write("system/controlDict", "deltaT 1; sub { a 1; b 2; }\n");
        place.write("constant/x", "c 3;\n");
        place.write("0/U", "gone");
        place.write("log.x", "gone");
    }

    studyDict study(const std::string& keys) const
    {
        place.write("system/studyDict", keys);
        return studyDict::read(place.path);
    }
};

const char* const parameters =
    "parameters { h { entry \"system/controlDict:deltaT\"; values (4 2); }"
    " s { entries (\"system/controlDict:sub:a\" \"constant/x:c\"); choices"
    " { one (7 asIs); two (8 (1 2 3)); } } OMP_NUM_THREADS { values (1 2); } }";

const char* const rest =
    "commands (\"true\"); error { functionObject e; } ";

} // namespace


TEST(parameter, takesWordsNumbersListsAndText)
{
    const parameter p = read
    (
        "entry \"system/controlDict:a\";"
        "values (0.1 word (1 0 0) \"uniform 2\");"
    );
    ASSERT_EQ(p.choices.size(), 4u);
    EXPECT_EQ(p.choices[0].values, (std::vector<std::string>{"0.1"}));
    EXPECT_EQ(p.choices[1].label, "word");
    EXPECT_EQ(p.choices[2].values[0], "(1 0 0)");
    EXPECT_EQ(p.choices[3].values[0], "uniform 2");
    EXPECT_EQ(p.number(0), 0.1);
    EXPECT_TRUE(std::isnan(p.number(1)));
}


TEST(parameter, numberOfALabelledChoiceIsItsFirstValue)
{
    const parameter p = read
    (
        "entries (\"a:b\" \"a:c\");"
        " choices { coarse (0.5 0.1); \"16\" (0.2 1); }"
    );
    EXPECT_EQ(p.number(0), 0.5);
    EXPECT_EQ(p.number(1), 16);
}


TEST(parameter, saysWhatIsWrong)
{
    const auto wrong = [](const std::string& text)
    {
        return messageOf([&] { read(text); });
    };
    expectIn("is no entry", wrong("entry deltaT; values (1);"));
    expectIn("is no entry", wrong("entry \"/etc/x:a\"; values (1);"));
    expectIn("is no entry", wrong("entry \"../x:a\"; values (1);"));
    expectIn("one value or more", wrong("entry \"a:b\"; values 3;"));
    expectIn("one value or more", wrong("entry \"a:b\"; values ();"));
    expectIn("values", wrong("entry \"a:b\";"));
    expectIn("twice", wrong("entry \"a:b\"; values (1 1);"));
    expectIn
    (
        "there are 2 entries",
        wrong("entries (\"a:b\" \"a:c\"); choices { x (1); }")
    );
    expectIn("environment variable", messageOf([]
    {
        readParameter("a-b", dictionary::fromString("values (1);"));
    }));
}


TEST(variants, areTheProductWithTheResolutionFastest)
{
    const smallStudy c;
    const studyDict s = c.study(std::string(rest) + parameters);
    EXPECT_EQ(s.repeats, 3);
    EXPECT_EQ(s.resolution, 0u);
    const auto all = allVariants(s);
    ASSERT_EQ(all.size(), 8u);
    EXPECT_EQ(all[0].name, "h=4_s=one_OMP_NUM_THREADS=1");
    EXPECT_EQ(all[1].name, "h=2_s=one_OMP_NUM_THREADS=1");
    EXPECT_EQ(all[2].curve, "one, OMP_NUM_THREADS 2");
    EXPECT_EQ(all[7].name, "h=2_s=two_OMP_NUM_THREADS=2");
    EXPECT_EQ(all[7].size, 2);
    std::set<std::string> names;
    for (const variant& v : all)
    {
        names.insert(v.name);
    }
    EXPECT_EQ(names.size(), 8u);

    EXPECT_EQ
    (
        all[7].environment(s),
        (std::vector<std::string>{"h=2", "s=two", "OMP_NUM_THREADS=2"})
    );
    const auto one = all[0].changes(s);
    ASSERT_EQ(one.size(), 2u);
    EXPECT_EQ(one[0].entry.assignment(one[0].value), "deltaT 4;\n");
    EXPECT_EQ(one[1].entry.assignment(one[1].value), "sub { a 7; }\n");
    const auto last = all[7].changes(s);
    ASSERT_EQ(last.size(), 3u);
    EXPECT_EQ(last[2].entry.file, "constant/x");
    EXPECT_EQ(last[2].value, "(1 2 3)");
}


TEST(variants, areNotNamedAfterWhatHasOneChoice)
{
    const smallStudy c;
    const auto all = allVariants
    (
        c.study
        (
            std::string(rest) + "parameters { a { values (1); }"
            " h { values (2); } b { values (3 4); } } resolution h;"
        )
    );
    ASSERT_EQ(all.size(), 2u);
    EXPECT_EQ(all[1].name, "h=2_b=4");
    EXPECT_EQ(all[1].curve, "b 4");
}


TEST(variants, rulesSkip)
{
    const smallStudy c;
    const auto all = allVariants
    (
        c.study
        (
            std::string(rest) + parameters
          + "skip { a { s one; h 2; } b { OMP_NUM_THREADS 2; } }"
        )
    );
    ASSERT_EQ(all.size(), 3u);
    EXPECT_EQ(all[0].resolution, "4");
    EXPECT_EQ(all[1].curve, "two, OMP_NUM_THREADS 1");
    EXPECT_EQ(all[2].resolution, "2");
}


TEST(studyDict, saysWhatIsWrong)
{
    const smallStudy c;
    const auto wrong = [&](const std::string& text)
    {
        return messageOf([&] { c.study(text); });
    };
    const std::string p = parameters;
    expectIn("commands", wrong("error { functionObject e; }" + p));
    expectIn("either", wrong("commands (\"x\"); error { }" + p));
    expectIn
    (
        "norm", wrong("commands (\"x\"); error { functionObject e; norm L3; }")
    );
    expectIn
    (
        "compared with", wrong("commands (\"x\"); error { command \"y\"; }")
    );
    expectIn
    (
        "Give one of",
        wrong
        (
            "commands (\"x\"); error { command \"y\"; exact 1; finest yes; }"
        )
    );
    expectIn
    (
        "exact is 0",
        wrong("commands (\"x\"); error { command \"y\"; exact 0; }")
    );
    expectIn("parameter", wrong(rest + p + "resolution g;"));
    expectIn("choice", wrong(rest + p + "skip { a { s three; } }"));
    expectIn("would skip all", wrong(rest + p + "skip { a { } }"));
    expectIn("begins with study", wrong(rest + p + "directory constant;"));
    expectIn("nothing to study", wrong(std::string(rest) + "parameters { }"));
    expectIn
    (
        "system/none",
        wrong
        (
            std::string(rest)
          + "parameters { h { entry \"system/none:a\"; values (1); } }"
        )
    );
}


TEST(variantDirectory, isACopyWithItsOwnValues)
{
    const smallStudy c;
    const studyDict s = c.study(std::string(rest) + parameters);
    const auto all = allVariants(s);
    const auto bytes = fingerprint(s, c.place.path);
    const variantDirectory d(s, c.place.path, bytes, all[7]);
    d.prepare();
    EXPECT_FALSE(std::filesystem::exists(d.path()/"0"));
    EXPECT_FALSE(std::filesystem::exists(d.path()/"log.x"));
    const dictionary control =
        dictionary::fromFile(d.path()/"system/controlDict");
    EXPECT_EQ(control.get<double>("deltaT"), 2);
    EXPECT_EQ(control.subDict("sub").get<double>("a"), 8);
    EXPECT_EQ(control.subDict("sub").get<double>("b"), 2);
}


TEST(variantDirectory, keepsRecordsOfTheSameSettingsOnly)
{
    const smallStudy c;
    const studyDict s = c.study(std::string(rest) + parameters);
    const auto all = allVariants(s);
    const auto bytes = fingerprint(s, c.place.path);
    const variantDirectory d(s, c.place.path, bytes, all[0]);
    d.prepare();
    runRecord r;
    r.device = r.precision = r.scheme = r.machine = "x";
    d.keep({r, r});
    d.prepare();
    EXPECT_EQ(d.earlier().size(), 2u);

    // Ended while it was made anew
    std::filesystem::remove_all(d.path());
    EXPECT_EQ(d.earlier().size(), 2u);

    // Another case
    c.place.write("constant/x", "c 4;\n");
    const auto others = fingerprint(s, c.place.path);
    EXPECT_NE(bytes, others);
    const variantDirectory e(s, c.place.path, others, all[0]);
    EXPECT_TRUE(e.earlier().empty());
    e.prepare();
    EXPECT_TRUE(d.earlier().empty());
    e.keep({r});
    EXPECT_EQ(e.earlier().size(), 1u);
    e.forget();
    EXPECT_TRUE(e.earlier().empty());
    EXPECT_TRUE(std::filesystem::is_empty(c.place.path/"study"));
}


TEST(studyDict, hasADirectoryOfItsOwn)
{
    const smallStudy c;
    const std::string text = std::string(rest) + parameters;
    EXPECT_EQ(c.study(text).directory, "study");
    for (const char* name : {"studyDict.gpu", "gpu"})
    {
        c.place.write(std::string("system/") + name, text);
        const studyDict s =
            studyDict::read(c.place.path, std::string("system/") + name);
        EXPECT_EQ(s.directory, "study.gpu");
    }
}


TEST(studyLock, isForOneAtATime)
{
    const scratch s;
    {
        const studyLock lock(s.path/"study");
        expectIn("Another", messageOf([&] { studyLock(s.path/"study"); }));
        const studyLock other(s.path/"study.gpu");
    }
    const studyLock again(s.path/"study");
}


TEST(variantDirectory, refusesACaseThatHasChanged)
{
    const smallStudy c;
    const studyDict s = c.study(std::string(rest) + parameters);
    const auto all = allVariants(s);
    const variantDirectory d
    (
        s, c.place.path, fingerprint(s, c.place.path), all[0]
    );
    d.prepare();
    c.place.write("log.x", "what runs writes this");
    d.prepare();
    c.place.write("constant/x", "c 4;\n");
    expectIn("has changed", messageOf([&] { d.prepare(); }));
}


TEST(fingerprint, holdsWhatIsIncluded)
{
    const scratch outside;
    outside.write("common", "#includeIfPresent \"more\"\n a 1;");
    const smallStudy c;
    c.place.write
    (
        "constant/x", "c 3; include no;\n#include \""
      + (outside.path/"common").string() + "\"\n#sinclude none\n"
    );
    const studyDict s = c.study(std::string(rest) + parameters);
    std::set<std::string> marks{fingerprint(s, c.place.path)};
    outside.write("common", "#includeIfPresent \"more\"\n a 2;");
    marks.insert(fingerprint(s, c.place.path));
    outside.write("more", "b 1;");
    marks.insert(fingerprint(s, c.place.path));
    outside.write("more", "b 2; #include \"more\"");
    marks.insert(fingerprint(s, c.place.path));
    EXPECT_EQ(marks.size(), 4u);
}


TEST(variantDirectory, namesWhatFailed)
{
    const smallStudy c;
    const auto failure = [&](const std::string& keys)
    {
        const studyDict s = c.study(keys + parameters);
        const auto all = allVariants(s);
        const variantDirectory d
        (
            s, c.place.path, fingerprint(s, c.place.path), all[0]
        );
        d.prepare();
        return messageOf([&] { d.run(); });
    };
    expectIn
    (
        "code 3:\n    because",
        failure("error { functionObject e; } commands"
            " (\"echo because\" \"exit 3\" \"echo not this\");")
    );
    expectIn
    (
        "longer than timeLimit",
        failure("timeLimit 0.2; error { functionObject e; } commands"
            " (\"sleep 30\");")
    );
    expectIn
    (
        "left no cost.dat",
        failure("error { functionObject e; } commands (\"true\");")
    );
    expectIn
    (
        "There are 2 tables cost*.dat",
        failure("error { functionObject e; } commands (\"mkdir -p"
            " postProcessing/e/1\" \"cd postProcessing/e\""
            " \"touch cost.dat 1/cost.dat 1/cost_1.dat\");")
    );
    expectIn
    (
        "negative, -2",
        failure("error { command \"echo -2\"; direct yes; } commands (\""
            "printf 'Device      : d, double precision\\n, spacing 1,\\n"
            "deltaT = 1\\nTime = 1\\nParticle-steps = 1 loop = 1 s total = 1 s"
            " ranks = 1 rate\\n'\");")
    );
}


TEST(studyDict, annotatedIsReadToTheEnd)
{
    const scratch c;
    for (const char* file : {"controlDict", "particleSchemes",
        "seedParticlesDict", "decomposeParDict", "studyDict"})
    {
        std::filesystem::create_directories(c.path/"system");
        std::filesystem::copy_file
        (
            std::filesystem::path(FSI_ANNOTATED)/file, c.path/"system"/file
        );
    }
    testing::internal::CaptureStderr();
    const studyDict s = studyDict::read(c.path);
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    EXPECT_EQ(allVariants(s).size(), 16u);
    EXPECT_EQ(s.commands.at(1).substr(0, 13), "if [ $ranks =");
}
