// Particles that are lost or held twice are noticed.

#include "theRanks.H"

#include "parallel/agreedError.H"
#include "parallel/ownPasses.H"
#include "parallel/rankCheck.H"

#include <gtest/gtest.h>

#include <numeric>

using namespace gpuFsi;

namespace
{

rankContents contentsOf(const std::vector<int>& ids, int lanes = 7)
{
    unsigned long long sum[2] = {0, 0};
    const idCheck check{ids.data(), 0, int(ids.size()), lanes, sum};
    for (int lane = 0; lane < lanes; ++lane)
    {
        check(lane);
    }
    return
    {
        0, std::int64_t(ids.size()), std::int64_t(sum[0]), std::int64_t(sum[1])
    };
}

std::vector<int> ownIds()
{
    std::vector<int> ids(50);
    std::iota(ids.begin(), ids.end(), 50*theRanks->rank());
    return ids;
}

std::string told(const rankCheck& check, const rankContents& c)
{
    try
    {
        check.compare(*theRanks, c);
    }
    catch (const agreedError& e)
    {
        return e.what();
    }
    return "";
}

} // namespace


TEST(rankCheck, sumsDependOnNothingButTheIds)
{
    std::vector<int> ids = ownIds();
    const rankContents a = contentsOf(ids);
    std::reverse(ids.begin(), ids.end());
    const rankContents b = contentsOf(ids, 3);
    EXPECT_EQ(a.ids, b.ids);
    EXPECT_EQ(a.mixed, b.mixed);
}


TEST(rankCheck, saysBothCountsWhereOneIsLost)
{
    const communicator& c = *theRanks;
    const rankCheck check(c, contentsOf(ownIds()));
    EXPECT_EQ(told(check, contentsOf(ownIds())), "");
    std::vector<int> ids = ownIds();
    if (c.master())
    {
        ids.pop_back();
    }
    const std::string what = told(check, contentsOf(ids));
    const std::string all = std::to_string(50*c.size());
    EXPECT_NE(what.find(std::to_string(50*c.size() - 1)), std::string::npos);
    EXPECT_NE(what.find(all), std::string::npos) << what;
}


TEST(rankCheck, noticesAnIdHeldForAnother)
{
    const communicator& c = *theRanks;
    const rankCheck check(c, contentsOf(ownIds()));
    std::vector<int> ids = ownIds();
    if (c.master())
    {
        // The sum of ids stays what it was
        ids[10] += 1;
        ids[11] -= 1;
        ids[20] += 1;
        ids[30] -= 1;
    }
    EXPECT_NE(told(check, contentsOf(ids)).find("ids"), std::string::npos);
}
