#include "lattice.H"

#include "functionObjects/dampedFit.H"

using namespace gpuFsi;

TEST(waveFit, findsFrequencyAndDecayOfAnExactSeries)
{
    // The first guess 10% off, sixteen periods, uneven times
    dampedFit fit(2.2, 0);
    EXPECT_TRUE(std::isnan(fit.omega()));
    for (int n = 0; n < 500; ++n)
    {
        const double t = 3 + 0.1*n + 0.02*(n % 3);
        fit.add(t, std::exp(-0.03*t)*std::cos(2*t + 0.4));
    }
    EXPECT_NEAR(fit.omega(), 2, 1e-9);
    EXPECT_NEAR(fit.decay(), 0.03, 1e-9);
    EXPECT_LT(fit.residual(), 1e-8);
}

TEST(waveFit, projectsTheFieldOnItsShape)
{
    testRun run;
    hostState state = lattice(16, 2, 0);
    const auto amplitude = [&]
    {
        return 1e-7*std::exp(-0.2*run.info.time)*std::cos(5.1*run.info.time);
    };
    const auto setField = [&]
    {
        for (std::size_t i = 0; i < state.fluid.size(); ++i)
        {
            state.fluid.deltaRho[i] = amplitude()
               *std::cos(std::acos(-1.0)*state.fluid.positions[i].x);
        }
    };
    setField();
    functionObjectList list
    (
        dictionary::fromString
        (
            "functions { wave { type waveFit; field deltaRho;"
            " shape \"cos(pi*x)\"; omega 5; decay 0.1; log no; } }"
        ),
        run.info
    );
    list.start(state, run.info);
    for (int n = 1; n <= 60; ++n)
    {
        run.step(n);
        setField();
        list.execute(state, run.info);
    }
    const auto rows = run.rows("wave/0/waveFit.dat");
    ASSERT_EQ(rows.size(), 61u);
    EXPECT_NEAR(rows.back()[1], amplitude(), 1e-12);
    EXPECT_NEAR(rows.back()[2], 5.1, 1e-5);
    EXPECT_NEAR(rows.back()[3], 0.2, 1e-5);
}

TEST(waveFit, refusesAVelocity)
{
    testRun run;
    expectIn("deltaRho, rho or p", messageOf([&]
    {
        functionObjectList
        (
            dictionary::fromString
            (
                "functions { wave { type waveFit; field U; shape \"x\";"
                " omega 5; } }"
            ),
            run.info
        );
    }));
}
