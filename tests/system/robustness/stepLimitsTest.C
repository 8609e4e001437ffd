// A fixed deltaT beyond a limit is refused by the name of the limit; with
// adjustTimeStep the limits are followed, and named in the log.
#include "systemCase.H"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace
{

constexpr const char* control = "system/controlDict";
constexpr const char* schemes = "system/particleSchemes";
constexpr const char* seeds = "system/seedParticlesDict";

//- The piston's column, stable up to c dt/h = 2 but for what `change` does
systemCase column(const std::function<void(systemCase&)>& change)
{
    systemCase c = systemCase::piston();
    c.set(control, "endTime", "0.2");
    c.add(control, "logInterval 1;");
    c.add(schemes, "areaWeights moment; timeScheme symplecticEuler;");
    change(c);
    c.seed();
    return c;
}

void elastic
(
    systemCase& c,
    const std::string& rho,
    const std::string& E,
    const std::string& more = ""
)
{
    c.add
    (
        seeds, "solids { wall { type box; min (0.5 -1 -1); max (0.75 2 1); } }"
    );
    c.write
    (
        "constant/solidProperties",
        "wall { rho " + rho + "; E " + E + "; nu 0.3; }\n" + more + "\n"
    );
}

struct limited
{
    const char* term;
    std::function<void(systemCase&)> change;
};

const std::vector<limited> fixedSteps
{
    {"acoustic", [](systemCase& c) { c.set(control, "deltaT", "0.13"); }},
    {"viscous", [](systemCase& c)
        {
            c.set("constant/fluidProperties", "mu", "0.4");
            c.add(schemes, "superTimeStepping off;");
        }},
    {"convective", [](systemCase& c)
        {
            c.replace(seeds, "0.02*sin(8*pi*y)", "2*cos(2*pi*x)");
            c.set(control, "deltaT", "0.05");
        }},
    {"bodyForce", [](systemCase& c)
        {
            c.write("constant/g", "value (0 20 0);\n");
            c.set(control, "deltaT", "0.07");
        }},
    {"spring", [](systemCase& c) { elastic(c, "0.5", "300", "subSteps 1;"); }},
    {"coupling", [](systemCase& c)
        {
            elastic(c, "0.02", "0.07");
            c.set("constant/fluidProperties", "mu", "0.0005");
            c.set(control, "deltaT", "0.015");
            c.replace(seeds, "0.01*cos", "0.0001*cos");
            c.replace(seeds, "0.1*sin", "0.0001*sin");
            c.write("constant/wallProperties", "piston { type fixed; }\n");
        }},
    {"viscousCoupling", [](systemCase& c)
        {
            elastic(c, "0.02", "0.07");
            c.set("constant/fluidProperties", "mu", "0.01");
            c.set(control, "deltaT", "0.005");
            c.replace(seeds, "0.01*cos", "0.0001*cos");
            c.replace(seeds, "0.1*sin", "0.0001*sin");
            c.write("constant/wallProperties", "piston { type fixed; }\n");
        }},
};

//- Values of `deltaT = ` in a log
std::vector<double> stepsIn(const std::string& log)
{
    std::vector<double> steps;
    const std::string key = "\ndeltaT = ";
    for
    (
        std::size_t at = log.find(key);
        at != std::string::npos;
        at = log.find(key, at + 1)
    )
    {
        steps.push_back(std::stod(log.substr(at + key.size())));
    }
    return steps;
}

} // namespace


TEST(stepLimits, refusedByName)
{
    for (const limited& l : fixedSteps)
    {
        SCOPED_TRACE(l.term);
        const systemCase c = column(l.change);
        const fileTree before = c.tree();
        const outcome o = c.run(app::gpuFsiFoam);
        EXPECT_EQ(o.code, 1);
        EXPECT_TRUE(o.says(std::string("is beyond the ") + l.term + " limit"))
            << o.err;
        EXPECT_TRUE(o.says("FOAM FATAL IO ERROR"));
        EXPECT_TRUE(o.says(control)) << o.err;
        EXPECT_TRUE(o.says("adjustTimeStep yes"));
        EXPECT_EQ(difference(c.tree(), before), "");

        // checkParticles says the same
        const outcome check = c.run(app::checkParticles);
        EXPECT_EQ(check.code, 1);
        EXPECT_TRUE(check.says(std::string("limit (") + l.term + ")"))
            << check.out;
    }
}


TEST(stepLimits, followedByName)
{
    for (const limited& l : fixedSteps)
    {
        SCOPED_TRACE(l.term);
        systemCase c = column(l.change);
        c.set(control, "deltaT", "0.005");
        c.set(control, "endTime", "0.03");
        c.add(control, "adjustTimeStep yes; maxCo 1.9; maxDi 0.5;");
        const outcome o = c.run(app::gpuFsiFoam);
        ASSERT_EQ(o.code, 0) << o.out << o.err;
        EXPECT_TRUE
        (
            o.says(std::string("Time step limited by ") + l.term + "\n")
        ) << o.out;
    }
}


TEST(stepLimits, usersOwnAreNamed)
{
    systemCase c = column([](systemCase& c)
    {
        c.add(control, "adjustTimeStep yes; maxCo 0.2;");
    });
    EXPECT_TRUE(c.run(app::gpuFsiFoam).says("limited by maxCo"));
    c.set("constant/fluidProperties", "mu", "0.4");
    c.add(control, "maxDi 0.01;");
    c.add(schemes, "superTimeStepping off;");
    const outcome o = c.run(app::gpuFsiFoam);
    EXPECT_TRUE(o.says("limited by maxDi"));

    // 0.01 h^2/nu
    const std::vector<double> steps = stepsIn(o.out);
    ASSERT_FALSE(steps.empty());
    EXPECT_NEAR(*std::max_element(steps.begin(), steps.end()),
        0.01*0.0625*0.0625/0.4, 1e-9);
}


TEST(stepLimits, unstableWhereAllowed)
{
    systemCase c = column(fixedSteps[0].change);
    c.add(control, "allowUnstable yes;");
    const outcome o = c.run(app::gpuFsiFoam);
    EXPECT_EQ(o.code, 0) << o.err;
    EXPECT_TRUE(o.says("FOAM Warning : deltaT 0.13 is beyond the acoustic"))
        << o.err;
    EXPECT_TRUE(o.says("-fold a step"));
}


//- Euler without enough viscosity grows slowly: it runs, and is told
TEST(stepLimits, slowGrowthIsAWarning)
{
    const systemCase c = systemCase::piston();
    c.seed();
    const outcome o = c.run(app::gpuFsiFoam);
    EXPECT_EQ(o.code, 0);
    EXPECT_TRUE(o.says("is beyond the acoustic limit")) << o.err;
    const outcome check = c.run(app::checkParticles);
    EXPECT_EQ(check.code, 0) << check.out;
    EXPECT_TRUE(check.says("waves grow slowly"));
}


//- And no step is longer than the limits allow
TEST(stepLimits, writesAreExactWhileFollowing)
{
    systemCase c = column([](systemCase& c)
    {
        c.set(control, "endTime", "0.3");
        c.set(control, "writeControl", "adjustableRunTime");
        c.set(control, "writeInterval", "0.1");
        c.add(control, "adjustTimeStep yes; maxCo 0.37;");
    });
    const outcome o = c.run(app::gpuFsiFoam);
    ASSERT_EQ(o.code, 0) << o.err;
    EXPECT_EQ
    (
        c.timeNames(), (std::vector<std::string>{"0", "0.1", "0.2", "0.3"})
    );
    const std::string time = c.text("0.2/uniform/time");
    EXPECT_NE(time.find("value           0.2"), std::string::npos) << time;
    for (const double step : stepsIn(o.out))
    {
        EXPECT_LE(step, 0.37*0.0625*(1 + 1e-9));
    }
}


TEST(stepLimits, nothingToFollow)
{
    systemCase c = systemCase::piston();
    c.add(seeds, "fluid no;");
    elastic(c, "1", "3");
    c.seed();
    EXPECT_EQ(c.run(app::gpuFsiFoam).code, 0);
    c.add(control, "adjustTimeStep yes;");
    c.set(control, "startFrom", "firstTime");
    const outcome o = c.run(app::gpuFsiFoam);
    EXPECT_EQ(o.code, 1);
    EXPECT_TRUE(o.says("adjustTimeStep has no limit to follow")) << o.err;
    EXPECT_EQ(c.run(app::checkParticles).code, 0);
}


//- Viscosity far stiffer than sound takes super-steps by itself
TEST(stepLimits, superStepsWhereViscosityIsStiff)
{
    systemCase c = column([](systemCase& c)
    {
        c.set("constant/fluidProperties", "mu", "0.4");
        c.set(control, "deltaT", "0.04");
    });
    const outcome o = c.run(app::gpuFsiFoam);
    ASSERT_EQ(o.code, 0) << o.out << o.err;
    EXPECT_TRUE(o.says("superTimeStepping RKL2"));

    // 0.5 h^2/nu; half a step is 4.1 of them on a lattice, but walls are half a
    // spacing away
    EXPECT_TRUE(o.says("Viscosity: viscous limit 0.00488 s, acoustic "))
        << o.out;
    EXPECT_TRUE(o.says(": RKL2, 7 stages in each half of a step")) << o.out;
    const outcome check = c.run(app::checkParticles);
    EXPECT_EQ(check.code, 0) << check.out;
    EXPECT_TRUE(check.says("Viscosity takes super-steps (RKL2): viscous"));

    // As a limit that is followed
    c.add(control, "adjustTimeStep yes; maxCo 0.9;");
    const outcome followed = c.run(app::gpuFsiFoam);
    ASSERT_EQ(followed.code, 0) << followed.out << followed.err;
    EXPECT_TRUE(followed.says("as many stages as deltaT needs"));
    EXPECT_TRUE(followed.says("limited by maxCo\nViscosity in "))
        << followed.out;
}


TEST(stepLimits, superStepsOnlyWhereNeeded)
{
    const auto runs = [](const char* entry, const char* deltaT)
    {
        const systemCase c = column([&](systemCase& c)
        {
            c.set("constant/fluidProperties", "mu", "0.4");
            c.set(control, "deltaT", deltaT);
            c.set(control, "endTime", "0.01");
            c.add(schemes, entry);
        });
        const outcome o = c.run(app::gpuFsiFoam);
        EXPECT_EQ(o.code, 0) << o.err;
        return o.says("RKL2");
    };
    EXPECT_FALSE(runs("", "0.002"));
    EXPECT_FALSE(runs("superTimeStepping auto;", "0.002"));
    EXPECT_TRUE(runs("superTimeStepping on;", "0.002"));
}


TEST(stepLimits, superStepsRefused)
{
    const auto refused = [](const char* entries, const char* words)
    {
        systemCase c = column([](systemCase&) {});
        c.add(schemes, entries);
        const outcome o = c.run(app::gpuFsiFoam);
        EXPECT_EQ(o.code, 1);
        EXPECT_TRUE(o.says(words)) << o.err;
        EXPECT_TRUE(o.says(schemes)) << o.err;
    };
    refused("superTimeStepping maybe;", "auto");
    refused
    (
        "areaWeights radial; timeScheme Euler; superTimeStepping on;",
        "goes beyond the published scheme"
    );
    refused
    (
        "faces hermite; laplacianFactor 1.3; superTimeStepping on;",
        "needs gradients in every stage"
    );
}


//- Tait's speed of sound grows with the third power of density
TEST(stepLimits, soundIsFollowedWhereItIsFastest)
{
    const auto first = [](const char* amplitude)
    {
        const systemCase c = column([&](systemCase& c)
        {
            c.replace(seeds, "0.01*cos", amplitude);
            c.set(control, "endTime", "0.01");
            c.add(control, "adjustTimeStep yes; maxCo 0.1; maxDi 0.5;");
        });
        const outcome o = c.run(app::gpuFsiFoam);
        EXPECT_EQ(o.code, 0) << o.err;
        const std::vector<double> steps = stepsIn(o.out);
        return steps.empty() ? 0.0 : steps[0];
    };
    const double slow = first("0.0001*cos"), fast = first("0.4*cos");

    // maxCo h/(c + U): the densest row is that beside the end
    const double rho = 1 + 0.4*std::cos(0.0625*M_PI/2);
    EXPECT_NEAR(slow*(1.1/0.1), 0.0625, 0.004);
    EXPECT_NEAR(fast/slow, 1.1/(std::pow(rho, 3) + 0.1), 0.05);
}
