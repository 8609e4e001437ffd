// Against the best of all cuts, by dynamic programming.
#include "decomposition/equalPieces.H"
#include "grids.H"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

using namespace gpuFsi;

namespace
{

//- Least possible weight of the heaviest of n pieces
double leastMaximum(const std::vector<double>& w, int n)
{
    constexpr double infinite = std::numeric_limits<double>::infinity();
    std::vector<double> best(w.size() + 1, infinite);
    best[0] = 0;
    for (int k = 0; k < n; ++k)
    {
        std::vector<double> next(w.size() + 1, infinite);
        for (std::size_t i = 0; i <= w.size(); ++i)
        {
            double piece = 0;
            for (std::size_t j = i; j <= w.size(); ++j)
            {
                next[j] = std::min(next[j], std::max(best[i], piece));
                piece += j < w.size() ? w[j] : 0;
            }
        }
        best = next;
    }
    return best[w.size()];
}

} // namespace


TEST(equalPieces, heaviestIsAsLightAsCanBe)
{
    for (int size : {1, 2, 5, 17, 40})
    {
        const std::vector<double> w = unevenWeights(size);
        const long some =
            std::count_if(w.begin(), w.end(), [](double x) { return x > 0; });
        for (int n : {1, 2, 3, 7, 20, 45})
        {
            const auto b = equalPieces(w, n);
            ASSERT_EQ(b.size(), std::size_t(n + 1));
            EXPECT_EQ(b.front(), 0u);
            EXPECT_EQ(b.back(), w.size());
            double heaviest = 0;
            int filled = 0;
            for (int k = 0; k < n; ++k)
            {
                ASSERT_LE(b[k], b[k + 1]);
                double piece = 0;
                for (std::size_t i = b[k]; i < b[k + 1]; ++i)
                {
                    piece += w[i];
                }
                heaviest = std::max(heaviest, piece);
                filled += piece > 0;
            }
            EXPECT_NEAR(heaviest, leastMaximum(w, n), 1e-9)
                << size << " items in " << n;
            EXPECT_EQ(filled, std::min<long>(n, some));
        }
    }
}


TEST(equalPieces, withoutWeightsItemsCount)
{
    const auto b = equalPieces(std::vector<double>(12, 0), 4);
    EXPECT_EQ(b, (std::vector<std::size_t>{0, 3, 6, 9, 12}));
}


TEST(equalPieces, nothingToShare)
{
    EXPECT_EQ(equalPieces({}, 2), (std::vector<std::size_t>{0, 0, 0}));
}
