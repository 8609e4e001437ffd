#include "breakage.H"

#include <gtest/gtest.h>

#include <filesystem>

namespace
{

constexpr const char* fluid = "constant/fluidProperties";
constexpr const char* gravity = "constant/g";
constexpr const char* walls = "constant/wallProperties";
constexpr const char* schemes = "system/particleSchemes";
constexpr const char* space = "constant/domain";
constexpr app solver = app::gpuFsiFoam;

const std::vector<breakage> properties
{
    {"density negative", solver, set(fluid, "rho0", "-1"),
        "'rho0' is -1", "must be positive"},
    {"density of a pressure", solver,
        set(fluid, "rho0", "[1 -1 -2 0 0 0 0] 1"), "dimensions", "[1 -3 0"},
    {"viscosity negative", solver, set(fluid, "mu", "-1"),
        "viscosity is -1", "must not be negative"},
    {"viscosity missing", solver, erase(fluid, "mu"),
        "Entry 'mu' not found", "Add the entry 'mu'"},
    {"viscosity kinematic", solver, set(fluid, "mu", "[0 2 -1 0 0 0 0] 1"),
        "dimensions", "[1 -1 -1"},
    {"viscosity twice", solver, add(fluid, "nu 1;"),
        "'mu' and 'nu' both", "Keep one"},
    {"viscosity without number", solver, set(fluid, "mu", ""), "mu",
        "a number was expected"},
    {"equation of state", solver, set(fluid, "type", "idealGas"),
        "idealGas", "isothermal"},
    {"equation of state missing", solver,
        replace(fluid, "equationOfState", "equationOfSate"),
        "equationOfState", "equationOfSate"},
    {"sound speed negative", solver,
        set(fluid, "type", "linear; c -2"), "'c' is -2", "must be positive"},
    {"sound speed twice", solver,
        set(fluid, "type", "linear; c 2; c2 4"), "both", "Keep one"},
    {"exponent", solver, set(fluid, "type", "Tait; c 1; gamma 0.5"),
        "gamma", "0.5"},
    {"rho0 changed since", solver,
        [](systemCase& c)
        {
            c.set("system/controlDict", "startFrom", "latestTime");
            c.set(fluid, "rho0", "2");
            c.write("0.2/lagrangian/fluid/rho",
                c.text("0.2/lagrangian/fluid/rho"));    // is named
        },
        "is not rho0 + deltaRho", "restore rho0"},
    {"fluidProperties missing", solver, drop(fluid), "fluidProperties",
        "Does it exist"},
    {"fluidProperties a directory", solver,
        [](systemCase& c)
        {
            c.remove(fluid);
            std::filesystem::create_directory(c.path()/fluid);
        },
        "fluidProperties", "Does it exist"},
    {"gravity of a velocity", solver,
        overwrite(gravity, "dimensions [0 1 -1 0 0 0 0];\n"
            "value [0 1 -1 0 0 0 0] (0 -9.81 0);\n"),
        "dimensions", "[0 1 -2"},
    {"gravity a number", solver,
        overwrite(gravity, "dimensions [0 1 -2 0 0 0 0];\nvalue -9.81;\n"),
        "value", "(x y z)"},
    {"body force of places", solver,
        overwrite(gravity, "value (\"sin(x + t)\" 0 0);\n"),
        "depends on x", "of the time t alone"},
    {"body force of two components", solver,
        overwrite(gravity, "value (\"sin(t)\" 0);\n"),
        "has 2 components, not 3", "Write value"},
    {"body force that is no expression", solver,
        overwrite(gravity, "value (\"sin(omega*t)\" 0 0);\n"),
        "'sin(omega*t)' cannot be read", "x y z r t"},
    {"body force not finite", solver,
        overwrite(gravity, "value (\"1/(t - t)\" 0 0);\n"),
        "The body force '1/(t - t)' is", "Guard"},
    {"wall motion", solver,
        overwrite(walls, "cylinder\n{\n    type swirl;\n}\n"),
        "Unknown wall motion type swirl", "rotation"},
    {"wall motion fits no axis", solver,
        overwrite(walls, "cylinder { type rotation; origin (0 0 0);\n"
            "axis (0 0 0); omega 1; }\n"),
        "axis of a rotation", "must not be zero"},
    {"wall motion incomplete", solver,
        overwrite(walls, "cylinder { type translation; }\n"),
        "Entry 'velocity' not found", "Add the entry 'velocity'"},
};

const std::vector<breakage> scheme
{
    {"area weights", solver, set(schemes, "areaWeights", "kernel"),
        "kernel", "radial"},
    {"time scheme", solver, set(schemes, "timeScheme", "RK4"),
        "RK4", "Euler"},
    {"scheme beyond radial weights", solver,
        set(schemes, "timeScheme", "symplecticEuler"),
        "areaWeights is radial", "Set 'areaWeights moment'"},
    {"neighbour search", solver, set(schemes, "method", "tree"),
        "tree", "localUpdate"},
    {"neighbour update", solver, set(schemes, "update", "always"),
        "always", "interval"},
    {"interval missing", solver, set(schemes, "update", "interval"),
        "Entry 'interval' not found", "Add the entry 'interval'"},
    {"displacement negative", solver,
        set(schemes, "update", "displacement; displacement -1"),
        "displacement", "from 1e-06 to 1"},
    {"search radius", solver,
        set(schemes, "update", "displacement; searchRadius 9"),
        "searchRadius", "from 1.8 to 4"},
    {"particleSchemes missing", solver, drop(schemes), "particleSchemes",
        "Does it exist"},
};

const std::vector<breakage> domains
{
    {"domain missing", solver, drop(space), "There is no file",
        "Run seedParticles first"},
    {"domain empty", solver, overwrite(space, ""), "Entry",
        "the dictionary is empty"},
    {"domain upside down", solver, set(space, "hi", "(-8 -8 -8)"),
        "must be above lo", "run it again"},
    {"domain without spacing", solver, set(space, "spacing", "0"),
        "spacing must be positive", "run it again"},
    {"domain in 4-D", solver, set(space, "dimensions", "4"),
        "2 or 3", "run it again"},
    {"domain cut short", solver, replace(space, "(cylinder);", "(cylinder"),
        "is not closed", "Close it before the ';'"},
};

} // namespace


TEST(badInput, properties)
{
    for (const breakage& b : properties)
    {
        expectRefused(b);
    }
}


TEST(badInput, schemes)
{
    for (const breakage& b : scheme)
    {
        expectRefused(b);
    }
}


TEST(badInput, domain)
{
    for (const breakage& b : domains)
    {
        expectRefused(b);
    }
}
