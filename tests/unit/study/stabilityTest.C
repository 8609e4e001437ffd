#include "scratch.H"
#include "study/stabilityReport.H"
#include "study/stabilityRun.H"

#include <cmath>
#include <csignal>

using namespace gpuFsi;

namespace
{

const char* const axes =
    "parameters { x { values (1 2 3); } y { values (a b); } } ";

//- A case whose commands do what x and y say
struct smallMap
{
    scratch place;

    smallMap()
    {
        place.write("system/controlDict", "deltaT 1;\n");
    }

    stabilityDict map(const std::string& keys) const
    {
        place.write("system/stabilityDict", keys);
        return stabilityDict::read(place.path);
    }

    stabilityRecord run(const std::string& command) const
    {
        const stabilityDict m = map
        (
            "commands (\"" + command + "\"); timeLimit 0.5; error { command "
            "\"cat number\"; direct yes; limit 0.1; } "
            "parameters { x { values (1); } }"
        );
        const variant v = allVariants(m)[0];
        const stabilityDirectory d
        (
            m, place.path, fingerprint(m, place.path), v
        );
        d.prepare();
        return d.run();
    }
};

commandOutcome ended(int code, bool timedOut = false)
{
    return {code, timedOut, 1};
}

const std::string fatal = "\n--> FOAM FATAL ERROR: \n";

stabilityResult resultAt
(
    const stabilityDict& m,
    std::size_t i,
    outcome kind,
    double error
)
{
    return {allVariants(m)[i], stabilityRecord{kind, error, 2, "said, so"}};
}

} // namespace


TEST(outcome, isToldByCodeAndLog)
{
    EXPECT_EQ(outcomeOf(ended(0), ""), outcome::accurate);
    EXPECT_EQ(outcomeOf(ended(1), fatal + "Bad"), outcome::refused);
    EXPECT_EQ
    (
        outcomeOf(ended(1), "\nTime = 1\n" + fatal + "Bad"), outcome::stopped
    );
    EXPECT_EQ
    (
        outcomeOf(ended(1), fatal + "The solution broke down at Time = 3: x"),
        outcome::stopped
    );
    EXPECT_EQ(outcomeOf(ended(128 + SIGSEGV), fatal), outcome::crashed);
    EXPECT_EQ(outcomeOf(ended(128 + SIGTERM, true), ""), outcome::hung);
    EXPECT_EQ(outcomeOf(ended(1), "nothing"), outcome::failed);
    EXPECT_EQ(outcomeOf(ended(127), fatal), outcome::failed);
}


TEST(outcome, hasAName)
{
    for (int i = 0; i < nOutcomes; ++i)
    {
        EXPECT_EQ(outcomeNamed(nameOf(outcome(i))), outcome(i));
    }
    expectIn("did you mean", messageOf([] { outcomeNamed("stoped"); }));
    EXPECT_TRUE(allowed(outcome::stopped));
    EXPECT_FALSE(allowed(outcome::diverged));
}


TEST(outcome, findsWhatIsNotFinite)
{
    const scratch s;
    s.write("postProcessing/e/0/a.dat", "# Time\tinf\n0\tnan\n1\t2\n");
    EXPECT_TRUE(notFinite(s.path).empty());
    const auto bad = s.write("postProcessing/e/0/b.dat", "1\t(-nan 0)\n");
    EXPECT_EQ(notFinite(s.path), bad);
}


TEST(stabilityRecord, isKept)
{
    const scratch s;
    stabilityRecord r{outcome::stopped, 0.1, 3, "broke down at 2"};
    writeRecord(s.path/"r", r);
    const stabilityRecord a = readStabilityRecord(s.path/"r");
    EXPECT_EQ(a.kind, r.kind);
    EXPECT_EQ(a.error, r.error);
    EXPECT_EQ(a.word, r.word);
    r = {};
    writeRecord(s.path/"r", r);
    EXPECT_TRUE(std::isnan(readStabilityRecord(s.path/"r").error));
    EXPECT_EQ(readStabilityRecord(s.path/"r").word, "");
}


TEST(stabilityDirectory, tellsHowARunEnded)
{
    const smallMap c;
    EXPECT_EQ(c.run("echo 0.1 > number").kind, outcome::accurate);
    const stabilityRecord far = c.run("echo 0.2 > number");
    EXPECT_EQ(far.kind, outcome::inaccurate);
    EXPECT_EQ(far.error, 0.2);
    EXPECT_EQ(c.run("sleep 20").kind, outcome::hung);
    EXPECT_EQ(c.run("kill -SEGV $$").kind, outcome::crashed);
    EXPECT_EQ(c.run("true").kind, outcome::failed);
    const stabilityRecord refused =
        c.run("echo '--> FOAM FATAL ERROR: '; echo 'because of'; exit 1");
    EXPECT_EQ(refused.kind, outcome::refused);
    expectIn("because of", refused.word);
    EXPECT_EQ
    (
        c.run("echo 0 > number; mkdir -p postProcessing/e; echo nan > "
            "postProcessing/e/x.dat").kind,
        outcome::diverged
    );
}


TEST(stabilityRun, goesOnButRunsTheBadAgain)
{
    const smallMap c;
    const stabilityDict m = c.map
    (
        std::string(axes) + "commands (\"echo $x$y >> ../order\" "
        "\"if [ $x = 2 ]; then exit 3; fi\"); "
        "error { command \"echo $x\"; direct yes; limit 1.5; }"
    );
    {
        stabilityRun runs(m, c.place.path);
        runs.run();
        EXPECT_EQ(runs.nBad(), 2u);
        EXPECT_EQ(runs.results()[0].record->kind, outcome::accurate);
        EXPECT_EQ(runs.results()[2].record->kind, outcome::inaccurate);
    }
    stabilityRun runs(m, c.place.path);
    EXPECT_FALSE(runs.results()[1].record);
    EXPECT_TRUE(runs.results()[2].record);
    runs.run();
    std::ifstream order(c.place.path/"studyStability/order");
    const std::string text{std::istreambuf_iterator<char>(order), {}};
    EXPECT_EQ(text, "1a\n2a\n3a\n1b\n2b\n3b\n2a\n2b\n");
    runs.forget();
    EXPECT_FALSE(stabilityRun(m, c.place.path).results()[2].record);
}


TEST(stabilityGrid, tellsBoundaries)
{
    const smallMap c;
    const stabilityDict m = c.map
    (
        std::string(axes) + "commands (\"true\"); "
        "error { functionObject e; limit 1; } "
        "skip { one { x 2; y b; } }"
    );
    const std::vector<stabilityResult> results
    {
        resultAt(m, 0, outcome::accurate, 0.5),
        resultAt(m, 1, outcome::inaccurate, 2),
        resultAt(m, 2, outcome::hung, NAN),
        resultAt(m, 3, outcome::refused, NAN),
        resultAt(m, 4, outcome::refused, NAN)
    };
    const auto planes = planesOf(m, results);
    ASSERT_EQ(planes.size(), 1u);
    ASSERT_EQ(planes[0].rows.size(), 2u);
    EXPECT_EQ(planes[0].rows[1][1], nullptr);
    EXPECT_EQ
    (
        boundariesOf(m, planes[0].rows[0]),
        "accurate to 1; inaccurate at 2; hung from 3"
    );
    EXPECT_EQ(boundariesOf(m, planes[0].rows[1]), "refused");

    const std::string table = markdownOf(m, results);
    expectIn("1 accurate, 1 inaccurate, 2 refused, 1 hung", table);
    expectIn("| a | 0.5 | inaccurate, 2 | **hung** | accurate to 1;", table);
    expectIn("| b | refused |  | refused | refused |", table);
    expectIn("## Never allowed\n\n- x=3_y=a: hung", table);
    expectIn("2,a,inaccurate,2,2,\"said, so\"\n", csvOf(m, results));
    expectIn("0 0 0 0.5\n", gnuplotOf(m, results, "s"));
}


TEST(stabilityGrid, hasAPlaneForEachOfTheOthers)
{
    const smallMap c;
    const stabilityDict m = c.map
    (
        "parameters { z { values (8 9); } y { values (a b); } "
        "x { values (1 2 3); } } x x; y y; commands (\"true\"); "
        "error { functionObject e; limit 1; }"
    );
    std::vector<stabilityResult> results;
    for (std::size_t i = 0; i < 12; ++i)
    {
        results.push_back(resultAt(m, i, outcome::accurate, i));
    }
    const auto planes = planesOf(m, results);
    ASSERT_EQ(planes.size(), 2u);
    EXPECT_EQ(planes[1].name, "z 9");
    EXPECT_EQ(planes[1].rows[1][2]->record->error, 11);
}


TEST(stabilityDict, saysWhatIsWrong)
{
    const smallMap c;
    const auto wrong = [&](const std::string& text)
    {
        return messageOf([&] { c.map("commands (\"true\"); " + text); });
    };
    const std::string error = "error { functionObject e; limit 1; } ";
    expectIn("limit", wrong(std::string(axes) + "error { functionObject e; }"));
    expectIn
    (
        "no finest run",
        wrong(std::string(axes) + "error { command \"x\"; finest yes; }")
    );
    expectIn("are both x", wrong(axes + error + "x x; y x;"));
    expectIn("Unknown parameter", wrong(axes + error + "x z;"));
    expectIn
    (
        "both positive",
        wrong(error + "parameters { x { logarithmic (0 1 3); } }")
    );
    expectIn
    (
        "how many", wrong(error + "parameters { x { linear (0 1 1); } }")
    );
}


TEST(parameter, isSpacedEvenly)
{
    const auto labels = [](const std::string& text)
    {
        std::string all;
        for (const auto& choice :
            readParameter("p", dictionary::fromString(text)).choices)
        {
            all += choice.label + " ";
        }
        return all;
    };
    EXPECT_EQ(labels("linear (0 0.5 3);"), "0 0.25 0.5 ");
    EXPECT_EQ(labels("logarithmic (0.01 100 5);"), "0.01 0.1 1 10 100 ");
}


TEST(stabilityDict, annotatedIsReadToTheEnd)
{
    const scratch c;
    std::filesystem::create_directories(c.path/"system");
    for (const char* file : {"controlDict", "seedParticlesDict",
        "stabilityDict"})
    {
        std::filesystem::copy_file
        (
            std::filesystem::path(FSI_ANNOTATED)/file, c.path/"system"/file
        );
    }
    testing::internal::CaptureStderr();
    const stabilityDict m = stabilityDict::read(c.path);
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    EXPECT_EQ(m.directory, "studyStability");
    EXPECT_EQ(allVariants(m).size(), 99u);
}
