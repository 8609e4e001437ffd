// Which sequences of launches are captured, and that the CPU just runs them.
// That results keep their bytes on a GPU: testGraphs.C of solid and coupling.

#include "device/backend.H"
#include "device/launchGraph.H"
#include "device/repeatedKeys.H"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <type_traits>

using namespace gpuFsi;

namespace
{

//- p: plain, c: captured, r: replayed, by turn of these keys
std::string ways(const std::string& sequence)
{
    repeatedKeys keys;
    std::string told;
    for (const char letter : sequence)
    {
        const auto key = launchKey(letter);
        const auto turn = keys.next(key.data(), key.size());
        if (turn.how == repeatedKeys::way::capture)
        {
            keys.captured(turn.slot);
        }
        told += "pcr"[int(turn.how)];
    }
    return told;
}

} // namespace


TEST(launchGraph, onTheCpuLoopsRunEachTime)
{
    launchGraph<cpuBackend> graph;
    int runs = 0;
    for (int k = 0; k < 10; ++k)
    {
        graph.run(launchKey(1.5), [&] { ++runs; });
        EXPECT_EQ(runs, k + 1);
    }
    EXPECT_EQ(graph.replays(), 0);
}


TEST(launchGraph, onTheCpuItHoldsNothing)
{
    EXPECT_TRUE(std::is_empty_v<launchGraph<cpuBackend>>);
}


TEST(launchGraph, anErrorInALoopGoesUp)
{
    launchGraph<cpuBackend> graph;
    const auto bad = [] { throw std::runtime_error("a loop"); };
    EXPECT_THROW(graph.run(launchKey(1), bad), std::runtime_error);
}


TEST(launchGraph, keysDifferWhereAnyPartDoes)
{
    const double x[2] = {0, 0};
    const auto key = launchKey(0.1, 3, true, &x[0]);
    EXPECT_EQ(key, launchKey(0.1, 3, true, &x[0]));
    EXPECT_NE(key, launchKey(0.1000000001, 3, true, &x[0]));
    EXPECT_NE(key, launchKey(0.1, 4, true, &x[0]));
    EXPECT_NE(key, launchKey(0.1, 3, false, &x[0]));
    EXPECT_NE(key, launchKey(0.1, 3, true, &x[1]));
}


TEST(repeatedKeys, aSequenceThatComesAgainIsCapturedOnce)
{
    EXPECT_EQ(ways("aaaaaa"), "pppcrr");
}


TEST(repeatedKeys, twoThatTakeTurnsAreBothKept)
{
    EXPECT_EQ(ways("abababababab"), "ppppppccrrrr");
}


TEST(repeatedKeys, aThirdTakesThePlaceOfTheOldest)
{
    EXPECT_EQ(ways("aaaabbbbacccccab"), "pppcpppcrpppcrrp");
}


TEST(repeatedKeys, whatChangesEachTimeIsNeverCaptured)
{
    EXPECT_EQ(ways("abcabcabcabcabc"), std::string(15, 'p'));
}


TEST(repeatedKeys, aKeyThatComesBackStartsAnew)
{
    EXPECT_EQ(ways("aaaaabcaaaaa"), "pppcrpppppcr");
}
