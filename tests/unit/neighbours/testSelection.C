#include "common/lattice.H"
#include "neighbours/quickSelection.H"
#include "neighbours/selection.H"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

using namespace gpuFsi;

namespace
{

struct offered
{
    offset d;
    int id;
    bool wall;
};

std::vector<offered> randomCandidates(int n, int seed, bool walls)
{
    std::vector<offered> all;
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
std::vector<int> byTheRule(std::vector<offered> all)
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

std::vector<int> bySelection(const std::vector<offered>& all)
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

//- Empty where it is not sure. Walls come first by index, as in a run.
std::vector<int> byQuickSelection(const std::vector<offered>& all)
{
    std::vector<int> index(all.size());
    int n = 0, nWalls = 0;
    for (bool wall : {true, false})
    {
        for (std::size_t i = 0; i < all.size(); ++i)
        {
            if (all[i].wall == wall)
            {
                index[i] = n++;
            }
        }
        nWalls = wall ? n : nWalls;
    }
    std::vector<int> id(all.size());
    for (std::size_t i = 0; i < all.size(); ++i)
    {
        id[index[i]] = all[i].id;
    }
    using memory = scratch<quickSelection<3, int*>::words>;
    memory own;
    quickSelection<3, memory> s(own, id.data());
    for (std::size_t i = 0; i < all.size(); ++i)
    {
        s.offer(all[i].d, index[i]);
    }
    if (!s.finish(nWalls))
    {
        return {};
    }
    std::vector<int> list(26);
    for (int k = 0; k < 26; ++k)
    {
        const int j = s.take(k, -1);
        list[k] = j < 0 ? -1 : id[j];
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

TEST(quickSelection, isTheSelectionWhereverItIsSure)
{
    int all = 0, sure = 0;
    for (int seed = 0; seed < 400; ++seed)
    {
        for (bool walls : {false, true})
        {
            const auto some = randomCandidates(50 + seed % 40, seed, walls);
            const auto list = byQuickSelection(some);
            ++all;
            sure += !list.empty();
            if (!list.empty())
            {
                ASSERT_EQ(list, bySelection(some)) << "seed " << seed;
            }
        }
    }
    EXPECT_GT(sure, all/2);
}

TEST(quickSelection, fewCandidatesFillWhatTheyCan)
{
    for (int n = 0; n < 5; ++n)
    {
        const auto some = randomCandidates(n, 7, false);
        EXPECT_EQ(byQuickSelection(some), bySelection(some)) << n;
    }
}

TEST(quickSelection, tiesAreResolvedOrLeft)
{
    // Two equally near in one direction: the smaller id, whatever the order
    std::vector<offered> pair
    {
        {{8000, 0, 0}, 5, false}, {{8000, 0, 0}, 2, false}
    };
    EXPECT_EQ(byQuickSelection(pair), bySelection(pair));
    std::reverse(pair.begin(), pair.end());
    EXPECT_EQ(byQuickSelection(pair), bySelection(pair));

    // Two equally near that would fill empty directions
    pair.push_back({{7000, 0, 0}, 9, false});
    EXPECT_TRUE(byQuickSelection(pair).empty());
}
