// Runs that are told to write or to stop, or that are killed.
#include "systemCase.H"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <functional>
#include <thread>

namespace
{

constexpr const char* control = "system/controlDict";

void pause(int milliseconds)
{
    std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
}

bool comes(const std::function<bool()>& event)
{
    for (int i = 0; i < 10000 && !event(); ++i)
    {
        pause(1);
    }
    return event();
}

//- A run without an end that is told what to do by signals
systemCase endless()
{
    systemCase c = systemCase::piston();
    c.set(control, "endTime", "1e9");
    c.set(control, "deltaT", "0.001");
    c.set(control, "writeInterval", "1000000000");
    c.add(control, "writeNowSignal 10;");
    c.add(control, "stopAtWriteNowSignal 12;");
    c.add(control, "timePrecision 12;");
    c.seed();
    return c;
}

//- Has the log told of a step?
bool stepping(const process& p)
{
    return p.output().find("\nTime = ") != std::string::npos;
}

std::string valueOf(const systemCase& c, const std::string& key)
{
    const std::string text = c.text(c.timeNames().back() + "/uniform/time");
    const std::size_t at = text.find(key + ' ') + key.size();
    const std::size_t begin = text.find_first_not_of(' ', at);
    return text.substr(begin, text.find(';', at) - begin);
}

//- The stopped run's latest folder, as a run from 0 writes it in one go
void expectAsUnbroken(const systemCase& stopped)
{
    systemCase whole(stopped);
    whole.remove(stopped.timeNames().back());
    whole.set(control, "endTime", valueOf(stopped, "value"));
    whole.set(control, "writeInterval", valueOf(stopped, "index"));
    const outcome o = whole.run(app::gpuFsiFoam);
    ASSERT_EQ(o.code, 0) << o.out << o.err;
    fileTree found = stopped.times(), wanted = whole.times();
    const std::string time = stopped.timeNames().back() + "/uniform/time";
    found.erase(time);
    wanted.erase(time);    // tells the writeInterval
    EXPECT_EQ(difference(found, wanted), "");
}

//- Twice the same from the latest time, 200 steps on
void expectGoesOn(const systemCase& stopped)
{
    systemCase first(stopped);
    first.set(control, "startFrom", "latestTime");
    const double end = std::stod(valueOf(stopped, "value")) + 0.2;
    first.set(control, "endTime", std::to_string(end));
    first.set(control, "writeInterval", "100");
    const systemCase second(first);
    const systemCase& once = first;
    for (const systemCase* c : {&once, &second})
    {
        const outcome o = c->run(app::gpuFsiFoam);
        EXPECT_EQ(o.code, 0) << o.out << o.err;
        EXPECT_NE(o.out.find("\nEnd"), std::string::npos);
    }
    EXPECT_GT(first.timeNames().size(), stopped.timeNames().size());
    EXPECT_EQ(difference(first.times(), second.times()), "");
}

} // namespace


TEST(signals, stopWritesAndExitsCleanly)
{
    for (const int number : {SIGTERM, SIGINT, SIGUSR2})
    {
        SCOPED_TRACE(number);
        const systemCase c = endless();
        process p(c.words(app::gpuFsiFoam), c.path());
        ASSERT_TRUE(comes([&] { return stepping(p); })) << p.output();
        p.signal(number);
        const outcome o = p.wait();
        EXPECT_EQ(o.code, 0) << o.err;
        EXPECT_NE(o.out.find("\nEnd"), std::string::npos);
        ASSERT_EQ(c.timeNames().size(), 2u);
        expectAsUnbroken(c);
        expectGoesOn(c);
    }
}


TEST(signals, writeNowGoesOn)
{
    const systemCase c = endless();
    process p(c.words(app::gpuFsiFoam), c.path());
    ASSERT_TRUE(comes([&] { return stepping(p); })) << p.output();
    p.signal(SIGUSR1);
    ASSERT_TRUE(comes([&] { return c.timeNames().size() == 2; }));
    const std::string first = c.timeNames().back();
    EXPECT_TRUE(p.running());
    pause(20);
    p.signal(SIGTERM);
    EXPECT_EQ(p.wait().code, 0);
    const std::vector<std::string> names = c.timeNames();
    ASSERT_EQ(names.size(), 3u);

    // From the first folder to the second is the same again
    systemCase again(c);
    again.set(control, "startFrom", "latestTime");
    again.set(control, "endTime", names[2]);
    again.set(control, "writeInterval", valueOf(c, "index"));
    again.remove(names[2]);
    process q(again.words(app::gpuFsiFoam), again.path());
    EXPECT_EQ(q.wait().code, 0);
    EXPECT_EQ
    (
        difference
        (
            within(again.tree(), names[2] + "/lagrangian"),
            within(c.tree(), names[2] + "/lagrangian")
        ),
        ""
    );
}


//- However it ends, every time folder is whole
TEST(signals, killedWhileWriting)
{
    for (int delay = 20; delay < 70; delay += 10)
    {
        systemCase c = endless();
        c.set(control, "writeInterval", "1");
        process p(c.words(app::gpuFsiFoam), c.path());
        ASSERT_TRUE(comes([&] { return c.timeNames().size() > 1; }));
        pause(delay);
        p.signal(SIGKILL);
        EXPECT_EQ(p.wait().code, 128 + SIGKILL);
        c.set(control, "writeInterval", "1000000000");
        expectGoesOn(c);
    }
}
