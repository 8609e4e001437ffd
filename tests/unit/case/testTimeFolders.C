#include "timeCase.H"

#include <cmath>
#include <cstring>

using namespace gpuFsi;

using timeFolders = timeCase;

TEST_F(timeFolders, appearWholeOrNotAtAll)
{
    control("deltaT 1; endTime 3; writeInterval 1;");
    Time time(path);
    ++time;
    write(time);
    const auto failingWrite = [&]
    {
        time.write([&](const std::filesystem::path& folder)
        {
            EXPECT_EQ(folder.filename(), "1");
            writeTextFile(folder/"content", "half");
            EXPECT_EQ(text("1/content"), "whole");
            EXPECT_EQ(folders(), (words{"0", "1"}));
            throw userError("the disk is full");
        });
    };
    EXPECT_THROW(failingWrite(), userError);
    EXPECT_EQ(text("1/content"), "whole");
    EXPECT_FALSE(exists(".1.partial"));
}

TEST_F(timeFolders, areReplacedAsAWhole)
{
    control("deltaT 1; endTime 3; writeInterval 1;");
    put("1/stale", "of another run");
    put(".1.partial/1/stale", "of a run that was killed");
    control("startFrom firstTime; deltaT 1; endTime 3; writeInterval 1;");
    Time time(path);
    ++time;
    write(time);
    EXPECT_EQ(text("1/content"), "whole");
    EXPECT_FALSE(exists("1/stale"));
    EXPECT_FALSE(exists(".1.partial"));
}

TEST_F(timeFolders, partialOnesAreNotTaken)
{
    put(".5.partial/5/content", "half");
    control("deltaT 1; endTime 3; writeInterval 1;");
    EXPECT_EQ(Time(path).startPath().filename(), "0");
}

TEST_F(timeFolders, asideIsNoTime)
{
    control("deltaT 1; endTime 3; writeInterval 1;");
    Time time(path);
    ++time;
    time.writeAside("diverged", [](const std::filesystem::path& folder)
    {
        writeTextFile(folder/"content", "whole");
    });
    EXPECT_EQ(text("diverged/content"), "whole");
    EXPECT_EQ(folders(), (words{"0"}));
}

TEST_F(timeFolders, purgeKeepsTheLastOfThisRun)
{
    std::filesystem::create_directories(path/"0.5");
    control
    (
        "startFrom firstTime; deltaT 1; endTime 5; writeInterval 1;"
        "purgeWrite 2;"
    );
    Time time(path);
    runAndWrite(time);
    EXPECT_EQ(folders(), (words{"0", "0.5", "4", "5"}));

    // A restart leaves alone what the first run wrote
    control("deltaT 1; endTime 8; writeInterval 1; purgeWrite 2;");
    Time restarted(path);
    runAndWrite(restarted);
    EXPECT_EQ(folders(), (words{"0", "0.5", "4", "5", "7", "8"}));
}

namespace
{

struct step
{
    double value, deltaT;
    long index;
    std::string name;
    bool written;

    bool operator==(const step& b) const
    {
        return std::memcmp(&value, &b.value, sizeof value) == 0
            && std::memcmp(&deltaT, &b.deltaT, sizeof deltaT) == 0
            && index == b.index && name == b.name && written == b.written;
    }
};

//- A flow whose Courant number depends on the time and nothing else
double courant(const Time& time)
{
    return (3 + 2*std::sin(9*time.value()))*time.deltaT();
}

std::vector<step> march(Time& time, long nSteps)
{
    std::vector<step> steps;
    while (time.run() && long(steps.size()) < nSteps)
    {
        time.adjustDeltaT(courant(time));
        ++time;
        const bool written = time.writeTime();
        if (written)
        {
            timeCase::write(time);
        }
        steps.push_back
        ({
            time.value(), time.deltaT(), time.index(), time.timeName(),
            written
        });
    }
    return steps;
}

} // namespace

TEST_F(timeFolders, aRestartTakesTheSameStepsBitForBit)
{
    for (const char* entries :
    {
        "deltaT 0.1; writeControl timeStep; writeInterval 7;",
        "deltaT 0.0123456789; writeControl timeStep; writeInterval 40;",
        "deltaT 0.07; writeControl runTime; writeInterval 0.33;",
        "deltaT 0.07; writeControl adjustableRunTime; writeInterval 0.3;",
        "deltaT 0.01; adjustTimeStep yes; maxCo 0.3; writeControl runTime;"
        "writeInterval 0.3;",
        "deltaT 0.01; adjustTimeStep yes; maxCo 0.3; writeControl adjustable;"
        "writeInterval 0.1;",
        "deltaT 1.1e-3; writeControl timeStep; writeInterval 90; "
        "timePrecision 2;"
    })
    {
        for (const instant& old : findTimes(path))
        {
            std::filesystem::remove_all(path/old.name);
        }
        std::filesystem::create_directories(path/"0");
        control(std::string(entries) + "endTime 4;");
        Time unbroken(path);
        const std::vector<step> all = march(unbroken, 100000);

        // Start again from every time written
        int nRestarts = 0;
        for (const instant& from : findTimes(path))
        {
            if (from.value == 0 || ++nRestarts > 6)
            {
                continue;
            }
            control
            (
                std::string(entries) + "endTime 4; startFrom startTime;"
                "startTime " + from.name + ";"
            );
            Time restarted(path);
            std::size_t first = 0;
            while (all[first].name != from.name || !all[first].written)
            {
                ++first;
            }
            const std::vector<step> again = march(restarted, 120);
            ASSERT_EQ
            (
                again.size(),
                std::min<std::size_t>(120, all.size() - first - 1)
            );
            for (std::size_t i = 0; i < again.size(); ++i)
            {
                ASSERT_TRUE(again[i] == all[first + 1 + i])
                    << entries << " from " << from.name << " step " << i
                    << ": " << again[i].name << " and "
                    << all[first + 1 + i].name;
            }
        }
        EXPECT_GT(nRestarts, 2) << entries;
    }
}

TEST_F(timeFolders, aRenamedFolderStartsAfresh)
{
    control("deltaT 0.1; endTime 1; writeInterval 5;");
    {
        Time time(path);
        runAndWrite(time);
    }
    std::filesystem::rename(path/"0.5", path/"7");
    control("deltaT 0.1; endTime 9; writeInterval 5;");
    Time time(path);
    EXPECT_EQ(time.value(), 7);
    EXPECT_EQ(time.index(), 0);
}

TEST_F(timeFolders, uniformTimeHoldsSeventeenDigits)
{
    control("deltaT 0.1; endTime 1; writeInterval 3;");
    Time time(path);
    runAndWrite(time);
    const dictionary state =
        dictionary::fromFile(path/"0.3/uniform/time");
    EXPECT_EQ(state.get<double>("value"), 3*0.1);
    EXPECT_EQ(state.get<std::string>("name"), "0.3");
    EXPECT_EQ(state.get<long>("index"), 3);
    EXPECT_EQ(state.get<double>("deltaT"), 0.1);
    EXPECT_EQ(state.get<double>("deltaT0"), 0.1);
}

TEST_F(timeFolders, readsOpenFOAMsUniformTime)
{
    put
    (
        "0.5/uniform/time",
        "FoamFile { version 2.0; format ascii; class dictionary; "
        "object time; }\nvalue 0.5;\nname \"0.5\";\nindex 50;\n"
        "deltaT 0.02;\ndeltaT0 0.01;\n"
    );
    control
    (
        "deltaT 0.01; endTime 1; writeInterval 5; adjustTimeStep yes;"
    );
    const Time adjusted(path);
    EXPECT_EQ(adjusted.index(), 50);
    EXPECT_EQ(adjusted.deltaT(), 0.02);
    control("deltaT 0.01; endTime 1; writeInterval 5;");
    EXPECT_EQ(Time(path).deltaT(), 0.01);
}
