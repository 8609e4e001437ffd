#include "breakage.H"

#include <gtest/gtest.h>

#include <fstream>

namespace fs = std::filesystem;

namespace
{

constexpr app decompose = app::decomposeParticles;
constexpr app reconstruct = app::reconstructParticles;
const char* dict = "system/decomposeParDict";

//- A decomposeParDict of three ranks, then the change
damage with(const damage& change)
{
    return [=](systemCase& c)
    {
        std::ofstream(c.path()/dict)
            << "numberOfSubdomains 3;\nmethod hilbert;\n";
        change(c);
    };
}

//- Three processor directories with times 0 and 0.2, then the change
damage decomposed(const damage& change)
{
    return with([=](systemCase& c)
    {
        const outcome o = c.run(decompose, {"-time", "0:"});
        ASSERT_EQ(o.code, 0) << o.out << o.err;
        change(c);
    });
}

const std::vector<breakage> decomposing
{
    {"no decomposeParDict", decompose, drop(dict), "There is no file",
        "numberOfSubdomains 2;"},
    {"no number of ranks", decompose, with(erase(dict, "numberOfSubdomains")),
        "numberOfSubdomains", "decomposeParDict"},
    {"no ranks", decompose, with(set(dict, "numberOfSubdomains", "0")),
        "numberOfSubdomains", "1"},
    {"half a rank", decompose, with(set(dict, "numberOfSubdomains", "2.5")),
        "numberOfSubdomains", "2.5"},
    {"unknown method", decompose, with(set(dict, "method", "hilbertt")),
        "hilbertt", "simple"},
    {"simple without coefficients", decompose,
        with(unplaced(set(dict, "method", "simple"))), "simpleCoeffs", dict},
    {"slabs that do not fit", decompose,
        with
        (
            [](systemCase& c)
            {
                c.set(dict, "method", "simple");
                c.add(dict, "simpleCoeffs { n (2 2 1); }");
            }
        ),
        "makes 4 ranks, but there are 3",
        "product of n must be numberOfSubdomains"},
    {"manual without its file", decompose,
        with
        (
            [](systemCase& c)
            {
                c.set(dict, "method", "manual");
                c.add(dict, "manualCoeffs { dataFile \"ranks\"; }");
                c.remove("constant/ranks");
            }
        ),
        "There is no file", "-blockDist"},
    {"manual for other blocks", decompose,
        with
        (
            [](systemCase& c)
            {
                c.set(dict, "method", "manual");
                c.add(dict, "manualCoeffs { dataFile \"ranks\"; }");
                c.write
                (
                    "constant/ranks",
                    "FoamFile { format ascii; class labelList; "
                    "object ranks; }\n2(0 1)\n"
                );
            }
        ),
        "There are ranks for 2 blocks", "edit that one"},
    {"limit of balance below 1", decompose,
        with(add(dict, "balance { limit 0.5; }")), "limit", "0.5"},
    {"weight below 0", decompose, with(add(dict, "weights { wall -1; }")),
        "wall", "-1"},
    {"unknown transport", decompose, with(add(dict, "transport pigeon;")),
        "pigeon", "staged"},
    {"decomposed before", decompose, decomposed(nothing()),
        "Case is already decomposed: there are 3", "-force"},
    {"a file is called processor1", decompose,
        with([](systemCase& c) { c.write("processor1", "mine\n"); }),
        "a file where a directory must be", "Move the file",
        {"-force"}},
    {"no such time", decompose, with(nothing()), "-time 7 selects none",
        "times of the case: 0 0.2", {"-time", "7"}},
    {"no domain", decompose, with(drop("constant/domain")),
        "There is no file", "Run seedParticles first"},
    {"time without clouds", decompose,
        with
        (
            [](systemCase& c)
            {
                c.remove("0.2");
                fs::create_directories(c.path()/"0.2");
            }
        ),
        "There is no cloud at time 0.2", "give another time",
        {"-latestTime"}},
    {"damaged field", decompose,
        with(overwrite("0.2/lagrangian/fluid/rho", "nothing")), "rho",
        "FoamFile", {"-latestTime"}},
};

const std::vector<breakage> reconstructing
{
    {"not decomposed", reconstruct, nothing(),
        "There are no processor directories", "Run decomposeParticles"},
    {"gap in the processors", reconstruct, decomposed(drop("processor1")),
        "but no processor1", "Decompose the case again"},
    {"last processor missing", reconstruct,
        decomposed
        (
            [](systemCase& c)
            {
                const char* record = "processor0/constant/decomposition";
                c.remove("processor2");
                c.write(record, c.text(record));
            }
        ),
        "was decomposed for 3", "Decompose the case again"},
    {"particles of another rank", reconstruct,
        decomposed
        (
            [](systemCase& c)
            {
                const fs::path clouds = "0.2/lagrangian";
                fs::remove_all(c.path()/"processor1"/clouds);
                fs::copy
                (
                    c.path()/"processor2"/clouds,
                    c.path()/"processor1"/clouds,
                    fs::copy_options::recursive
                );
                c.remove("0.2");
            }
        ),
        "more than once (the first is", "Files of all ranks",
        {"-latestTime"}},
    {"no ids", reconstruct,
        decomposed(drop("processor1/0.2/lagrangian/fluid/origId")),
        "There is no labelField origId", "decomposeParticles writes it",
        {"-latestTime"}},
    {"a field that one rank lacks", reconstruct,
        decomposed(drop("processor1/0.2/lagrangian/fluid/m")),
        "There is no scalarField m", "take another time", {"-latestTime"}},
    {"a field of other particles", reconstruct,
        decomposed
        (
            [](systemCase& c)
            {
                const std::string m = "/0.2/lagrangian/fluid/m";
                c.write("processor1" + m, c.text("processor2" + m));
            }
        ),
        "but positions holds", "same write", {"-latestTime"}},
    {"no such time", reconstruct, decomposed(nothing()),
        "-time 7 selects none", "times of the case: 0 0.2", {"-time", "7"}},
};

} // namespace


TEST(badInput, decompositions)
{
    for (const breakage& b : decomposing)
    {
        expectRefused(b);
    }
}


TEST(badInput, reconstructions)
{
    for (const breakage& b : reconstructing)
    {
        expectRefused(b);
    }
}
