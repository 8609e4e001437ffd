#include "breakage.H"

#include <gtest/gtest.h>

namespace
{

constexpr const char* solids = "constant/solidProperties";
constexpr const char* coupling = "constant/couplingProperties";
constexpr const char* control = "system/controlDict";
constexpr app solver = app::gpuFsiFoam;

//- The sound case with a ball in it, then the change. What was seeded before
//  holds no solid: seed again.
damage withBall(const damage& change)
{
    return [=](systemCase& c)
    {
        c.remove("0.2");
        c.add
        (
            "system/seedParticlesDict",
            "solids { ball { type sphere; centre (0 0 0); radius 3;"
            " parts { pole { surface yes; type box; min (-9 2 -9);"
            " max (9 9 9); } } } }"
        );
        c.set("system/particleSchemes", "areaWeights", "moment");
        c.seed();
        c.write
        (
            solids,
            "ball\n{\n    rho 2;\n    E 50;\n    nu 0.25;\n"
            "    parts\n    {\n        pole\n        {\n"
            "            type fixed;\n        }\n    }\n}\n"
        );
        change(c);
    };
}

//- A function object, in one line
damage measuring(const char* entry)
{
    return [=](systemCase& c)
    {
        withBall(replace(control, "functions\n{", "functions\n{"))(c);
        c.replace
        (
            control, "functions\n{", std::string("functions\n{ ") + entry
        );
    };
}

const std::vector<breakage> contact
{
    {"friction negative", solver,
        withBall(add(solids, "contact { friction -0.1; }")),
        "friction", "-0.1"},
    {"contact without stiffness", solver,
        withBall(add(solids, "contact { stiffness 0; }")),
        "stiffness", "0.001"},
    {"damping over critical", solver,
        withBall(add(solids, "contact { damping 2; }")), "damping", "2"},
    {"gap negative", solver, withBall(add(solids, "contact { gap -0.1; }")),
        "gap is -0.1 m", "must not be negative"},
    {"gap of a velocity", solver,
        withBall(add(solids, "contact { gap [0 1 -1 0 0 0 0] 1; }")),
        "dimensions", "[0 1 0"},
    {"margin zero", solver, withBall(add(solids, "contact { margin 0; }")),
        "margin", "must be positive"},
    {"contact in implicit steps", solver,
        withBall(add(solids, "stepping implicit; contact {}")),
        "Implicit steps have no contact", "stepping explicit"},
    {"contact a number", solver, withBall(add(solids, "contact 1;")),
        "contact", "dictionary"},
};

const std::vector<breakage> material
{
    {"solidProperties missing", solver, withBall(drop(solids)),
        "solidProperties", "Does it exist"},
    {"solid without properties", solver,
        withBall(unplaced(replace(solids, "ball", "bell"))), "ball", "bell"},
    {"density missing", solver, withBall(erase(solids, "rho")),
        "Entry 'rho' not found", "Add the entry 'rho'"},
    {"density negative", solver, withBall(set(solids, "rho", "-1")),
        "rho", "positive"},
    {"stiffness missing", solver, withBall(erase(solids, "E")),
        "Entry 'E' not found", "Add the entry 'E'"},
    {"stiffness negative", solver, withBall(set(solids, "E", "-1")),
        "E", "positive"},
    {"Poisson's ratio of a half", solver, withBall(set(solids, "nu", "0.5")),
        "nu", "0.499"},
    {"part of unknown type", solver, withBall(set(solids, "type", "glued")),
        "glued", "fixed"},
    {"part missing", solver,
        withBall(unplaced(replace(solids, "pole", "tip"))), "pole", "tip"},
};

const std::vector<breakage> together
{
    {"reference of a density", solver,
        withBall(overwrite(coupling,
            "referencePressure [1 -3 0 0 0 0 0] 1;\n")),
        "dimensions", "[1 -1 -2"},
    {"reference without number", solver,
        withBall(overwrite(coupling, "referencePressure high;\n")),
        "referencePressure", "a number was expected"},
    {"law unknown", solver, withBall(overwrite(coupling, "force both;\n")),
        "both", "reaction"},
};

const std::vector<breakage> functions
{
    {"forces on nothing", solver,
        replace(control, "functions\n{",
            "functions\n{ push { type forces; }"),
        "is about solids, but there are none", "Seed solids"},
    {"forces on an unknown solid", solver,
        measuring("push { type forces; solids (bell); }"),
        "there is no solid 'bell'", "Valid are: ball"},
    {"forces about two numbers", solver,
        measuring("push { type forces; CofR (0 0); }"), "CofR", "(x y z)"},
    {"probe without points", solver,
        measuring("tip { type displacementProbe; }"),
        "Entry 'points' not found", "Add the entry 'points'"},
    {"probe far away", solver,
        measuring("tip { type displacementProbe; points ((7 0 0)); }"),
        "from the nearest particle of a solid",
        "Choose a point of the unstrained solid"},
    {"energy of nothing", solver,
        replace(control, "functions\n{",
            "functions\n{ ledger { type solidEnergy; }"),
        "is about solids, but there are none", "Seed solids"},
};

} // namespace


TEST(badInput, solidProperties)
{
    for (const breakage& b : material)
    {
        expectRefused(b);
    }
}


TEST(badInput, contact)
{
    for (const breakage& b : contact)
    {
        expectRefused(b);
    }
}


TEST(badInput, couplingProperties)
{
    for (const breakage& b : together)
    {
        expectRefused(b);
    }
}


TEST(badInput, functionsOfSolids)
{
    for (const breakage& b : functions)
    {
        expectRefused(b);
    }
}
