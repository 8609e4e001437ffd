#include "seeding/lattice.H"

#include <gtest/gtest.h>

using namespace gpuFsi;

namespace
{

const std::array<bool, 3> none{};

std::string messageOf(double spacing, std::array<bool, 3> periodic)
{
    try
    {
        lattice(3, spacing, {0, 0, 0}, {1, 1, 1}, periodic);
    }
    catch (const userError& e)
    {
        return e.what();
    }
    return {};
}

} // namespace

TEST(lattice, pointsAreCellCentres)
{
    const lattice l(3, 0.5, {-1, 0, 2}, {0, 1.5, 4}, none);
    EXPECT_EQ(l.n(0), 2);
    EXPECT_EQ(l.n(1), 3);
    EXPECT_EQ(l.n(2), 4);
    const vector p = l.point(l.index(1, 2, 3));
    EXPECT_EQ(p.x, -0.25);
    EXPECT_EQ(p.y, 1.25);
    EXPECT_EQ(p.z, 3.75);
}


TEST(lattice, linesRunThroughEveryPointOnce)
{
    const lattice l(3, 1, {0, 0, 0}, {3, 4, 5}, none);
    for (int axis = 0; axis < 3; ++axis)
    {
        std::vector<int> visits(l.size());
        for (std::size_t line = 0; line < l.nLines(axis); ++line)
        {
            for (long i = 0; i < l.n(axis); ++i)
            {
                ++visits[l.firstPoint(axis, line) + i*l.stride(axis)];
            }
        }
        EXPECT_EQ(visits, std::vector<int>(l.size(), 1));
    }
    EXPECT_EQ(l.firstPoint(0, l.line(0, 2, 4)), l.index(0, 2, 4));
    EXPECT_EQ(l.firstPoint(1, l.line(1, 2, 4)), l.index(2, 0, 4));
    EXPECT_EQ(l.firstPoint(2, l.line(2, 2, 3)), l.index(2, 3, 0));
}


TEST(lattice, twoDimensionsAreThePlaneZ0)
{
    const lattice l(2, 0.1, {0, 0, 5}, {1, 1, 9}, none);
    EXPECT_EQ(l.size(), 100u);
    EXPECT_EQ(l.point(37).z, 0);
}


TEST(lattice, periodicDifferenceIsTheShortest)
{
    const lattice l(3, 0.1, {0, 0, 0}, {1, 1, 1}, {true, false, false});
    const vector d = l.difference({0.95, 0.95, 0}, {0.05, 0.05, 0});
    EXPECT_NEAR(d.x, -0.1, 1e-15);
    EXPECT_NEAR(d.y, 0.9, 1e-15);
    EXPECT_NEAR(l.wrap({1.25, 0, 0}).x, 0.25, 1e-15);
    EXPECT_NEAR(l.wrap({-0.25, 0, 0}).x, 0.75, 1e-15);
}


TEST(lattice, errorsNameTheRemedy)
{
    const std::string misfit = messageOf(0.3, {false, true, false});
    EXPECT_NE(misfit.find("periodic in y"), std::string::npos) << misfit;
    EXPECT_NE(misfit.find("0.333333333333333"), std::string::npos) << misfit;
    EXPECT_NE(messageOf(-1, none).find("not a positive"), std::string::npos);
    EXPECT_NE(messageOf(2, none).find("larger than"), std::string::npos);
    EXPECT_NE(messageOf(1e-4, none).find("2^31"), std::string::npos);
    EXPECT_EQ(messageOf(0.3, none), "");
}
