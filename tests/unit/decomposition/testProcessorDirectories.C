#include "decomposition/decomposeParDict.H"
#include "decomposition/processorDirectories.H"
#include "unit/case/temporaryCase.H"

#include <gtest/gtest.h>

using namespace gpuFsi;
namespace fs = std::filesystem;

namespace
{

class processorDirectories
:
    public temporaryCase
{
protected:

    void folder(const std::string& name) const
    {
        fs::create_directories(path/name);
    }
};

using decomposeParDictFile = temporaryCase;

} // namespace


TEST_F(processorDirectories, countsAndFindsGaps)
{
    EXPECT_EQ(nProcessors(path), 0);
    EXPECT_TRUE(completeTimes(path).empty());
    folder("processor0");
    folder("processor1");
    folder("processors3");
    EXPECT_EQ(nProcessors(path), 2);
    folder("processor3");
    EXPECT_TRUE(says(errorOf([&] { nProcessors(path); }),
        "There are 3 processor directories in"));
    EXPECT_TRUE(says(errorOf([&] { nProcessors(path); }), "no processor2"));
}


TEST_F(processorDirectories, knowsHowManyThereWere)
{
    decompositionRecord r;
    r.numberOfSubdomains = 3;
    r.clouds["fluid"] = 1000;
    for (const char* p : {"processor0", "processor1", "processor2"})
    {
        r.write(path/p);
    }
    EXPECT_EQ(nProcessors(path), 3);
    EXPECT_EQ(decompositionRecord::read(path/"processor1").clouds.at("fluid"),
        1000u);
    fs::remove_all(path/"processor2");
    EXPECT_TRUE(says(errorOf([&] { nProcessors(path); }),
        "was decomposed for 3"));
}


TEST_F(processorDirectories, timesOfAllOrOfSome)
{
    folder("processor0/0");
    folder("processor0/0.1");
    folder("processor0/10");
    folder("processor1/0");
    folder("processor1/10");
    folder("processor1/.0.2.partial/0.2");
    const auto complete = completeTimes(path);
    ASSERT_EQ(complete.size(), 2u);
    EXPECT_EQ(complete[0].name, "0");
    EXPECT_EQ(complete[1].value, 10);
    const auto incomplete = incompleteTimes(path);
    ASSERT_EQ(incomplete.size(), 1u);
    EXPECT_EQ(incomplete[0].time.name, "0.1");
    EXPECT_EQ(incomplete[0].nProcessors, 1);
}


TEST_F(decomposeParDictFile, defaults)
{
    put("system/decomposeParDict", "numberOfSubdomains 4; method hilbert;");
    const auto d = decomposeParDict::read(path);
    EXPECT_EQ(d.numberOfSubdomains, 4);
    EXPECT_EQ(d.methodName, "hilbert");
    EXPECT_TRUE(d.method);
    EXPECT_EQ(d.weights.fluid, 1);
    EXPECT_EQ(d.weights.wall, 0.3);
    EXPECT_TRUE(d.balance.active);
    EXPECT_EQ(d.balance.limit, 1.2);
    EXPECT_FALSE(d.balance.every);
    EXPECT_EQ(d.transport, decomposeParDict::transportMode::automatic);
}


TEST_F(decomposeParDictFile, everything)
{
    put
    (
        "system/decomposeParDict",
        "numberOfSubdomains 4; method simple; simpleCoeffs { n (2 2 1); }"
        "manualCoeffs { dataFile \"x\"; } weights { fluid 2; wall 0; }"
        "balance { limit 1.05; every yes; } transport staged;"
    );
    testing::internal::CaptureStderr();
    const auto d = decomposeParDict::read(path);
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    EXPECT_EQ(d.weights.fluid, 2);
    EXPECT_EQ(d.weights.wall, 0);
    EXPECT_EQ(d.balance.limit, 1.05);
    EXPECT_TRUE(d.balance.every);
    EXPECT_EQ(d.transport, decomposeParDict::transportMode::staged);
    put
    (
        "system/decomposeParDict",
        "numberOfSubdomains 4; method hilbert; balance no;"
    );
    EXPECT_FALSE(decomposeParDict::read(path).balance.active);
}


TEST_F(decomposeParDictFile, annotatedIsReadToTheEnd)
{
    fs::copy_file(FSI_ANNOTATED, path/"system/decomposeParDict");
    testing::internal::CaptureStderr();
    EXPECT_EQ(decomposeParDict::read(path).numberOfSubdomains, 4);
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}


TEST_F(decomposeParDictFile, refusesWhatIsWrong)
{
    const auto refuses = [&](const char* text, const char* message)
    {
        if (*text)
        {
            put("system/decomposeParDict", text);
        }
        EXPECT_TRUE(says
        (
            errorOf([&] { decomposeParDict::read(path); }), message
        ));
    };
    refuses("", "numberOfSubdomains 2;");
    refuses("method hilbert;", "numberOfSubdomains");
    refuses("numberOfSubdomains 2;", "method");
    refuses("numberOfSubdomains 0; method hilbert;", "numberOfSubdomains");
    refuses("numberOfSubdomains 2.5; method hilbert;", "numberOfSubdomains");
    refuses("numberOfSubdomains 2; method hilbert; balance { limit 0.9; }",
        "limit");
    refuses("numberOfSubdomains 2; method hilbert; weights { wall -1; }",
        "wall");
    refuses("numberOfSubdomains 2; method hilbert; transport fast;",
        "staged");
}
