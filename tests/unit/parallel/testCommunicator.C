// What ranks tell each other.

#include "theRanks.H"

#include "base/error.H"
#include "parallel/agreedError.H"

#include <gtest/gtest.h>

using namespace gpuFsi;

TEST(communicator, sumsAndMaxima)
{
    const communicator& c = *theRanks;
    std::int64_t n[2] = {c.rank(), 1};
    c.sum(n, 2);
    EXPECT_EQ(n[0], c.size()*(c.size() - 1)/2);
    EXPECT_EQ(n[1], c.size());
    double most[2] = {double(c.rank()), -double(c.rank())};
    c.max(most, 2);
    EXPECT_EQ(most[0], c.size() - 1);
    EXPECT_EQ(most[1], 0);
    EXPECT_TRUE(c.any(c.rank() == c.size() - 1));
    EXPECT_FALSE(c.any(false));
    EXPECT_TRUE(c.same(77));
    EXPECT_EQ(c.same(c.rank()), c.size() == 1);
}


TEST(communicator, everyRankIsAmongThoseOfItsNode)
{
    const std::vector<int> near = theRanks->ranksOnNode();
    ASSERT_LT(theRanks->rankOnNode(), int(near.size()));
    EXPECT_EQ(near[theRanks->rankOnNode()], theRanks->rank());
    EXPECT_TRUE(std::is_sorted(near.begin(), near.end()));
}


TEST(communicator, exchangesAnyLengths)
{
    const communicator& c = *theRanks;
    // To rank r: rank + 1 times r values
    std::vector<std::vector<char>> out(c.size());
    for (int r = 0; r < c.size(); ++r)
    {
        out[r] = bytesOf(std::vector<int>((c.rank() + 1)*r, 10*c.rank() + r));
    }
    const auto in = c.exchange(out);
    for (int r = 0; r < c.size(); ++r)
    {
        std::vector<int> got;
        appendFrom(in[r], got);
        EXPECT_EQ(got, std::vector<int>((r + 1)*c.rank(), 10*r + c.rank()));
    }
}


TEST(communicator, gathersInOrderOfRank)
{
    const communicator& c = *theRanks;
    std::vector<int> expected;
    for (int r = 0; r < c.size(); ++r)
    {
        expected.insert(expected.end(), r, r);
    }
    const std::vector<int> mine(c.rank(), c.rank());
    EXPECT_EQ(gatherAll(c, mine), expected);
    EXPECT_EQ
    (
        gatherOnMaster(c, mine), c.master() ? expected : std::vector<int>()
    );
}


TEST(communicator, anErrorOfOneIsThrownOnAll)
{
    const communicator& c = *theRanks;
    c.agree([] {});
    const auto fail = [&]
    {
        if (c.rank() >= c.size() - 2)
        {
            throw userError
            (
                "rank " + std::to_string(c.rank()) + " fails", {}, "Mend it."
            );
        }
    };
    try
    {
        c.agree(fail);
        FAIL() << "nothing was thrown";
    }
    catch (const std::exception& e)
    {
        const int lowest = std::max(0, c.size() - 2);
        EXPECT_NE
        (
            std::string(e.what()).find
            (
                "rank " + std::to_string(lowest) + " fails"
            ),
            std::string::npos
        ) << e.what();
    }
}
