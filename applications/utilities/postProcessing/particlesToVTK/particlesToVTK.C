// particlesToVTK: writes the clouds of a case as VTK files for ParaView, or
// paints one time as a picture.

#include "convert.H"
#include "render.H"

#include "base/error.H"
#include "base/log.H"

using namespace gpuFsi;

static std::vector<argList::option> arguments()
{
    std::vector<argList::option> options
    {
        {"time", "ranges", "times to write, as ':10,20,40:70'"},
        {"latestTime", "", "write the latest time"},
        {"noZero", "", "leave time 0 out"},
        {"cloud", "name", "write this cloud, default: all"},
        {"fields", "(a b)", "write these fields, default: all"},
        {"float", "", "32-bit numbers: half the size"},
        {"ascii", "", "readable files"},
        {"compress", "", "smaller files, slower to write"},
        {"decomposed", "", "from the processor directories; default: where"
            " these have the latest time"},
        {"image", "file.png", "paint a picture instead; options below"}
    };
    for (const argList::option& option : pictureArguments())
    {
        options.push_back(option);
    }
    return options;
}


//- An option that the chosen kind of output would ignore is an error
static void checkCompanions(const argList& args)
{
    const bool paints = args.found("image");
    std::vector<argList::option> ignored = pictureArguments();
    if (paints)
    {
        ignored = arguments();
        // -decomposed and what follows it
        ignored.resize(ignored.size() - pictureArguments().size() - 2);
    }
    for (const argList::option& option : ignored)
    {
        if (args.found(option.name))
        {
            throw userError
            (
                "-" + option.name + (paints ? " has no meaning with -image"
                  : " has a meaning only with -image"),
                {},
                paints ? "Leave it out, or -image" : "Add -image FILE.png"
            );
        }
    }
}


int main(int argc, char** argv)
{
    return runMain
    (
        "particlesToVTK",
        [&]()
        {
            const argList args
            (
                argc,
                argv,
                "Writes particles as VTK files for ParaView, or a picture",
                arguments()
            );
            checkCompanions(args);
            printBanner(args.commandLine(), args.casePath().string());
            const caseClouds source
            (
                args.casePath(), args.found("decomposed")
            );
            if (args.found("image"))
            {
                render(source, args);
            }
            else
            {
                convert(source, args);
            }
            info("\nEnd");
            return 0;
        }
    );
}
