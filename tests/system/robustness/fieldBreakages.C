#include "breakage.H"

#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <limits>

namespace
{

constexpr app solver = app::gpuFsiFoam;
constexpr app vtk = app::particlesToVTK;

#define FLUID "0.2/lagrangian/fluid/"
#define WALLS "0.2/lagrangian/walls/"

//- The change, and a start from the time whose fields it concerns
damage restart(const damage& change)
{
    return [=](systemCase& c)
    {
        c.set("system/controlDict", "startFrom", "latestTime");
        change(c);
    };
}

//- All but the last bytes
damage cut(const char* file, std::size_t nBytes)
{
    return [=](systemCase& c)
    {
        const std::string all = c.text(file);
        c.write(file, all.substr(0, all.size() - nBytes));
    };
}

//- Bytes of the binary value that comes `offset` bytes into the list
template<class Number>
damage put(const char* file, std::size_t offset, Number value)
{
    return [=](systemCase& c)
    {
        std::string all = c.text(file);
        const std::size_t list = all.find("\n(", all.find("\n}"));
        std::memcpy(&all[list + 2 + offset], &value, sizeof value);
        c.write(file, all);
    };
}

damage folder(const char* file)
{
    return [=](systemCase& c)
    {
        c.remove(file);
        std::filesystem::create_directory(c.path()/file);
    };
}

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

//- A record of positions: newline, bracket, three coordinates, cell, bracket
constexpr std::size_t firstX = 2;

const std::vector<breakage> fields
{
    {"field cut short", solver, restart(cut(FLUID "U", 100)),
        "The file ends within U", "start from an earlier time"},
    {"field cut short for vtk", vtk, cut(FLUID "U", 100),
        "The file ends within U", "start from an earlier time"},
    {"positions cut short", solver, restart(cut(FLUID "positions", 400)),
        "The file ends within a position", "start from an earlier time"},
    {"positions cut for vtk", vtk, cut(FLUID "positions", 400),
        "The file ends within a position", "start from an earlier time"},
    {"field empty", solver, restart(overwrite(FLUID "rho", "")),
        "no FoamFile header", "first entry must be FoamFile"},
    {"field of text", solver, restart(overwrite(FLUID "rho", "1 2 3\n")),
        "no FoamFile header", "first entry must be FoamFile"},
    {"header cut", solver,
        restart(overwrite(FLUID "rho", "FoamFile\n{\n    format ")),
        "Expected a word", "start from an earlier time"},
    {"class of another field", solver,
        restart(replace(FLUID "rho", "scalarField", "labelField")),
        "rho", "start from an earlier time"},
    {"class unknown", solver,
        restart(replace(FLUID "rho", "scalarField", "volScalarField")),
        "Unknown cloud field type volScalarField", "symmTensorField"},
    {"class of no cloud", solver,
        restart(replace(FLUID "positions", "Cloud<passiveParticle>",
            "vectorField")),
        "vectorField is not a cloud", "Cloud<passiveParticle>"},
    {"count", solver, restart(replace(FLUID "rho", "\n2752\n", "\n2751\n")),
        "rho has 2751 values, but positions holds 2752", "same write"},
    {"count for vtk", vtk, replace(FLUID "rho", "\n2752\n", "\n2751\n"),
        "rho has 2751 values, but positions holds 2752", "same write"},
    {"count of positions", solver,
        restart(replace(FLUID "positions", "\n2752\n", "\n2751\n")),
        "after the positions", "start from an earlier time"},
    {"count beyond memory", solver,
        restart(replace(FLUID "positions", "\n2752\n", "\n99999999999\n")),
        "too short for 99999999999", "start from an earlier time"},
    {"count negative", solver,
        restart(replace(FLUID "positions", "\n2752\n", "\n-2752\n")),
        "-2752", "start from an earlier time"},
    {"rho not a number", solver, restart(put(FLUID "rho", 8*7, nan)),
        "Not a finite number: rho of particle 7",
        "start from an earlier time"},
    {"position not a number", solver,
        restart(put(FLUID "positions", firstX, nan)),
        "Not a finite number: position of particle 0",
        "start from an earlier time"},
    {"position outside", solver,
        restart(put(FLUID "positions", firstX, 99.)),
        "Particle 0 at (99", "Widen bounds"},
    {"density negative", solver, restart(put(FLUID "rho", 8*3, -1.)),
        "rho of particle 3 is -1", "must be positive"},
    {"mass zero", solver, restart(put(FLUID "m", 8*5, 0.)),
        "m of particle 5 is 0", "must be positive"},
    {"densities that disagree", solver, restart(put(FLUID "rho", 8*3, 1.5)),
        "rho = 1.5 of particle 3 is not rho0 + deltaRho",
        "Remove the file deltaRho"},
    {"patch out of range", solver, restart(put(WALLS "patch", 4*9, 3)),
        "Patch 3 is not one of the 1 walls", "must come from the same"},
    {"patch negative", solver, restart(put(WALLS "patch", 0, -1)),
        "Patch -1 is not one of the 1 walls", "must come from the same"},
    {"normal not a number", solver, restart(put(WALLS "normal", 0, nan)),
        "Not a finite number: normal of particle 0",
        "start from an earlier time"},
    {"64-bit labels", solver,
        restart(replace(WALLS "patch", "label=32", "label=64")),
        "label=64", "32-bit label build"},
    {"32-bit scalars for vtk", vtk,
        replace(FLUID "rho", "scalar=64", "scalar=32"),
        "scalar=32", "double precision"},
    {"other byte order", solver, restart(replace(FLUID "m", "LSB", "MSB")),
        "the other byte order", "double precision"},
    {"format", solver, restart(replace(FLUID "m", "binary", "base64")),
        "base64", "ascii"},
    {"binary that says ascii", solver,
        restart(replace(FLUID "m", "binary", "ascii")), "m",
        "start from an earlier time"},
    {"more after the list", solver, restart(add(FLUID "m", "(1 2 3)")),
        "There is more after the list", "one list and nothing else"},
    {"velocity missing", solver, restart(drop(FLUID "U")),
        "Cloud fluid has no field 'U'", "Run seedParticles"},
    {"normals missing", solver, restart(drop(WALLS "normal")),
        "Cloud walls has no field 'normal'", "Run seedParticles"},
    {"positions missing", solver, restart(drop(FLUID "positions")),
        "positions", "start from an earlier time"},
    {"cloud missing", solver, restart(drop("0.2/lagrangian/fluid")),
        "no cloud fluid", "Run seedParticles"},
    {"positions a directory", solver, restart(folder(FLUID "positions")),
        "positions", "start from an earlier time"},
    {"step index a word", solver, restart(set("0.2/uniform/time", "index",
        "second")), "second", "an integer was expected"},
    {"step not positive", solver,
        restart([](systemCase& c)
        {
            c.add("system/controlDict", "adjustTimeStep yes;");
            c.set("0.2/uniform/time", "deltaT", "-1");
        }),
        "deltaT is -1", "start from an earlier time"},
};

} // namespace


TEST(badInput, fields)
{
    for (const breakage& b : fields)
    {
        expectRefused(b);
    }
}
