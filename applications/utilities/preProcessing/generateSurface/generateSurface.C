//- Writes the surface mesh of a simple shape, as a case's first STL.
#include "base/error.H"
#include "base/log.H"
#include "case/argList.H"
#include "shapeSurface.H"

#include <algorithm>
#include <cmath>
#include <cstdlib>

using namespace gpuFsi;

static double number
(
    const argList& args,
    const std::string& option,
    double otherwise,
    double least,
    double most = 1e30
)
{
    const std::string text = args.getOrDefault(option, "");
    if (text.empty())
    {
        return otherwise;
    }
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    if (*end || !std::isfinite(value) || value < least || value > most)
    {
        throw userError
        (
            "Option -" + option + " has the value " + text,
            {},
            fmt::format("Give a number from {} to {}.", least, most)
        );
    }
    return value;
}


static int generateSurface(int argc, char** argv)
{
    const argList args
    (
        argc,
        argv,
        "Write a closed triangle surface, centred at the origin, the axis of"
        " a cylinder or torus along y; a tube that branches at the origin.",
        {
            {
                "shape", "word",
                "cylinder (default), sphere, box, torus or branch"
            },
            {"radius", "m", "default 1; of a torus: of its centre line"},
            {"tube", "m", "radius of a torus' section, default radius/3"},
            {"length", "m", "of a cylinder or box edge, default 2; branch: "
                "from the origin to each end"},
            {"offset", "m", "of a branch: outwards, default 0"},
            {"wall", "m", "of a branch: thickness of a wall around it,"
                " default 0: none, but the space within"},
            {"n", "count", "triangles around (box: along an edge), default 64"},
            {"ascii", "", "an ascii STL file, not a binary one"},
            {"out", "file", "ending .stl, .obj, .ply or .off"}
        },
        false
    );
    const double tiny = 1e-30;
    const double radius = number(args, "radius", 1, tiny);
    const double tube = number(args, "tube", radius/3, tiny);
    const double length = number(args, "length", 2, tiny);
    const int n = int(number(args, "n", 64, 1, 10000));
    const std::string shape = args.getOrDefault("shape", "cylinder");
    const int around = std::max(n, 3);

    shapeSurface surface;
    if (shape == "cylinder")
    {
        surface = makeCylinder(radius, length, around);
    }
    else if (shape == "sphere")
    {
        surface = makeSphere(radius, around);
    }
    else if (shape == "box")
    {
        surface = makeBox(length, n);
    }
    else if (shape == "branch")
    {
        surface = makeBranch
        (
            radius,
            length,
            number(args, "offset", 0, 0),
            number(args, "wall", 0, 0),
            std::max(n, 8)
        );
    }
    else if (shape == "torus" && tube < radius)
    {
        surface = makeTorus(radius, tube, around);
    }
    else if (shape == "torus")
    {
        throw userError
        (
            fmt::format("tube {} is not below radius {}", tube, radius),
            {},
            "The ring would cut itself."
        );
    }
    else
    {
        throw userError
        (
            unknownChoice
            (
                "shape", shape,
                {"cylinder", "sphere", "box", "torus", "branch"}
            )
        );
    }
    if (!args.found("out"))
    {
        throw userError
        (
            "Option -out is missing", {}, "Name a file, as -out surface.stl"
        );
    }
    writeShape(args.get("out"), surface, !args.found("ascii"));
    info
    (
        "Wrote {}: {}, {} triangles",
        args.get("out"), shape, surface.triangles.size()
    );
    return 0;
}


int main(int argc, char** argv)
{
    return runMain
    (
        "generateSurface", [&] { return generateSurface(argc, argv); }
    );
}
