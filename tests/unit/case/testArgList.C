#include "temporaryCase.H"

#include "case/argList.H"

using namespace gpuFsi;

namespace
{

class argListTest
:
    public temporaryCase
{
public:

    argList parse(std::vector<std::string> words, bool needsCase = true)
    {
        words.insert(words.begin(), "/bin/program");
        std::vector<char*> argv;
        for (std::string& word : words)
        {
            argv.push_back(word.data());
        }
        return argList
        (
            int(argv.size()),
            argv.data(),
            "Does something",
            {
                {"time", "ranges", "times to take"},
                {"latestTime", "", "take the latest time"}
            },
            needsCase
        );
    }

    std::string error(const std::vector<std::string>& words)
    {
        return errorOf([&] { parse(words); });
    }
};

} // namespace

TEST_F(argListTest, takesOptions)
{
    put("system/controlDict", "");
    const argList args = parse
    (
        {"-case", path.string(), "-time", "-1:2", "-latestTime"}
    );
    EXPECT_TRUE(args.found("latestTime"));
    EXPECT_EQ(args.get("time"), "-1:2");
    EXPECT_EQ(args.getOrDefault("dict", "other"), "other");
    EXPECT_EQ(args.casePath(), std::filesystem::canonical(path));
    EXPECT_EQ(args.caseName(), path.filename().string());
    EXPECT_EQ
    (
        args.commandLine(),
        "/bin/program -case " + path.string() + " -time -1:2 -latestTime"
    );
    EXPECT_TRUE(says(errorOf([&] { args.get("dict"); }), "-dict"));
}

TEST_F(argListTest, rejectsWhatItDoesNotKnow)
{
    EXPECT_TRUE(says(error({"-latesTime"}), "Invalid option: -latesTime"));
    EXPECT_TRUE(says(error({"-latesTime"}), "Did you mean -latestTime?"));
    EXPECT_TRUE(says(error({"stray"}), "Unexpected argument: stray"));
    EXPECT_TRUE(says(error({"-time"}), "needs a parameter <ranges>"));
    EXPECT_TRUE(says(error({"-time", "-latestTime"}), "needs a parameter"));
    EXPECT_TRUE
    (
        says(error({"-latestTime", "-latestTime"}), "given twice")
    );
}

TEST_F(argListTest, looksForTheCase)
{
    EXPECT_TRUE(says(error({"-case", "/no/such"}), "/no/such does not exist"));
    EXPECT_TRUE
    (
        says(error({"-case", path.string()}), "no file system/controlDict")
    );
    EXPECT_NO_THROW(parse({"-case", path.string()}, false));
}

TEST_F(argListTest, helpExitsWithZero)
{
    EXPECT_EXIT(parse({"-help"}), testing::ExitedWithCode(0), "");
}
