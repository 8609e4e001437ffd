#include "fixture.H"

#include <cstdio>
#include <cstdlib>

using namespace gpuFsi;


//- Output of a command without its last newline
static std::string outputOf(const std::string& command)
{
    std::string text;
    if (FILE* pipe = popen(command.c_str(), "r"))
    {
        char buffer[256];
        while (std::fgets(buffer, sizeof buffer, pipe))
        {
            text += buffer;
        }
        pclose(pipe);
    }
    while (!text.empty() && text.back() == '\n')
    {
        text.pop_back();
    }
    return text;
}


//- What both read in the same way; expected values by foamDictionary itself
TEST(foamDictionary, readsThePortableSubsetTheSame)
{
    // Where Debian puts OpenFOAM, unless an environment is set already
    setenv("WM_PROJECT_DIR", "/usr/share/openfoam", 0);
    if (std::system("foamDictionary -help > /dev/null 2>&1") != 0)
    {
        GTEST_SKIP() << "foamDictionary is not installed";
    }
    const scratchDirectory at;
    at.write("more", "included 8;\n");
    const std::string file = at.write
    (
        "portable",
        "FoamFile { version 2.0; format ascii; class dictionary;"
        " object portable; }\n"
        "x 1; w linear; /* c */ s { k 3; \"p.*\" 4; \"pr.*\" 5; pp 6; }\n"
        "s { k 7; m $x; n $k; } t { $s; k 9; inner { a $x; b $k; } }\n"
        "v (0 0 $x); copy { $s; } #include \"more\"\n"
        "#inputMode protect\nx 2;\n#inputMode merge\ny 1; z 1;\n#remove z\n"
        "u 1; u 2;\nup { q 1; r { o $..q; g $:x; } } e $s.k;\n"
    );
    const dictionary d = dictionary::fromFile(file);
    const char* const paths[] =
    {
        "x", "w", "s.k", "s.m", "s.n", "s.pp", "s.press", "s.psi", "t.k",
        "t.m", "t.inner.a", "t.inner.b", "v", "copy.k", "included", "u",
        "up.r.o", "up.r.g", "e", "y"
    };
    for (const std::string path : paths)
    {
        const dictionary* in = &d;
        std::string key = path;
        for (std::size_t dot; (dot = key.find('.')) != std::string::npos;)
        {
            in = &in->subDict(key.substr(0, dot));
            key.erase(0, dot + 1);
        }
        std::string ours;
        for (const token& t : in->tokens(key))
        {
            ours += (ours.empty() ? "" : " ") + t.text;
        }
        EXPECT_EQ
        (
            ours,
            outputOf
            (
                "foamDictionary '" + file + "' -entry " + path
                    + " -value 2>&1"
            )
        ) << path;
    }
    EXPECT_FALSE(d.found("z"));

    // and what we write, it reads
    const std::string written = at.write("written", d.toText());
    EXPECT_EQ
    (
        outputOf("foamDictionary '" + written + "' -entry t.inner.b -value"),
        "9"
    );
}
