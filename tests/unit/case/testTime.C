#include "timeCase.H"

#include "case/argList.H"

#include <csignal>
#include <cmath>

using namespace gpuFsi;

using timeTest = timeCase;

TEST_F(timeTest, namesAreAsAnOstreamPrintsThem)
{
    for (const auto& [format, flag] :
    {
        std::pair<std::string, std::ios::fmtflags>{"general", {}},
        {"fixed", std::ios::fixed},
        {"scientific", std::ios::scientific}
    })
    {
        for (int precision : {3, 6, 12})
        {
            control
            (
                "deltaT 1; endTime 1; writeInterval 1; timeFormat " + format
              + "; timePrecision " + std::to_string(precision) + ";"
            );
            const Time time(path);
            for (double t : {0., 0.005, 1e-5, 1./3, 1234567.8, -0.25, 1e22})
            {
                std::ostringstream oracle;
                oracle.setf(flag, std::ios::floatfield);
                oracle.precision(precision);
                oracle << t;
                EXPECT_EQ(time.timeName(t), oracle.str());
            }
        }
    }
}

TEST_F(timeTest, findsTimeFolders)
{
    for (const char* name :
        {"1e-05", "10", "2.5", "constant", "0.orig", "nan", ".5.partial",
         "processor0", "-1"})
    {
        std::filesystem::create_directories(path/name);
    }
    put("3", "a file");
    EXPECT_EQ(folders(), (words{"-1", "0", "1e-05", "2.5", "10"}));
}

TEST_F(timeTest, selectsTimes)
{
    put("system/controlDict", "");
    const std::vector<instant> all
        {{"0", 0}, {"0.1", 0.1}, {"10", 10}, {"20", 20}, {"40", 40}};
    const auto select = [&](std::vector<std::string> arguments)
    {
        arguments.insert(arguments.begin(), {"app", "-case", path.string()});
        std::vector<char*> argv;
        for (std::string& a : arguments)
        {
            argv.push_back(a.data());
        }
        const argList args
        (
            int(argv.size()),
            argv.data(),
            "",
            {
                {"time", "ranges", ""},
                {"latestTime", "", ""},
                {"noZero", "", ""}
            }
        );
        words names;
        for (const instant& t : selectTimes(all, args))
        {
            names.push_back(t.name);
        }
        return names;
    };
    EXPECT_EQ(select({}), (words{"0", "0.1", "10", "20", "40"}));
    EXPECT_EQ(select({"-noZero"}), (words{"0.1", "10", "20", "40"}));
    EXPECT_EQ(select({"-latestTime"}), (words{"40"}));
    EXPECT_EQ(select({"-time", ":10,40:70"}), (words{"0", "0.1", "10", "40"}));
    EXPECT_EQ(select({"-time", "0.1,20:"}), (words{"0.1", "20", "40"}));
    EXPECT_EQ(select({"-time", "0"}), (words{"0"}));
    EXPECT_TRUE
    (
        says
        (
            errorOf([&] { select({"-time", "5"}); }),
            "none of the times of the case: 0 0.1 10 20 40"
        )
    );
    EXPECT_TRUE(says(errorOf([&] { select({"-time", "a:"}); }), "'a'"));
}

TEST_F(timeTest, startsWhereAsked)
{
    std::filesystem::create_directories(path/"0.5");
    std::filesystem::create_directories(path/"2");
    const std::string rest = "deltaT 1; endTime 9; writeInterval 1;";
    const auto start = [&](const std::string& from)
    {
        control(from + rest);
        return Time(path).startPath().filename().string();
    };
    EXPECT_EQ(start(""), "2");
    EXPECT_EQ(start("startFrom firstTime;"), "0");
    EXPECT_EQ(start("startFrom startTime; startTime 0.5;"), "0.5");
    EXPECT_TRUE
    (
        says
        (
            controlError("startFrom startTime; startTime 0.7;" + rest),
            "no folder of startTime 0.7"
        )
    );
    EXPECT_TRUE
    (
        says
        (
            controlError("startFrom startTime; startTime 0.7;" + rest),
            "there are: 0 0.5 2"
        )
    );
    for (const char* name : {"0", "0.5", "2"})
    {
        std::filesystem::remove(path/name);
    }
    EXPECT_TRUE(says(controlError(rest), "Run seedParticles first"));
}

TEST_F(timeTest, rejectsBadControls)
{
    const auto rejects =
        [&](const std::string& entries, const std::string& message)
    {
        const std::string error = controlError(entries);
        EXPECT_TRUE(says(error, message));
        EXPECT_TRUE(says(error, "controlDict"));
    };
    rejects("endTime 1; writeInterval 1;", "deltaT");
    rejects("deltaT 0; endTime 1; writeInterval 1;", "deltaT must be pos");
    rejects("deltaT 1; writeInterval 1;", "endTime");
    rejects("deltaT 1; endTime 1; writeInterval 0.5;", "0.5 < 1 for");
    rejects("deltaT 1; endTime 1; writeInterval 1.5;", "not a whole number");
    rejects
    (
        "deltaT 1; endTime 1; writeControl everyNow; writeInterval 1;",
        "everyNow"
    );
    rejects
    (
        "deltaT 1; endTime 1; writeInterval 1; writeNowSignal 9;",
        "not a signal"
    );
    rejects("deltaT 1; endTime 1; writeInterval 1; maxCo -1;", "maxCo");
}

TEST_F(timeTest, entriesOfOthersCountAsKnown)
{
    control
    (
        "deltaT 1; endTime 1; startTime 0; writeInterval 1; libs (); "
        "functions {} backend cpu; maxC 1;"
    );
    const std::vector<std::string> unread =
        Time(path).controlDict().unread();
    ASSERT_EQ(unread.size(), 2u);
    EXPECT_TRUE(says(unread[0], "backend"));
    EXPECT_TRUE(says(unread[1], "maxC"));
}

TEST_F(timeTest, writesEveryNSteps)
{
    control("deltaT 0.1; endTime 1; writeInterval 3;");
    Time time(path);
    EXPECT_EQ(runAndWrite(time), (words{"0.3", "0.6", "0.9"}));
    EXPECT_EQ(time.index(), 10);
    EXPECT_EQ(time.value(), 10*0.1);
    EXPECT_DOUBLE_EQ(time.fractionDone(), 1);
    EXPECT_EQ(text("0.3/content"), "whole");
}

TEST_F(timeTest, writesEveryInterval)
{
    control
    (
        "deltaT 0.3; endTime 2.05; writeControl runTime; writeInterval 0.5;"
    );
    Time time(path);
    // The step nearest to each multiple, as OpenFOAM's half a step ahead
    EXPECT_EQ(runAndWrite(time), (words{"0.6", "0.9", "1.5", "2.1"}));
}

TEST_F(timeTest, meetsWriteTimes)
{
    control
    (
        "deltaT 0.3; endTime 2; writeControl adjustableRunTime;"
        "writeInterval 0.5;"
    );
    Time time(path);
    EXPECT_EQ(runAndWrite(time), (words{"0.5", "1", "1.5", "2"}));
    EXPECT_EQ(time.index(), 8);
    EXPECT_EQ(time.value(), 2);
}

TEST_F(timeTest, writesByTheClock)
{
    for (const char* kind : {"clockTime", "cpuTime"})
    {
        control
        (
            std::string("deltaT 1; endTime 1e9; writeControl ") + kind
          + "; writeInterval 0.02;"
        );
        Time time(path);
        long written = 0;
        while (written < 3)
        {
            ++time;
            written += time.writeTime();
        }
        const double seconds = kind[1] == 'l'
            ? time.clockSeconds()
            : time.cpuSeconds();
        EXPECT_GE(seconds, 0.06);
    }
}

TEST_F(timeTest, neverWritesUnderNone)
{
    control("deltaT 1; endTime 5; writeControl none;");
    Time time(path);
    EXPECT_TRUE(runAndWrite(time).empty());
}

TEST_F(timeTest, stops)
{
    const std::string rest =
        "deltaT 1; endTime 9; startTime 0; startFrom startTime;"
        "writeInterval 3;";
    const auto steps = [&](const std::string& stopAt, const words& written)
    {
        control(rest + "stopAt " + stopAt + ";");
        Time time(path);
        EXPECT_EQ(runAndWrite(time), written) << stopAt;
        return time.index();
    };
    EXPECT_EQ(steps("endTime", {"3", "6", "9"}), 9);
    EXPECT_EQ(steps("noWriteNow", {}), 1);
    EXPECT_EQ(steps("writeNow", {"1"}), 1);
    EXPECT_EQ(steps("nextWrite", {"3"}), 3);
}

TEST_F(timeTest, adjustsDeltaT)
{
    control
    (
        "deltaT 0.1; endTime 9; writeInterval 1; adjustTimeStep yes;"
        "maxCo 0.5; maxDeltaT 0.11;"
    );
    Time time(path);
    time.adjustDeltaT(1);       // m = 0.5: cut at once
    EXPECT_DOUBLE_EQ(time.deltaT(), 0.05);
    time.adjustDeltaT(0.4);     // m = 1.25: 1 + 0.1 m
    EXPECT_DOUBLE_EQ(time.deltaT(), 0.05*1.125);
    time.adjustDeltaT(0.5/1.05);    // m = 1.05 is the least
    EXPECT_DOUBLE_EQ(time.deltaT(), 0.05*1.125*1.05);
    time.adjustDeltaT(0);       // at most 1.2
    EXPECT_DOUBLE_EQ(time.deltaT(), 0.05*1.125*1.05*1.2);
    for (int i = 0; i < 9; ++i)
    {
        time.adjustDeltaT(0.01);
    }
    EXPECT_EQ(time.deltaT(), 0.11);
    EXPECT_TRUE
    (
        says(errorOf([&] { time.adjustDeltaT(std::nan("")); }), "diverged")
    );
}

TEST_F(timeTest, adjustedStepsMeetWriteTimesWithinMaxCo)
{
    control
    (
        "deltaT 0.1; endTime 1; adjustTimeStep yes; maxCo 0.5;"
        "writeControl adjustable; writeInterval 0.25;"
    );
    Time time(path);
    words written;
    while (time.run())
    {
        // a flow whose Courant number is 7 deltaT
        time.adjustDeltaT(7*time.deltaT());
        EXPECT_LE(7*time.deltaT(), 0.5*(1 + 1e-12));
        ++time;
        if (time.writeTime())
        {
            written.push_back(time.timeName());
            EXPECT_EQ(time.value(), written.size()*0.25);
        }
    }
    EXPECT_EQ(written, (words{"0.25", "0.5", "0.75", "1"}));
}

TEST_F(timeTest, keepsNamesApart)
{
    control
    (
        "deltaT 1e-4; endTime 1.0003; writeInterval 1; timePrecision 3;"
        "startFrom latestTime;"
    );
    std::filesystem::create_directories(path/"1");
    Time time(path);
    EXPECT_EQ(runAndWrite(time), (words{"1.0001", "1.0002", "1.0003"}));
}

TEST_F(timeTest, tooSmallAStepIsAnError)
{
    std::filesystem::create_directories(path/"1");
    control("deltaT 1e-17; endTime 2; writeInterval 1;");
    Time time(path);
    EXPECT_TRUE(says(errorOf([&] { ++time; }), "too small to move time 1"));
}

TEST_F(timeTest, binaryIsNotCompressed)
{
    const std::string rest = "deltaT 1; endTime 1; writeInterval 1;";
    control(rest + "writeFormat binary; writeCompression on;");
    EXPECT_FALSE(Time(path).writing().compress);
    EXPECT_TRUE(Time(path).writing().binary);
    control(rest + "writeCompression compressed; writePrecision 12;");
    EXPECT_TRUE(Time(path).writing().compress);
    EXPECT_FALSE(Time(path).writing().binary);
    EXPECT_EQ(Time(path).writing().precision, 12);
}

TEST_F(timeTest, followsAChangedControlDict)
{
    const std::string rest = "runTimeModifiable yes; writeInterval 1;";
    control("deltaT 1; endTime 3;" + rest);
    Time time(path);
    ++time;
    control("deltaT 0.5; endTime 9;" + rest);
    ++time;
    EXPECT_EQ(time.value(), 1.5);
    EXPECT_EQ(time.endTime(), 9);
    control("deltaT -0.25; endTime 10;" + rest);    // broken
    ++time;
    EXPECT_EQ(time.value(), 2);
    EXPECT_EQ(time.endTime(), 9);
    control("deltaT 0.5; endTime 9; { ;" + rest);
    ++time;
    EXPECT_EQ(time.value(), 2.5);
    control("deltaT 0.5; endTime 9; stopAt writeNow;" + rest);
    ++time;
    EXPECT_TRUE(time.writeTime());
    EXPECT_FALSE(time.run());
}

TEST_F(timeTest, isDeafUnlessModifiable)
{
    control("deltaT 1; endTime 3; writeInterval 1;");
    Time time(path);
    control("deltaT 2; endTime 30; writeInterval 1;");
    ++time;
    EXPECT_EQ(time.value(), 1);
    EXPECT_EQ(time.endTime(), 3);
}

TEST_F(timeTest, signalsWriteAndStop)
{
    control
    (
        "deltaT 1; endTime 100; writeInterval 50; writeNowSignal 10;"
        "stopAtWriteNowSignal 12;"
    );
    for (int number : {12, SIGTERM, SIGINT})
    {
        Time time(path);
        ++time;
        EXPECT_FALSE(time.writeTime());
        std::raise(10);
        ++time;
        EXPECT_TRUE(time.writeTime());
        ++time;
        EXPECT_FALSE(time.writeTime());
        EXPECT_TRUE(time.run());
        ++time;
        std::raise(number);
        EXPECT_TRUE(time.writeTime());
        EXPECT_TRUE(time.writeTime());
        EXPECT_FALSE(time.run());
    }
}

TEST_F(timeTest, aSecondInterruptKills)
{
    control("deltaT 1; endTime 100; writeInterval 50;");
    EXPECT_EXIT
    (
        {
            Time time(path);
            std::raise(SIGINT);
            std::raise(SIGINT);
        },
        testing::KilledBySignal(SIGINT),
        ""
    );
}
