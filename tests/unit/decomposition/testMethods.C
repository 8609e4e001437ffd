#include "base/error.H"
#include "decomposition/blockDecomposition.H"
#include "decomposition/decomposition.H"
#include "decomposition/hilbertCurve.H"
#include "grids.H"
#include "unit/case/temporaryCase.H"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

using namespace gpuFsi;

namespace
{

class decompositionMethods
:
    public temporaryCase
{
protected:

    std::unique_ptr<decomposition> make(const std::string& text) const
    {
        return decomposition::make(dictionary::fromString(text), path);
    }

    static bool has(const std::string& method)
    {
        const auto words = decomposition::selection::words();
        return std::count(words.begin(), words.end(), method) > 0;
    }

    //- Heaviest over mean; checks that ranks are in range, the same twice
    static double imbalance
    (
        const decomposition& d,
        const blockGrid& g,
        const std::vector<double>& w,
        int nRanks
    )
    {
        const std::vector<int> ranks = d.assign(g, w, nRanks);
        EXPECT_EQ(ranks.size(), std::size_t(g.count()));
        for (int r : ranks)
        {
            EXPECT_TRUE(r >= 0 && r < nRanks) << r;
        }
        EXPECT_EQ(ranks, d.assign(g, w, nRanks));
        const auto all = weightOfRank(ranks, w, nRanks);
        const double total = std::accumulate(all.begin(), all.end(), 0.0);
        return *std::max_element(all.begin(), all.end())*nRanks/total;
    }
};

} // namespace


TEST_F(decompositionMethods, hilbertIsBalancedToABlock)
{
    const auto d = make("method hilbert;");
    for (const blockGrid& g : {gridOf(20, 15, 1), gridOf(9, 8, 7, true)})
    {
        const auto w = unevenWeights(g.count());
        const double heaviest = *std::max_element(w.begin(), w.end());
        const double total = std::accumulate(w.begin(), w.end(), 0.0);
        for (int n : {1, 2, 3, 4, 7, 50})
        {
            EXPECT_LE(imbalance(*d, g, w, n), 1 + n*heaviest/total) << n;
        }
        EXPECT_GT(imbalance(*d, g, w, g.count() + 5), 1);
    }
}


TEST_F(decompositionMethods, hilbertPiecesAreStretchesOfTheCurve)
{
    const blockGrid g = gridOf(12, 10, 6);
    const auto ranks = make("method hilbert;")->assign
    (
        g, unevenWeights(g.count()), 7
    );
    int at = 0;
    for (int b : hilbertCurve(g.n))
    {
        EXPECT_TRUE(ranks[b] == at || ranks[b] == at + 1);
        at = ranks[b];
    }
    EXPECT_EQ(at, 6);
}


TEST_F(decompositionMethods, simpleCutsSlabs)
{
    const blockGrid g = gridOf(8, 6, 4);
    const std::vector<double> even(g.count(), 1);
    const auto d = make("method simple; simpleCoeffs { n (4 3 2); }");
    EXPECT_EQ(imbalance(*d, g, even, 24), 1);
    const auto ranks = d->assign(g, even, 24);
    for (int z = 0; z < 4; ++z)
    for (int y = 0; y < 6; ++y)
    for (int x = 0; x < 8; ++x)
    {
        EXPECT_EQ(ranks[g.index(x, y, z)], x/2 + 4*(y/2 + 3*(z/2)));
    }

    // All in the last four layers: slabs there are thin
    std::vector<double> late(g.count(), 0);
    for (int b = 0; b < g.count(); ++b)
    {
        late[b] = b % 8 >= 4;
    }
    const auto slabs = make("method simple; simpleCoeffs { n (4 1 1); }");
    EXPECT_EQ(imbalance(*slabs, g, late, 4), 1);
}


TEST_F(decompositionMethods, simpleTakesAnOrderOfCuts)
{
    // One heavy block: cut along y first, only its row is cut through it
    const blockGrid g = gridOf(4, 4, 1);
    std::vector<double> w(16, 1);
    w[0] = 10;
    const auto d = make("method simple; coeffs { n (2 2 1); order yxz; }");
    const auto ranks = d->assign(g, w, 4);
    EXPECT_EQ(ranks, (std::vector<int>
    {
        0, 1, 1, 1, 2, 2, 3, 3, 2, 2, 3, 3, 2, 2, 3, 3
    }));
}


TEST_F(decompositionMethods, simpleHasEmptyRanksWhereBlocksAreFew)
{
    const auto d = make("method simple; simpleCoeffs { n (5 1 1); }");
    const blockGrid g = gridOf(2, 1, 1);
    EXPECT_EQ(imbalance(*d, g, {1, 1}, 5), 2.5);
}


TEST_F(decompositionMethods, scotchIsBalancedAndFillsHoles)
{
    if (!has("scotch"))
    {
        EXPECT_TRUE(says
        (
            errorOf([&] { make("method scotch;"); }), "This build has no Scotch"
        ));
        GTEST_SKIP() << "no Scotch";
    }
    const auto d = make("method scotch;");
    for (bool periodic : {false, true})
    {
        for (const blockGrid& g :
            {
                gridOf(20, 15, 1, periodic), gridOf(9, 8, 7, periodic),
                gridOf(2, 2, 2, periodic)
            })
        {
            const auto w = unevenWeights(g.count());
            const double heaviest = *std::max_element(w.begin(), w.end());
            const double total = std::accumulate(w.begin(), w.end(), 0.0);
            for (int n : {1, 2, 3, 4, 7, 1000})
            {
                EXPECT_LE(imbalance(*d, g, w, n), 1.02 + n*heaviest/total)
                    << n << " of " << g.count();
            }
        }
    }
    const blockGrid g = gridOf(4, 4, 4);
    const auto ranks = d->assign(g, std::vector<double>(64, 0), 4);
    for (double n : weightOfRank(ranks, std::vector<double>(64, 1), 4))
    {
        EXPECT_EQ(n, 16);
    }
}


TEST_F(decompositionMethods, manualReadsWhatWasWritten)
{
    const blockGrid g = gridOf(5, 4, 3);
    const auto ranks = make("method hilbert;")->assign
    (
        g, unevenWeights(g.count()), 4
    );
    writeBlockDecomposition(path/"constant/blockDecomposition", g, ranks);
    const auto d = make
    (
        "method manual; manualCoeffs { dataFile \"blockDecomposition\"; }"
    );
    EXPECT_EQ(d->assign(g, {}, 4), ranks);
    EXPECT_TRUE(says
    (
        errorOf([&] { d->assign(g, {}, 3); }), "but there are 3 ranks"
    ));
    EXPECT_TRUE(says
    (
        errorOf([&] { d->assign(gridOf(5, 4, 2), {}, 4); }),
        "There are ranks for 60 blocks, but 5 x 4 x 2 blocks"
    ));
}


TEST_F(decompositionMethods, refusesWhatIsWrong)
{
    const auto refuses = [&](const char* text, const char* message)
    {
        EXPECT_TRUE(says
        (
            errorOf([&] { make(text)->assign(gridOf(4, 4, 1), {}, 4); }),
            message
        ));
    };
    refuses("method hilbrt;", "hilbert");
    refuses("method simple;", "simpleCoeffs");
    refuses("method simple; simpleCoeffs { n (2 2); }", "three positive");
    refuses("method simple; simpleCoeffs { n (2 0 2); }", "three positive");
    refuses("method simple; simpleCoeffs { n (3 1 1); }", "makes 3 ranks");
    refuses("method manual; manualCoeffs { dataFile \"x\"; }",
        "There is no file");
}
