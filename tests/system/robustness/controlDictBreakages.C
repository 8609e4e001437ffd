#include "breakage.H"

#include <gtest/gtest.h>

namespace
{

constexpr const char* file = "system/controlDict";
constexpr app solver = app::gpuFsiFoam;

const std::vector<breakage> values
{
    {"deltaT zero", solver, set(file, "deltaT", "0"),
        "deltaT", "must be positive"},
    {"deltaT negative", solver, set(file, "deltaT", "-0.05"),
        "deltaT", "must be positive"},
    {"deltaT a word", solver, set(file, "deltaT", "small"),
        "small", "number"},
    {"deltaT two values", solver, set(file, "deltaT", "0.1 0.2"),
        "deltaT", "number"},
    {"deltaT infinite", solver, set(file, "deltaT", "1e999"),
        "1e999", "Magnitudes lie between"},
    {"deltaT beyond stability", solver, set(file, "deltaT", "0.5"),
        "deltaT 0.5 is beyond the viscous limit", "allowUnstable yes"},
    {"deltaT missing", solver, erase(file, "deltaT"),
        "Entry 'deltaT' not found", "Add the entry 'deltaT'"},
    {"deltaT misspelt", solver, replace(file, "deltaT", "detlaT"),
        "Entry 'deltaT' not found", "detlaT"},
    {"endTime missing", solver, erase(file, "endTime"),
        "Entry 'endTime' not found", "Add the entry 'endTime'"},
    {"no such start folder", solver, set(file, "startTime", "5"),
        "There is no folder of startTime 5", "there are: 0 0.2"},
    {"step count below one", solver,
        set(file, "writeControl", "timeStep"),
        "writeInterval 0.2 < 1", "runTime"},
    {"writeInterval zero", solver, set(file, "writeInterval", "0"),
        "writeInterval", "must be positive"},
    {"purgeWrite negative", solver, set(file, "purgeWrite", "-1"),
        "purgeWrite", "from 0 to"},
    {"writePrecision zero", solver, set(file, "writePrecision", "0"),
        "writePrecision", "from 1 to 17"},
    {"timePrecision too high", solver, set(file, "timePrecision", "99"),
        "timePrecision", "from 1 to 17"},
    {"logInterval zero", solver, add(file, "logInterval 0;"),
        "logInterval", "from 1 to"},
    {"maxCo negative", solver, add(file, "maxCo -1;"),
        "maxCo", "must be positive"},
    {"adjustTimeStep no switch", solver, add(file, "adjustTimeStep maybe;"),
        "maybe", "yes"},
    {"signal that cannot be caught", solver, add(file, "writeNowSignal 9;"),
        "writeNowSignal 9 is not a signal", "SIGUSR1"},
};

const std::vector<breakage> words
{
    {"startFrom", solver, set(file, "startFrom", "lastTime"),
        "lastTime", "latestTime"},
    {"stopAt", solver, set(file, "stopAt", "end"), "end", "noWriteNow"},
    {"writeControl", solver, set(file, "writeControl", "everyNow"),
        "everyNow", "adjustableRunTime"},
    {"writeFormat", solver, set(file, "writeFormat", "text"),
        "text", "binary"},
    {"writeCompression", solver, add(file, "writeCompression zip;"),
        "zip", "compressed"},
    {"timeFormat", solver, set(file, "timeFormat", "plain"),
        "plain", "scientific"},
    {"backend", solver, set(file, "backend", "opencl"), "opencl", "cuda"},
    {"cuda without a GPU", solver, unplaced(set(file, "backend", "cuda")),
        "Backend cuda is not available", "backend cpu"},
    {"precision", solver, set(file, "precision", "half"), "half", "single"},
    {"function object type", solver, replace(file, " error;", " eror;"),
        "Unknown function object type eror", "probes"},
    {"function object field", solver, replace(file, "deltaRho;", "drho;"),
        "Unknown field type drho", "deltaRho"},
    {"exact solution", solver, replace(file, "acousticPulse;", "pulse;"),
        "pulse", "standingWave"},
    {"set of unknown fields", solver, replace(file, "(rho)", "(rho T)"),
        "Unknown field type T", "deltaRho"},
    {"set axis", solver, set(file, "axis", "radius"), "radius", "distance"},
    {"region nobody is in", solver, set(file, "region", "\"r > 100\""),
        "No particle lies inside the region", "not zero"},
    {"region of unknown variable", solver,
        set(file, "region", "\"radius < 6\""), "radius", "Known are x y z r"},
    {"function not a dictionary", solver,
        replace(file, "budgets\n", "budgets;\n    other\n"),
        "budgets is not a sub-dictionary", "Write budgets {"},
    {"function without a type", solver,
        replace(file, "type            budgets;", ""),
        "Entry 'type' not found", "Add the entry 'type'"},
};

const std::vector<breakage> grammar
{
    {"empty", solver, overwrite(file, ""), "Entry", "the dictionary is empty"},
    {"not text", solver, overwrite(file, std::string("\x7f" "ELF\0\1\2", 7)),
        "is not text", "is this a binary file?"},
    {"brace not closed", solver,
        unplaced(replace(file, "functions\n{", "functions\n")),
        "'functions' is not ended by ';'", "Put a ';' behind"},
    {"brace too many", solver, add(file, "}"), "closes nothing",
        "add the { that it belongs to"},
    {"semicolon missing", solver, replace(file, "0.4;", "0.4"),
        "a number was expected", "Is a ';' missing at the end of line 15?"},
    {"string not closed", solver, replace(file, "r < 6\"", "r < 6"),
        "is not closed", "Close it with"},
    {"comment not closed", solver, add(file, "/* no end"),
        "Comment /* is not closed", "Close it with */"},
    {"nothing to include", solver, add(file, "#include \"nothing\""),
        "nothing", "#includeIfPresent allows"},
    {"unknown directive", solver, add(file, "#includ \"nothing\""),
        "#includ", "#include"},
    {"unknown macro", solver, set(file, "deltaT", "$dt"), "dt",
        "Define 'dt' above this line"},
    {"code", solver, set(file, "deltaT", "#codeStream { code #{ #}; }"),
        "codeStream", "#eval{..} does arithmetic"},
    {"division by zero", solver, set(file, "deltaT", "#eval{ 1/0 }"),
        "1/0", "division by zero"},
};

} // namespace


TEST(badInput, valuesOfControlDict)
{
    for (const breakage& b : values)
    {
        expectRefused(b);
    }
}


TEST(badInput, wordsOfControlDict)
{
    for (const breakage& b : words)
    {
        expectRefused(b);
    }
}


TEST(badInput, grammar)
{
    for (const breakage& b : grammar)
    {
        expectRefused(b);
    }
}
