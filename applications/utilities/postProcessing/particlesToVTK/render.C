#include "render.H"

#include "words.H"

#include "base/log.H"
#include "dictionary/expression.H"
#include "vtk/colourMap.H"
#include "vtk/picture.H"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace gpuFsi
{

namespace fs = std::filesystem;

std::vector<argList::option> pictureArguments()
{
    return
    {
        {"imageTime", "t", "time of the picture, default: the latest"},
        {"clouds", "(a b)", "clouds in the picture, default: all"},
        {"field", "name", "field, or component as U.x; default: U"},
        {"cut", "z=0.5", "plane to cut by, default: middle z"},
        {"view", "3d", "spheres seen from -camera instead of a cut"},
        {"camera", "azimuth elevation", "degrees, default: '-60 25'"},
        {"clip", "expression", "show particles where it holds: 'x>0'"},
        {"range", "lo hi", "of the colours, default: of the particles"},
        {"colours", "map", "coolToWarm, grey or viridis (default)"},
        {"size", "W H", "pixels, default: 1200 and as the scene needs"}
    };
}


static instant chosenTime(const caseClouds& source, const argList& args)
{
    const std::vector<instant>& times = source.times();
    if (!args.found("imageTime"))
    {
        return times.back();
    }
    const std::string text = args.get("imageTime");
    const double wanted = parseNumbers("imageTime", text, 1, "0.5").front();
    std::string valid;
    for (const instant& time : times)
    {
        if (std::abs(time.value - wanted) <= 1e-9*std::abs(wanted))
        {
            return time;
        }
        valid += ' ' + time.name;
    }
    throw userError
    (
        "The case has no time " + text,
        {},
        "Its times are:" + valid
    );
}


static cutPlane chosenCut(const std::string& text)
{
    const std::size_t equals = text.find('=');
    const std::string axis = text.substr(0, equals);
    const bool valid = axis == "x" || axis == "y" || axis == "z";
    if (!valid || equals == std::string::npos)
    {
        throw userError
        (
            "-cut '" + text + "' is not a plane",
            {},
            "Write x=VALUE, y=VALUE or z=VALUE, the value in m"
        );
    }
    const std::string value = text.substr(equals + 1);
    return {axis[0] - 'x', parseNumbers("cut", value, 1, "z=0.5").front()};
}


static void chooseView(pictureOptions& options, const argList& args)
{
    if (args.found("cut"))
    {
        options.cut = chosenCut(args.get("cut"));
    }
    if (args.found("view"))
    {
        if (args.get("view") != "3d")
        {
            throw userError(unknownChoice("view", args.get("view"), {"3d"}));
        }
        options.view3d = true;
    }
    if (options.view3d && args.found("cut"))
    {
        throw userError
        (
            "-cut and -view 3d exclude each other",
            {},
            "Open the 3-D view by -clip, for example -clip 'y>0'"
        );
    }
    if (args.found("camera"))
    {
        if (!options.view3d)
        {
            throw userError("-camera needs -view 3d", {}, "Add -view 3d");
        }
        const auto angles =
            parseNumbers("camera", args.get("camera"), 2, "-60 25");
        if (std::abs(angles[1]) > 90)
        {
            throw userError
            (
                "-camera '" + args.get("camera") + "': the elevation lies"
                " outside -90 to 90 degrees"
            );
        }
        options.azimuth = angles[0];
        options.elevation = angles[1];
    }
}


static void chooseColours(pictureOptions& options, const argList& args)
{
    options.field = args.getOrDefault("field", "");
    options.colours = args.getOrDefault("colours", options.colours);
    colourMap known(options.colours);    // an error before anything is read
    if (args.found("range"))
    {
        const auto limits =
            parseNumbers("range", args.get("range"), 2, "0 1.5");
        if (!(limits[0] < limits[1]))
        {
            throw userError
            (
                "-range '" + args.get("range") + "' is not ascending",
                {},
                "Write the lower limit first"
            );
        }
        options.range = {limits[0], limits[1]};
    }
}


static void chooseSize(pictureOptions& options, const argList& args)
{
    if (!args.found("size"))
    {
        return;
    }
    constexpr int least = 200, most = 8192;
    const auto size = parseNumbers("size", args.get("size"), 2, "1200 900");
    for (const double pixels : size)
    {
        if (pixels != std::floor(pixels) || pixels < least || pixels > most)
        {
            throw userError
            (
                "-size '" + args.get("size") + "' is out of range",
                {},
                fmt::format("Whole numbers from {} to {}", least, most)
            );
        }
    }
    options.width = static_cast<int>(size[0]);
    options.height = static_cast<int>(size[1]);
}


void render(const caseClouds& source, const argList& args)
{
    pictureOptions options;
    chooseView(options, args);
    chooseColours(options, args);
    chooseSize(options, args);
    const fs::path file = args.get("image");
    if (file.extension() != ".png")
    {
        throw userError
        (
            "-image " + file.string() + " is not a PNG file",
            {},
            "Give it a name that ends in .png"
        );
    }
    const domain where = domain::read(args.casePath());
    const instant time = chosenTime(source, args);
    if (args.found("clip"))
    {
        const auto clip = std::make_shared<expression>
        (
            args.get("clip"),
            sourceSpan{"-clip", 0, 0}
        );
        options.keep = [clip, t = time.value](const vector& p)
        {
            return (*clip)(p, t) != 0;
        };
    }

    std::vector<std::string> names = source.names(time);
    if (args.found("clouds"))
    {
        names = parseWords("clouds", args.get("clouds"));
    }
    std::vector<cloud> clouds;
    for (const std::string& name : names)
    {
        for (cloud& piece : source.read(time, name))
        {
            clouds.push_back(std::move(piece));
        }
    }
    const image picture = paint(clouds, where, time.value, options);
    picture.writePng(file);
    info("Time = {}", time.name);
    info
    (
        "    {} x {} pixels -> {}",
        picture.width(),
        picture.height(),
        file.string()
    );
}

} // namespace gpuFsi
