// Keys that nobody reads are reported; runs that break down say where.
#include "systemCase.H"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

namespace
{

constexpr const char* control = "system/controlDict";

//- Warned on stderr, and the program goes on to its end
void expectWarning
(
    app program,
    const char* file,
    const char* line,
    const std::string& key,
    const std::string& meant
)
{
    systemCase c = systemCase::piston();
    c.seed();
    c.add(file, line);
    const outcome o = c.run(program);
    SCOPED_TRACE(std::string(line) + '\n' + o.err);
    EXPECT_EQ(o.code, 0);
    EXPECT_NE(o.err.find("--> FOAM Warning"), std::string::npos);
    EXPECT_NE(o.err.find('\'' + key + '\''), std::string::npos);
    EXPECT_NE(o.err.find((c.path()/file).string()), std::string::npos);
    EXPECT_NE
    (
        o.err.find("at line " + std::to_string(c.editedLine())),
        std::string::npos
    );
    if (!meant.empty())
    {
        EXPECT_NE(o.err.find('\'' + meant + "' meant?"), std::string::npos);
    }
    EXPECT_NE(o.out.find("\nEnd"), std::string::npos);
}

} // namespace


TEST(warnings, keysNobodyReads)
{
    constexpr app solver = app::gpuFsiFoam;
    expectWarning(solver, control, "purgeWrit 2;", "purgeWrit", "purgeWrite");
    expectWarning(solver, control, "backEnd cpu;", "backEnd", "backend");
    expectWarning(solver, control, "colour blue;", "colour", "");
    expectWarning
    (
        solver, control,
        "functions { a { type budgets; writeIntervall 1; } }",
        "writeIntervall", "writeInterval"
    );
    expectWarning
    (
        solver, "system/particleSchemes", "areaWeight radial;",
        "areaWeight", "areaWeights"
    );
    expectWarning
    (
        solver, "system/particleSchemes",
        "neighbours { displacment 0.2; }", "displacment", "displacement"
    );
    expectWarning
    (
        solver, "constant/fluidProperties", "rho_0 1;", "rho_0", "rho0"
    );
    expectWarning
    (
        solver, "constant/wallProperties", "ende { type fixed; }",
        "ende", "end"
    );
    expectWarning
    (
        app::seedParticles, "system/seedParticlesDict", "displaced 0.1;",
        "displaced", "displace"
    );
    expectWarning
    (
        app::seedParticles, "system/seedParticlesDict",
        "regions { end { sides inside; } }", "sides", "side"
    );
}


TEST(warnings, noneForTheTutorial)
{
    systemCase c = systemCase::pulse();
    for (const app program : {app::seedParticles, app::gpuFsiFoam})
    {
        const outcome o = c.run(program);
        EXPECT_EQ(o.code, 0);
        EXPECT_EQ(o.err, "");
    }
}


namespace
{

//- The text from `begin` up to `end`
std::string between
(
    const std::string& text,
    const std::string& begin,
    const std::string& end
)
{
    const std::size_t at = text.find(begin);
    if (at == std::string::npos)
    {
        ADD_FAILURE() << begin << " is not in " << text;
        return {};
    }
    const std::size_t from = at + begin.size();
    return text.substr(from, text.find(end, from) - from);
}

//- The i-th number of a field's file, a binary list
double valueOf(const systemCase& c, const std::string& file, std::size_t i)
{
    const std::string bytes = c.text(file);
    const std::size_t list = bytes.find("\n(", bytes.find("\n}")) + 2;
    double value = 0;
    std::memcpy(&value, &bytes.at(list + 8*i), sizeof value);
    return value;
}

//- Of the i-th record of positions: newline, bracket, coordinates, cell and
//  bracket
double firstX(const systemCase& c, const std::string& file, std::size_t i)
{
    const std::string bytes = c.text(file);
    const std::size_t list = bytes.find("\n(", bytes.find("\n}")) + 2;
    double value = 0;
    std::memcpy(&value, &bytes.at(list + 31*i + 2), sizeof value);
    return value;
}

} // namespace


TEST(breakdown, saysWhereAndKeepsTheStateAside)
{
    for (const char* precision : {"single", "double"})
    {
        systemCase c = systemCase::pulse();
        c.set("system/seedParticlesDict", "rho", "\"1 + 0.5*exp(-r^2/5)\"");
        c.set(control, "precision", precision);
        c.set(control, "writeControl", "timeStep");
        c.set(control, "writeInterval", "1");
        c.replace(control, "functions", "notUsed");
        c.seed();
        c.set(control, "endTime", "0.1");
        ASSERT_EQ(c.run(app::gpuFsiFoam).code, 0);
        const fileTree before = c.tree();
        ASSERT_EQ(c.timeNames().size(), 3u);

        // Far beyond the limits of sound and of viscosity
        c.set(control, "startFrom", "latestTime");
        c.set(control, "deltaT", "50");
        c.add(control, "allowUnstable yes;");
        c.set(control, "endTime", "100000");
        c.set(control, "writeInterval", "1000000");
        const outcome o = c.run(app::gpuFsiFoam);
        SCOPED_TRACE(o.err);
        EXPECT_EQ(o.code, 1);
        EXPECT_NE(o.err.find("--> FOAM FATAL"), std::string::npos);
        const std::string time =
            between(o.err, "broke down at Time = ", ":");
        const std::size_t id =
            std::stoul(between(o.err, "fluid particle ", " at ("));
        const double rho = std::stod(between(o.err, "field rho = ", "\n"));
        const double x = std::stod(between(o.err, " at (", " "));
        EXPECT_NE(o.err.find("smaller deltaT"), std::string::npos);
        EXPECT_NE(o.err.find("broken_" + time), std::string::npos);

        // All as it was, and the broken state, which is no time folder
        const std::string fluid = "broken_" + time + "/lagrangian/fluid/";
        EXPECT_FALSE(rho > 0);
        EXPECT_NEAR(valueOf(c, fluid + "rho", id), rho, 1e-6);
        EXPECT_NEAR(firstX(c, fluid + "positions", id), x, 1e-6);
        fileTree after = c.tree();
        fileTree expected = before;
        expected[control] = c.text(control);
        for (const auto& [name, bytes] : c.tree())
        {
            if (name.compare(0, 7, "broken_") == 0)
            {
                after.erase(name);
            }
        }
        EXPECT_EQ(difference(after, expected), "");
        EXPECT_EQ(c.timeNames().size(), 3u);

        // A sound step goes on from there
        c.set(control, "deltaT", "0.05");
        c.set(control, "endTime", "0.2");
        EXPECT_EQ(c.run(app::gpuFsiFoam).code, 0);
    }
}


//- Sound that Euler drives, slowly enough to be let through: stopped while all
//  is finite, by energy that nothing gave
TEST(breakdown, energyFromNowhereStopsTheRun)
{
    systemCase c = systemCase::pulse();
    c.set(control, "deltaT", "0.15");
    c.set(control, "endTime", "1000");
    c.set(control, "writeControl", "timeStep");
    c.set(control, "writeInterval", "1000");
    c.set("constant/fluidProperties", "mu", "0.001");
    c.replace(control, "functions", "notUsed");
    c.seed();
    std::string said;
    for (const char* threads : {"1", "3"})
    {
        const systemCase run(c);
        const outcome o = run.run
        (
            app::gpuFsiFoam, {}, {std::string("OMP_NUM_THREADS=") + threads}
        );
        SCOPED_TRACE(o.err);
        EXPECT_EQ(o.code, 1);
        EXPECT_TRUE(o.says("the fluid's kinetic energy is "));
        EXPECT_TRUE(o.says("beyond the shortest limit of an even lattice, the "
            "acoustic one"));
        EXPECT_TRUE(o.says("the last time folder is intact"));
        const std::string time = between(o.err, "broke down at Time = ", ":");
        const std::size_t id =
            std::stoul(between(o.err, "fluid particle ", " at ("));
        const double x = std::stod(between(o.err, " at (", " "));
        const std::string fluid = "broken_" + time + "/lagrangian/fluid/";
        EXPECT_NEAR(firstX(run, fluid + "positions", id), x, 1e-6);
        const double rho = valueOf(run, fluid + "rho", id);
        EXPECT_TRUE(rho > 0 && std::isfinite(rho)) << rho;
        const std::string now = o.err.substr(o.err.find("broke down"));
        EXPECT_TRUE(said.empty() || said == now) << said;
        said = now;
    }
    // Whoever wants to see it all the same
    c.add(control, "allowUnstable yes;");
    const outcome o = c.run(app::gpuFsiFoam);
    EXPECT_FALSE(o.says("the fluid's kinetic energy is "));
}
