#include "base/sum.H"

#include <cmath>
#include <gtest/gtest.h>

using namespace gpuFsi;

//- Also where several threads have a branch each
TEST(pairwiseSum, isThatOfOneThread)
{
    const auto value = [](std::size_t i)
    {
        return std::sin(double(i))*std::exp2(double(i % 40));
    };
    for (const std::size_t n : {0, 1, 64, 65, 99999, 100000, 123457, 1000003})
    {
        EXPECT_EQ(pairwiseSum(7, 7 + n, value), branchSum(7, 7 + n, value));
    }
}


TEST(pairwiseSum, hasEveryValueOnce)
{
    for (const std::size_t n : {100000, 131072, 131073, 999983})
    {
        const double sum =
            pairwiseSum(0, n, [](std::size_t i) { return double(i); });
        EXPECT_EQ(sum, double(n)*double(n - 1)/2);
    }
}
