#include "common/lattice.H"
#include "neighbours/selection.H"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

using namespace gpuFsi;

namespace
{

struct candidate
{
    offset d;
    int id;
    bool wall;
};

std::vector<candidate> randomCandidates(int n, int seed, bool walls)
{
    std::vector<candidate> all;
    for (int i = 0; int(all.size()) < n; ++i)
    {
        const std::uint64_t k = 1000003u*seed + 3*i;
        const offset d
        {
            int(16384*hashed(k)), int(16384*hashed(k + 1)),
            int(16384*hashed(k + 2))
        };
        if (d.squared() > 0 && d.squared() <= 16384*16384)
        {
            all.push_back({d, int(all.size()), walls && i % 5 == 0});
        }
    }
    return all;
}

//- The rule as it reads, by sorting
std::vector<int> byTheRule(std::vector<candidate> all)
{
    std::sort(all.begin(), all.end(), [](const auto& a, const auto& b)
    {
        return std::make_pair(a.d.squared(), a.id)
          < std::make_pair(b.d.squared(), b.id);
    });
    const bool walls = std::any_of
    (
        all.begin(), all.end(), [](const auto& c) { return c.wall; }
    );
    if (walls && all.size() >= 4)
    {
        const long limit = 484L*all[3].d.squared()/100;
        while (all.back().d.squared() > limit)
        {
            all.pop_back();
        }
    }
    std::vector<int> list(26, -1);
    std::vector<bool> taken(all.size(), false);
    for (std::size_t i = 0; i < all.size(); ++i)
    {
        int& slot = list[directionOf<3>(all[i].d)];
        if (slot < 0)
        {
            slot = all[i].id;
            taken[i] = true;
        }
    }
    std::size_t next = 0;
    for (int& slot : list)
    {
        while (slot < 0 && next < all.size())
        {
            if (!taken[next])
            {
                slot = all[next].id;
            }
            ++next;
        }
    }
    return list;
}

std::vector<int> bySelection(const std::vector<candidate>& all)
{
    selection<3> s;
    for (const auto& c : all)
    {
        s.offer(c.d, c.id, c.id, c.wall);
    }
    if (s.finishFirstRound())
    {
        for (const auto& c : all)
        {
            s.offerFill(c.d, c.id, c.id);
        }
    }
    std::vector<int> list(26);
    for (int k = 0; k < 26; ++k)
    {
        list[k] = s.take(k, -1);
    }
    return list;
}

} // namespace

TEST(selection, followsTheRule)
{
    for (int seed = 0; seed < 200; ++seed)
    {
        for (bool walls : {false, true})
        {
            const auto all = randomCandidates(5 + seed % 90, seed, walls);
            ASSERT_EQ(bySelection(all), byTheRule(all)) << "seed " << seed;
        }
    }
}

TEST(selection, orderAndRepetitionOfCandidatesDoNotMatter)
{
    for (int seed = 0; seed < 50; ++seed)
    {
        auto all = randomCandidates(60, seed, seed % 2);
        const auto expected = bySelection(all);
        std::reverse(all.begin(), all.end());
        ASSERT_EQ(bySelection(all), expected);
        const auto once = all;
        all.insert(all.end(), once.begin(), once.end());
        ASSERT_EQ(bySelection(all), expected);
    }
}

TEST(selection, aLoneParticleSeesNobody)
{
    EXPECT_EQ(bySelection({}), std::vector<int>(26, -1));
}
