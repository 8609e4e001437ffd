#include "breakage.H"

#include <gtest/gtest.h>

namespace
{

constexpr app seed = app::seedParticles;
constexpr app solver = app::gpuFsiFoam;
constexpr app vtk = app::particlesToVTK;

const std::vector<breakage> options
{
    {"unknown option", solver, nothing(), "Invalid option: -sace",
        "Did you mean -case?", {"-sace"}},
    {"unknown option of seedParticles", seed, nothing(),
        "Invalid option: -quick", "-help for the options", {"-quick"}},
    {"unknown option of particlesToVTK", vtk, nothing(),
        "Invalid option: -lastTime", "Did you mean -latestTime?",
        {"-lastTime"}},
    {"option twice", solver, nothing(), "is given twice",
        "-help for the options",
        {"-noFunctionObjects", "-noFunctionObjects"}},
    {"option without value", seed, nothing(), "needs a parameter <file>",
        "-help for the options", {"-dict"}},
    {"case without value", solver, nothing(), "needs a parameter <dir>",
        "-help for the options", {"-case"}},
    {"no such case", solver, nothing(), "Case directory /nowhere",
        "Give the directory", {"-case", "/nowhere"}},
    {"a directory that is no case", solver, nothing(), "is not a case",
        "give one with -case", {"-case", "constant"}},
    {"argument too many", solver, nothing(), "Unexpected argument: pulse",
        "-help for the options", {"pulse"}},
    {"dictionary that is missing", seed, nothing(), "seedDict", "Does it exist",
        {"-dict", "system/seedDict"}},
    {"dictionary that is a directory", seed, nothing(), "system",
        "Does it exist",
        {"-dict", "system"}},
    {"times that are none", vtk, nothing(), "soon", "':10,20,40:70'",
        {"-time", "soon"}},
    {"time that is not there", vtk, nothing(), "-time 7 selects none",
        "times of the case: 0 0.2",
        {"-time", "7"}},
    {"field that is not there", vtk, nothing(), "temperature", "rho",
        {"-fields", "(temperature)"}},
    {"picture of nothing", vtk, nothing(), "temperature", "rho",
        {"-image", "a.png", "-field", "temperature"}},
    {"picture option without picture", vtk, nothing(),
        "has a meaning only with -image", "Add -image",
        {"-colours", "grey"}},
};

//- A file stands where a folder must be: as good as no leave to write
const std::vector<breakage> places
{
    {"file in place of 0", seed,
        [](systemCase& c) { c.remove("0"); c.write("0", "mine\n"); },
        "0", "permissions of the case directory"},
    {"file in place of polyMesh", seed,
        [](systemCase& c)
        {
            c.remove("constant/polyMesh");
            c.write("constant/polyMesh", "mine\n");
        },
        "polyMesh", "permissions of the case directory"},
    {"file in place of postProcessing", solver,
        [](systemCase& c)
        {
            c.remove("postProcessing");
            c.write("postProcessing", "mine\n");
        },
        "postProcessing", "permissions"},
    {"file in place of a time", solver,
        [](systemCase& c)
        {
            c.write("0.4", "mine\n");
        },
        "a file has that name", "Move the file elsewhere",
        {"-noFunctionObjects"}},
    {"file in place of VTK", vtk,
        [](systemCase& c) { c.write("VTK", "mine\n"); }, "VTK", "permissions"},
    {"file in place of system", solver,
        [](systemCase& c) { c.remove("system"); c.write("system", ""); },
        "is not a case", "give one with -case"},
    {"no time at all", solver,
        unplaced
        (
            [](systemCase& c)
            {
                c.remove("0");
                c.remove("0.2");
                c.set("system/controlDict", "startTime", "0");
            }
        ),
        "There is no time folder", "Run seedParticles first"},
};

} // namespace


TEST(badInput, commandLine)
{
    for (const breakage& b : options)
    {
        expectRefused(b);
    }
}


TEST(badInput, placesTaken)
{
    for (const breakage& b : places)
    {
        expectRefused(b);
    }
}
