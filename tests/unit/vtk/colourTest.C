#include "base/error.H"
#include "vtk/colourMap.H"
#include "vtk/shownField.H"
#include "vtk/ticks.H"

#include <gtest/gtest.h>

#include <cmath>

using namespace gpuFsi;

namespace
{

//- CIE lightness of an sRGB colour
double lightness(rgb c)
{
    const auto linear = [](unsigned char v)
    {
        const double s = v/255.0;
        return s <= 0.04045 ? s/12.92 : std::pow((s + 0.055)/1.055, 2.4);
    };
    const double y =
        0.2126*linear(c.r) + 0.7152*linear(c.g) + 0.0722*linear(c.b);
    return y > 0.008856 ? 116*std::cbrt(y) - 16 : 903.3*y;
}


cloud sample()
{
    cloud c;
    c.name = "fluid";
    c.positions = {{0, 0, 0}};
    c.fields =
    {
        {"scalarField", "rho", {7}},
        {"vectorField", "U", {3, 4, 12}},
        {"symmTensorField", "stress", {1, 2, 3, 4, 5, 6}}
    };
    return c;
}

} // namespace


TEST(colourMap, endsAndMiddleAreTheKnownOnes)
{
    EXPECT_EQ(colourMap("viridis")(0), (rgb{68, 1, 84}));
    EXPECT_EQ(colourMap("viridis")(1), (rgb{253, 231, 37}));
    EXPECT_EQ(colourMap("coolToWarm")(0), (rgb{59, 76, 192}));
    EXPECT_EQ(colourMap("coolToWarm")(1), (rgb{180, 4, 38}));
    const rgb middle = colourMap("coolToWarm")(0.5);
    EXPECT_NEAR(middle.r, 221, 2);
    EXPECT_NEAR(middle.g, 221, 2);
    EXPECT_NEAR(middle.b, 221, 2);
    EXPECT_EQ(colourMap("grey")(-3), colourMap("grey")(0));
    EXPECT_EQ(colourMap("grey")(9), colourMap("grey")(1));
}


TEST(colourMap, lightnessRisesSteadily)
{
    for (const char* name : {"viridis", "grey"})
    {
        const colourMap map(name);
        double before = lightness(map(0));
        for (int i = 1; i <= 32; ++i)
        {
            const double now = lightness(map(i/32.0));
            EXPECT_GT(now, before + 0.5) << name << ' ' << i;
            EXPECT_LT(now, before + 5) << name << ' ' << i;
            before = now;
        }
    }
}


TEST(colourMap, unknownNameListsTheValidOnes)
{
    try
    {
        colourMap("viridus");
        FAIL();
    }
    catch (const userError& error)
    {
        const std::string text = error.what();
        EXPECT_NE(text.find("coolToWarm"), std::string::npos);
        EXPECT_NE(text.find("viridis"), std::string::npos);
    }
}


TEST(shownField, magnitudesAndComponents)
{
    const std::vector<cloud> clouds{sample()};
    const auto value = [&](const std::string& name)
    {
        const shownField field(clouds, name);
        return field.value(*field.in(clouds[0]), 0);
    };
    EXPECT_EQ(value("rho"), 7);
    EXPECT_EQ(value("U"), 13);
    EXPECT_EQ(value("U.y"), 4);
    EXPECT_EQ(value("stress.yz"), 5);

    // Each off-diagonal entry counts twice
    EXPECT_DOUBLE_EQ(value("stress"), std::sqrt(53.0 + 2*38.0));
    EXPECT_EQ(shownField(clouds, "").title(), "|U|");
    EXPECT_EQ(shownField(clouds, "U.x").title(), "U.x");
}


TEST(shownField, errorsListWhatThereIs)
{
    const std::vector<cloud> clouds{sample()};
    for (const char* wrong : {"T", "U.w", "rho.x", "T.x"})
    {
        EXPECT_THROW(shownField(clouds, wrong), userError) << wrong;
    }
    try
    {
        shownField(clouds, "T");
    }
    catch (const userError& error)
    {
        EXPECT_NE(std::string(error.what()).find("rho"), std::string::npos);
    }
    EXPECT_THROW(shownField({cloud()}, ""), userError);
}


TEST(ticks, roundNumbersWithinTheLimits)
{
    const tickMarks marks = ticks(-0.5, 0.5, 5);
    EXPECT_EQ
    (
        marks.labels,
        (std::vector<std::string>{"-0.4", "-0.2", "0.0", "0.2", "0.4"})
    );
    EXPECT_EQ(marks.exponent, 0);
    EXPECT_NEAR(marks.at[3], 0.2, 1e-15);

    const tickMarks small = ticks(0, 0.005, 5);
    EXPECT_EQ(small.exponent, -3);
    EXPECT_EQ
    (
        small.labels,
        (std::vector<std::string>{"0", "1", "2", "3", "4", "5"})
    );
    EXPECT_EQ(ticks(0, 101325, 4).exponent, 3);
}


TEST(ticks, narrowRangeKeepsItsDigits)
{
    const tickMarks marks = ticks(999.98, 1000.02, 4);
    ASSERT_EQ(marks.labels.size(), 5u);
    EXPECT_EQ(marks.labels.front(), "999.98");
    EXPECT_EQ(marks.labels.back(), "1000.02");
}


TEST(ticks, lengthsHaveUnits)
{
    EXPECT_EQ(lengthLabel("x", 0), "x [m]");
    EXPECT_EQ(lengthLabel("y", -3), "y [mm]");
    EXPECT_EQ(lengthLabel("z", 12), "z [1e12 m]");
}
