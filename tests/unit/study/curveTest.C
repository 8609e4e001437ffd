#include "study/finestRun.H"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace gpuFsi;

namespace
{

curvePoint point(double h, double error, double seconds)
{
    curvePoint p;
    p.size = h;
    p.run.h = h;
    p.run.machine = "here";
    p.error = error;
    p.seconds = {seconds, seconds, seconds};
    return p;
}

} // namespace


TEST(spread, equalsAHandCalculation)
{
    const spread odd = spread::of({5, 1, 3});
    EXPECT_EQ(odd.median, 3);
    EXPECT_EQ(odd.least, 1);
    EXPECT_EQ(odd.greatest, 5);
    EXPECT_EQ(spread::of({4, 1, 2, 100}).median, 3);
    EXPECT_EQ(spread::of({7}).median, 7);
    EXPECT_EQ(spread::of({}).greatest, 0);
}


TEST(curve, ordersOfPowers)
{
    // error 3 h^2, seconds 5 h^-4: order 2, slope 2
    curve c;
    for (const double h : {0.5, 0.2, 0.1})
    {
        c.points.push_back(point(h, 3*h*h, 5/std::pow(h, 4)));
    }
    addOrders(c);
    EXPECT_TRUE(std::isnan(c.points[0].order));
    for (int i : {1, 2})
    {
        EXPECT_NEAR(c.points[i].order, 2, 1e-12);
        EXPECT_NEAR(c.points[i].slope, 2, 1e-12);
    }
}


TEST(curve, orderInTimeStepsAndInNumbersOfCells)
{
    // The same spacing: the size counts; it may grow towards the finer
    curve steps, cells;
    for (const double dt : {0.1, 0.05})
    {
        steps.points.push_back(point(1, dt, 1/dt));
        steps.points.back().size = dt;
        cells.points.push_back(point(0, dt*dt, 1/dt));
        cells.points.back().size = 3/dt;
    }
    addOrders(steps);
    addOrders(cells);
    EXPECT_NEAR(steps.points[1].order, 1, 1e-12);
    EXPECT_NEAR(cells.points[1].order, 2, 1e-12);
}


TEST(curve, noOrderWhereThereIsNone)
{
    curve c;
    c.points = {point(0.5, 0.1, 1), point(0.25, 0.1, 2), point(0.1, 0, 3)};
    c.points[0].size = curvePoint::none;
    c.points[0].run.h = 0;
    addOrders(c);
    EXPECT_TRUE(std::isnan(c.points[1].order));
    EXPECT_TRUE(std::isnan(c.points[1].slope));
    EXPECT_TRUE(std::isnan(c.points[2].order));
}


TEST(pareto, equalsBruteForce)
{
    std::mt19937 random(7);
    std::uniform_int_distribution<int> pick(1, 30);
    std::vector<curve> curves(3);
    for (curve& c : curves)
    {
        for (int i = 0; i < 40; ++i)
        {
            c.points.push_back(point(1, pick(random), pick(random)));
        }
    }
    curves[2].points[0] = point(1, 0.1, 0.1);
    curves[2].points[0].run.machine = "elsewhere";
    markPareto(curves, "here");
    EXPECT_FALSE(curves[2].points[0].pareto);
    for (const curve& c : curves)
    {
        for (const curvePoint& p : c.points)
        {
            bool front = p.run.machine == "here";
            for (const curve& other : curves)
            {
                for (const curvePoint& q : other.points)
                {
                    const double e = q.error - p.error;
                    const double t = q.seconds.median - p.seconds.median;
                    front = front
                     && !(q.run.machine == "here" && e <= 0 && t <= 0
                         && e + t < 0);
                }
            }
            EXPECT_EQ(p.pareto, front);
        }
    }
}


TEST(reach, isALineInTheLogarithms)
{
    curve c;
    c.points = {point(1, 1e-1, 1), point(0.5, 1e-3, 100)};
    const auto middle = secondsToReach(c, 1e-2);
    ASSERT_TRUE(middle);
    EXPECT_NEAR(middle->seconds, 10, 1e-9);
    EXPECT_FALSE(middle->atMost);
    EXPECT_NEAR(secondsToReach(c, 1e-3)->seconds, 100, 1e-9);
    EXPECT_TRUE(secondsToReach(c, 0.5)->atMost);
    EXPECT_FALSE(secondsToReach(c, 1e-4));
    EXPECT_FALSE(secondsToReach(curve(), 1));
}


TEST(reach, takesTheFirstOfSeveralCrossings)
{
    // Errors that cancel at one resolution: reached there, then left
    curve c;
    c.points =
    {
        point(1, 1e-1, 1), point(0.5, 1e-3, 10), point(0.2, 1e-1, 100),
        point(0.1, 1e-4, 1000)
    };
    EXPECT_NEAR(secondsToReach(c, 1e-3)->seconds, 10, 1e-9);
    EXPECT_NEAR(secondsToReach(c, 1e-4)->seconds, 1000, 1e-6);
}


TEST(curve, namesItsMachines)
{
    curve c;
    c.points = {point(1, 1, 1), point(1, 1, 1), point(1, 1, 1)};
    c.points[1].run.machine = "there";
    EXPECT_EQ(machinesOf(c), (std::vector<std::string>{"here", "there"}));
}


namespace
{

//- Values at the spacings 0.4, 0.2, 0.1, labelled by number
curve threeValues()
{
    curve c;
    c.points = {point(0.4, 3, 1), point(0.2, 2.5, 2), point(0.1, 2, 4)};
    for (int i = 0; i < 3; ++i)
    {
        c.points[i].resolution = std::to_string(i);
    }
    return c;
}

} // namespace


TEST(finestRun, isWhatTheOthersAreComparedWith)
{
    curve c = threeValues();
    EXPECT_EQ(compareWithFinest(c, "2"), "");
    ASSERT_EQ(c.points.size(), 2u);
    EXPECT_EQ(c.points[0].error, 0.5);
    EXPECT_EQ(c.points[1].error, 0.25);
}


TEST(finestRun, isNotReplacedByAnother)
{
    curve c = threeValues();
    c.points.pop_back();
    const std::string why = compareWithFinest(c, "2");
    EXPECT_NE(why.find("run at 2"), why.npos) << why;
    EXPECT_EQ(c.points.size(), 2u);
    curve none;
    EXPECT_NE(compareWithFinest(none, "2"), "");
}


TEST(finestRun, hasToBeTheFinest)
{
    curve c = threeValues();
    std::swap(c.points[0].run.h, c.points[2].run.h);
    EXPECT_NE(compareWithFinest(c, "2"), "");

    // The same spacing: sizes, which may rise (numbers of cells) or fall
    const auto ofSizes = [](double a, double b, double last)
    {
        curve sizes = threeValues();
        const double values[] = {a, b, last};
        for (int i = 0; i < 3; ++i)
        {
            sizes.points[i].run.h = 1;
            sizes.points[i].size = values[i];
        }
        return compareWithFinest(sizes, "2");
    };
    EXPECT_EQ(ofSizes(8, 16, 32), "");
    EXPECT_EQ(ofSizes(3, 2, 1), "");
    EXPECT_NE(ofSizes(8, 32, 16), "");
    EXPECT_NE(ofSizes(8, 8, 16), "");
    EXPECT_EQ(ofSizes(curvePoint::none, 8, 16), "");
}


TEST(finestRun, hasToBeFiniteAndNotZero)
{
    for (const double value : {0.0, curvePoint::none, HUGE_VAL})
    {
        curve c = threeValues();
        c.points[2].error = value;
        EXPECT_NE(compareWithFinest(c, "2"), "") << value;
    }
}
