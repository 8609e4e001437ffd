#include "lattice.H"

#include "functionObjects/pointSampler.H"

using namespace gpuFsi;

namespace
{

double linear(const vector& p)
{
    return 0.3 + 0.5*p.x - 0.7*p.y + 0.2*p.z;
}

void giveLinearFields(particleSet& set)
{
    set.deltaRho.clear();
    set.U.clear();
    for (const vector& p : set.positions)
    {
        set.deltaRho.push_back(linear(p));
        set.U.push_back({p.y, 2*p.x, linear(p)});
    }
}

std::vector<vector> manyPoints(int dimensions)
{
    std::vector<vector> points{{0, 0, 0}, {1, 1, 0}};
    for (int i = 0; i < 40; ++i)
    {
        points.push_back
        ({
            std::fmod(0.618*i, 1.0), std::fmod(0.755*i, 1.0),
            dimensions == 3 ? std::fmod(0.57*i, 1.0) : 0
        });
    }
    return points;
}

//- Nearest particle by looking at all
double nearestValue(const hostState& state, const vector& p)
{
    double least = 1e300;
    double value = 0;
    for (const particleSet* set : {&state.fluid, &state.walls})
    {
        for (std::size_t i = 0; i < set->size(); ++i)
        {
            const vector d = set->positions[i] - p;
            if (dot(d, d) < least)
            {
                least = dot(d, d);
                value = set->deltaRho[i];
            }
        }
    }
    return value;
}

} // namespace


TEST(pointSampler, leastSquaresReproducesLinearFieldsOnDisplacedPoints)
{
    for (int D : {2, 3})
    {
        hostState state = lattice(9, D, 0.35);
        giveLinearFields(state.fluid);
        pointSampler sampler(dictionary("d"), manyPoints(D));
        sampler.update(state);
        const auto values = sampler.values(state.fluid.deltaRho, {}, 1);
        for (std::size_t i = 0; i < values.size(); ++i)
        {
            EXPECT_NEAR(values[i], linear(sampler.points()[i]), 1e-13)
                << D << " " << i;
        }
    }
}


TEST(pointSampler, leastSquaresReproducesQuadraticFieldsInside)
{
    const auto quadratic = [](const vector& p)
    {
        return linear(p) + p.x*p.x - 2*p.x*p.y + 3*p.y*p.y + p.z*p.x
            - 0.5*p.y*p.z + 0.25*p.z*p.z;
    };
    for (int D : {2, 3})
    {
        hostState state = lattice(9, D, 0.35);
        for (std::size_t i = 0; i < state.fluid.size(); ++i)
        {
            state.fluid.deltaRho[i] = quadratic(state.fluid.positions[i]);
        }
        std::vector<vector> points;
        for (const vector& p : manyPoints(D))
        {
            const double z = D == 3 ? 0.2 + 0.6*p.z : 0;
            points.push_back({0.2 + 0.6*p.x, 0.2 + 0.6*p.y, z});
        }
        pointSampler sampler(dictionary("d"), points);
        sampler.update(state);
        const auto values = sampler.values(state.fluid.deltaRho, {}, 1);
        for (std::size_t i = 0; i < values.size(); ++i)
        {
            EXPECT_NEAR(values[i], quadratic(points[i]), 1e-12)
                << D << " " << i;
        }
    }
}


TEST(pointSampler, beyondTheFluidNoiseIsNotMagnified)
{
    hostState state = lattice(9, 3, 0.35);
    for (std::size_t i = 0; i < state.fluid.size(); ++i)
    {
        state.fluid.deltaRho[i] = i % 2 ? 1 : -1;
    }
    pointSampler sampler
    (
        dictionary("d"),
        {{-0.1, -0.1, -0.1}, {1.2, 0.5, 0.5}, {0.5, 0.5, -0.05}}
    );
    sampler.update(state);
    for (double value : sampler.values(state.fluid.deltaRho, {}, 1))
    {
        EXPECT_LT(std::abs(value), 4);
    }
}


TEST(pointSampler, nearestEqualsASearchThroughAll)
{
    for (int D : {2, 3})
    {
        hostState state = lattice(9, D, 0.35);
        state.walls.positions = {{0.01, 0.02, 0}, {1, 0.9, 0}};
        giveLinearFields(state.fluid);
        giveLinearFields(state.walls);
        const dictionary dict =
            dictionary::fromString("interpolationScheme nearest;");
        pointSampler sampler(dict, manyPoints(D));
        sampler.update(state);
        const auto values =
            sampler.values(state.fluid.deltaRho, state.walls.deltaRho, 1);
        for (std::size_t i = 0; i < values.size(); ++i)
        {
            EXPECT_EQ(values[i], nearestValue(state, sampler.points()[i]));
        }
    }
}


TEST(pointSampler, ShepardEqualsTheWeightedMean)
{
    hostState state = lattice(6, 3, 0.3);
    giveLinearFields(state.fluid);
    const dictionary dict =
        dictionary::fromString("interpolationScheme Shepard;");
    const vector p{0.4, 0.55, 0.61};
    pointSampler sampler(dict, {p});
    sampler.update(state);
    double above = 0, below = 0;
    for (std::size_t i = 0; i < state.fluid.size(); ++i)
    {
        const vector d = state.fluid.positions[i] - p;
        const double q = std::sqrt(dot(d, d))*6/2.5;     // over 2.5 h
        const double w = q < 1 ? std::pow(1 - q, 4)*(4*q + 1) : 0;
        above += w*state.fluid.deltaRho[i];
        below += w;
    }
    const auto values = sampler.values(state.fluid.deltaRho, {}, 1);
    EXPECT_NEAR(values[0], above/below, 1e-14);
}


TEST(pointSampler, fewParticlesGiveTheirMeanAndNoneGivesNaN)
{
    hostState state = lattice(2, 3, 0);              // h = 1/2
    state.fluid.positions = {{0.2, 0, 0}, {-0.2, 0, 0}};
    state.fluid.deltaRho = {1, 3};
    pointSampler sampler(dictionary("d"), {{0, 0, 0}, {9, 9, 9}});
    sampler.update(state);
    const auto values = sampler.values(state.fluid.deltaRho, {}, 1);
    EXPECT_NEAR(values[0], 2, 1e-15);
    EXPECT_TRUE(std::isnan(values[1]));
    EXPECT_FALSE(sampler.inside(1));
}


TEST(probes, writeAFileAFieldAsOpenFoamDoes)
{
    testRun run;
    hostState state = lattice(8, 3, 0.2);
    giveLinearFields(state.fluid);
    const dictionary dict = dictionary::fromString
    (
        "functions { p { type probes; fields (rho U p);"
        " probeLocations ((0.5 0.5 0.5) (0.2 0.3 0.4)); } }"
    );
    functionObjectList list(dict, run.info);
    list.start(state, run.info);
    run.step(2);
    list.execute(state, run.info);
    EXPECT_TRUE(dict.unread().empty());

    const vector p{0.2, 0.3, 0.4};
    const auto rho = run.rows("p/0/rho");
    ASSERT_EQ(rho.size(), 2u);
    ASSERT_EQ(rho[1].size(), 3u);
    EXPECT_NEAR(rho[1][0], 0.2, 1e-12);
    EXPECT_NEAR(rho[1][2], 2 + linear(p), 1e-7);
    const auto pressure = run.rows("p/0/p");
    EXPECT_NEAR(pressure[0][2], 3*(2 + linear(p)) + 5, 1e-6);
    const auto U = run.rows("p/0/U");
    ASSERT_EQ(U[0].size(), 7u);
    EXPECT_NEAR(U[0][4], 0.3, 1e-7);
    EXPECT_NEAR(U[0][5], 0.4, 1e-7);

    const std::string text = run.text("p/0/U");
    expectIn
    (
        "# Probe 0 (0.5 0.5 0.5)\n# Probe 1 (0.2 0.3 0.4)\n"
        "# Probe\t0\t1\n# Time\n0\t(",
        text
    );
}


TEST(sets, writeAFileALineAndTime)
{
    testRun run;
    hostState state = lattice(8, 2, 0.2);
    giveLinearFields(state.fluid);
    const dictionary dict = dictionary::fromString
    (
        "functions { lines { type sets; fields (deltaRho U); sets {"
        " up { start (0.5 0.1 0); end (0.5 0.9 0); nPoints 5; axis y; }"
        " across { start (0.1 0.1 0); end (0.4 0.5 0); nPoints 2; } } }"
        " one { type sets; fields (p); start (0.5 0.5 0); end (0.5 5 0);"
        " nPoints 4; axis x; } }"
    );
    functionObjectList list(dict, run.info);
    list.start(state, run.info);
    run.step(6);
    list.execute(state, run.info);
    EXPECT_TRUE(dict.unread().empty());

    const auto up = run.rows("lines/0.6/up_deltaRho_U.xy");
    ASSERT_EQ(up.size(), 5u);
    for (int i = 0; i < 5; ++i)
    {
        const vector p{0.5, 0.1 + 0.2*i, 0};
        ASSERT_EQ(up[i].size(), 5u);
        EXPECT_NEAR(up[i][0], p.y, 1e-8);
        EXPECT_NEAR(up[i][1], linear(p), 1e-8);
        EXPECT_NEAR(up[i][2], p.y, 1e-8);
        EXPECT_NEAR(up[i][3], 1, 1e-8);
    }
    expectIn
    (
        "# y\tdeltaRho\tU_x\tU_y\tU_z\n",
        run.text("lines/0/up_deltaRho_U.xy")
    );
    EXPECT_NEAR
    (
        run.rows("lines/0/across_deltaRho_U.xy").at(1).at(0), 0.5, 1e-8
    );
    const auto one = run.rows("one/0/one_p.xy");
    EXPECT_NEAR(one.at(0).at(0), 0.5, 1e-8);
    EXPECT_TRUE(std::isnan(one.at(3).at(1)));
}


TEST(sets, writeTheExactSolutionBesideTheFields)
{
    testRun run;
    const hostState state = lattice(8, 2, 0.2);
    const dictionary dict = dictionary::fromString
    (
        "functions { one { type sets; fields (rho U); exact hydrostatic;"
        " g (0 -1 0); start (0.5 0.1 0); end (0.5 0.9 0); nPoints 3;"
        " axis y; } }"
    );
    functionObjectList list(dict, run.info);
    list.start(state, run.info);
    EXPECT_TRUE(dict.unread().empty());

    expectIn
    (
        "# y\trho\texact_rho\tU_x\tU_y\tU_z\t"
        "exact_U_x\texact_U_y\texact_U_z\n",
        run.text("one/0/one_rho_U.xy")
    );
    const double c2 = run.info.c*run.info.c;
    for (const auto& row : run.rows("one/0/one_rho_U.xy"))
    {
        ASSERT_EQ(row.size(), 9u);
        EXPECT_NEAR(row[2], run.info.rho0*std::exp(-row[0]/c2), 1e-7*row[2]);
        EXPECT_EQ(row[7], 0);
    }
}


TEST(sampling, badEntriesAreErrors)
{
    testRun run;
    const hostState state = lattice(4, 3, 0);
    const auto message = [&](const std::string& keys)
    {
        const dictionary dict =
            dictionary::fromString("functions { a { " + keys + " } }");
        return messageOf
        (
            [&] { functionObjectList(dict, run.info).start(state, run.info); }
        );
    };
    expectIn
    (
        "Unknown field type q",
        message("type probes; fields (U q); probeLocations ((0 0 0));")
    );
    expectIn
    (
        "probeLocations is empty",
        message("type probes; fields (U); probeLocations ();")
    );
    expectIn
    (
        "Probe 1 of a at (5 0 0) lies outside the fluid",
        message("type probes; fields (U); probeLocations ((0 0 0) (5 0 0));")
    );
    expectIn
    (
        "lies outside the fluid",
        message
        (
            "type sets; fields (U); start (5 0 0); end (6 0 0); nPoints 3;"
        )
    );
    expectIn
    (
        "nPoints",
        message
        (
            "type sets; fields (U); start (0 0 0); end (1 0 0); nPoints 1;"
        )
    );
    expectIn
    (
        "movingLeastSquares",
        message
        (
            "type probes; fields (U); probeLocations ((0 0 0));"
            " interpolationScheme cubic;"
        )
    );
}
