#include "case/caseFileIO.H"
#include "case/cloud.H"
#include "case/foamFile.H"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace gpuFsi
{

namespace
{

void writeMeshFile
(
    const std::filesystem::path& casePath,
    const std::string& cls,
    const std::string& object,
    const std::string& body
)
{
    foamFile header;
    header.cls = cls;
    header.location = "constant/polyMesh";
    header.object = object;
    writeTextFile
    (
        casePath/"constant/polyMesh"/object,
        header.text() + body + "\n"
    );
}

} // namespace

void writeBoxMesh
(
    const std::filesystem::path& casePath,
    const vector& lo,
    const vector& hi
)
{
    double low[3] = {lo.x, lo.y, lo.z};
    double high[3] = {hi.x, hi.y, hi.z};
    double longest = 0;
    for (int d = 0; d < 3; ++d)
    {
        longest = std::max(longest, high[d] - low[d]);
    }
    const bool ordered =
        lo.x <= hi.x && lo.y <= hi.y && lo.z <= hi.z;
    if (!ordered || !(longest > 0) || std::isinf(longest))
    {
        throw userError
        (
            fmt::format
            (
                "Cannot make a mesh of the box from ({} {} {}) to ({} {} {})",
                lo.x, lo.y, lo.z, hi.x, hi.y, hi.z
            ),
            {},
            "hi must be above lo."
        );
    }
    for (int d = 0; d < 3; ++d)
    {
        if (high[d] == low[d])    // a 2-D case: a cell needs a volume
        {
            low[d] -= 0.05*longest;
            high[d] += 0.05*longest;
        }
    }

    std::string points = "8\n(\n";
    for (int corner = 0; corner < 8; ++corner)
    {
        points += fmt::format
        (
            "({:.17g} {:.17g} {:.17g})\n",
            (corner & 1 ? high : low)[0],
            (corner & 2 ? high : low)[1],
            (corner & 4 ? high : low)[2]
        );
    }
    writeMeshFile(casePath, "vectorField", "points", points + ")");

    // Corners by bits x y z; normals point outwards: -x +x -y +y -z +z
    writeMeshFile
    (
        casePath,
        "faceList",
        "faces",
        "6\n(\n4(0 4 6 2)\n4(1 3 7 5)\n4(0 1 5 4)\n4(2 6 7 3)\n4(0 2 3 1)\n"
        "4(4 5 7 6)\n)"
    );
    writeMeshFile(casePath, "labelList", "owner", "6{0}");
    writeMeshFile(casePath, "labelList", "neighbour", "0()");
    writeMeshFile
    (
        casePath,
        "polyBoundaryMesh",
        "boundary",
        "1\n(\n    box\n    {\n        type            patch;\n"
        "        nFaces          6;\n        startFace       0;\n    }\n)"
    );
}

void writeReaderFiles(const std::filesystem::path& casePath)
{
    const auto writeNew =
        [&](const std::filesystem::path& file, const std::string& text)
    {
        if (!std::filesystem::exists(casePath/file))
        {
            writeTextFile(casePath/file, text);
        }
    };
    foamFile header;
    header.cls = "dictionary";
    header.location = "system";
    header.object = "fvSchemes";
    writeNew
    (
        "system/fvSchemes",
        header.text() + "// For OpenFOAM's own programs; not read here\n\n"
        "gradSchemes\n{}\n\ndivSchemes\n{}\n\nlaplacianSchemes\n{}\n"
    );
    header.object = "fvSolution";
    writeNew
    (
        "system/fvSolution",
        header.text() + "// For OpenFOAM's own programs; not read here\n"
    );
    const std::string name =
        std::filesystem::absolute(casePath).lexically_normal().filename()
       .string();
    writeNew((name.empty() ? "case" : name) + ".foam", "");
}

} // namespace gpuFsi
