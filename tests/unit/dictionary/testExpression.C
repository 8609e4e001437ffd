#include "dictionary/expression.H"

#include <gtest/gtest.h>

#include <cmath>

using namespace gpuFsi;

static double at(const char* text, double x, double y = 0, double z = 0)
{
    return expression(text)({x, y, z}, 0.5);
}


TEST(expression, arithmetic)
{
    EXPECT_EQ(evaluate("2 + 3*4"), 14);
    EXPECT_EQ(evaluate("2^-1"), 0.5);
    EXPECT_EQ(evaluate("-2^2"), -4);
    EXPECT_EQ(evaluate("2*-3"), -6);
    EXPECT_EQ(evaluate("2 - -3"), 5);
    EXPECT_EQ(evaluate("1e-3*1E+3"), 1);
    EXPECT_EQ(evaluate("pow(2, 10) + sqr(3) + mag(-1)"), 1034);
    EXPECT_EQ(evaluate("pos(0) + pos(2) + pos0(0) + neg(-1) + neg(0)"), 3);
    EXPECT_EQ(evaluate("min(3, 1, 2) + max(3, 1, 2)"), 4);
    EXPECT_EQ(evaluate("1 < 2 && !(3 <= 2) ? 5 : 6"), 5);
    EXPECT_EQ(evaluate("if(1 > 2, 5, 6)"), 6);
    EXPECT_EQ(evaluate("pi()"), std::acos(-1.0));
    EXPECT_NEAR(evaluate("cos(pi) + log(e) + exp(0) + sqrt(4)"), 3, 1e-15);
    EXPECT_EQ(evaluate("abs(-2) + sign(-3) + floor(1.5) + ceil(1.5)"), 4);
    EXPECT_EQ(evaluate("0 || 1"), 1);
    EXPECT_EQ(evaluate("mod(7, 4)"), 3);
}


TEST(expression, besselFunctions)
{
    // Zeros of J0 and J1, a table's value, and J0 + J2 = 2 J1/x
    EXPECT_NEAR(evaluate("j0(2.404825557695773)"), 0, 1e-15);
    EXPECT_NEAR(evaluate("j1(3.831705970207512)"), 0, 1e-15);
    EXPECT_NEAR(evaluate("jn(2, 1)"), 0.114903484931900, 1e-15);
    EXPECT_NEAR(at("j0(x) + jn(2, x) - 2*j1(x)/x", 1.7), 0, 1e-15);
    EXPECT_TRUE(std::isnan(at("jn(1.5, x)", 1)));
}


TEST(expression, variables)
{
    EXPECT_EQ(at("-r^2", 3, 4), -25);
    EXPECT_EQ(at("x + 10*y + 100*z + t", 1, 2, 3), 321.5);
    EXPECT_EQ(at("x^-1", 4), 0.25);
    EXPECT_EQ(at("7", 1), 7);
    EXPECT_EQ(at("x < 0 ? -1 : 1", -2), -1);
}


static std::string problem(const char* text)
{
    try
    {
        const expression e(text, {"U", 7, 7});
    }
    catch (const userError& e)
    {
        return e.what();
    }
    return {};
}


TEST(expression, errorsNameExpressionPositionAndReason)
{
    const std::string unknown = problem("1 + foo*2");
    EXPECT_NE(unknown.find("'1 + foo*2'"), std::string::npos) << unknown;
    EXPECT_NE(unknown.find("position 5"), std::string::npos) << unknown;
    EXPECT_NE(unknown.find("foo"), std::string::npos) << unknown;
    EXPECT_NE(unknown.find("file: U at line 7."), std::string::npos);
    for (const char* bad : {"", "1 +", "(1", "1)", "x = 3", "1, 2", "sin()",
        "\"text\"", "2 x", "min(", "system(1)", "x ? 1", "1;2"})
    {
        EXPECT_NE(problem(bad), "") << bad;
    }
    EXPECT_THROW(evaluate("x"), userError);
    EXPECT_THROW(evaluate("1/0"), userError);
    EXPECT_THROW(evaluate("sqrt(-1)"), userError);
}


TEST(expression, manyPointsEqualOneByOne)
{
    const expression e("sin(3*x)*exp(-r) + (y > 0.5 ? y : z*t)");
    std::vector<vector> points;
    for (int i = 0; i < 20000; ++i)
    {
        points.push_back({i*0.37 - 100, (i%17)/17.0, (i%5)*0.25});
    }
    const std::vector<double> values = e.at(points, 0.25);
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        ASSERT_EQ(values[i], e(points[i], 0.25)) << i;
    }
    EXPECT_TRUE(e.at({}).empty());
}


TEST(expression, singularPointIsNamed)
{
    const expression e("1/r");
    EXPECT_TRUE(std::isinf(e({0, 0, 0})));
    try
    {
        e.at({{1, 0, 0}, {0, 0, 0}}, 2);
        FAIL();
    }
    catch (const userError& error)
    {
        const std::string text = error.what();
        EXPECT_NE(text.find("inf at the point (0 0 0), t = 2"),
            std::string::npos) << text;
    }
}


TEST(expression, moves)
{
    expression a("x + 1");
    expression b(std::move(a));
    a = std::move(b);
    EXPECT_EQ(a({1, 0, 0}), 2);
    EXPECT_EQ(a.text(), "x + 1");
}


TEST(expression, knowsItsVariables)
{
    const expression e("2*cos(t) + exp(-r)");
    EXPECT_TRUE(e.uses("t"));
    EXPECT_TRUE(e.uses("r"));
    EXPECT_FALSE(e.uses("x"));
    EXPECT_NEAR(e({0, 0, 0}, 0), 3, 1e-15);    // and still evaluates
    EXPECT_FALSE(expression("max(1, 2)").uses("x"));
}
