#include "study/gnuplot.H"

#include "base/log.H"
#include "study/commandRun.H"

namespace gpuFsi
{

namespace fs = std::filesystem;

std::string gnuplotText(const std::string& text)
{
    std::string result = "'";
    for (const char c : text)
    {
        result += c == '\'' ? "''" : std::string(1, c);
    }
    return result + "' noenhanced";
}


void paint(const fs::path& directory, const std::string& stem)
{
    const fs::path log = directory/"log.gnuplot";
    const commandOutcome painted = runCommands
    (
        directory, {"gnuplot " + stem + ".gp"}, {}, log, 60
    );
    if (painted.good())
    {
        info("Painted {0}.svg and {0}.png", (directory/stem).string());
    }
    else if (painted.code == 127)
    {
        info
        (
            "gnuplot is not there: run it on {}.gp where it is",
            (directory/stem).string()
        );
    }
    else
    {
        warning("gnuplot failed: " + log.string());
    }
}

} // namespace gpuFsi
