#include "base/error.H"
#include "case/caseFileIO.H"
#include "shapeSurface.H"

#include <fmt/format.h>

#include <cstdint>

namespace gpuFsi
{

namespace
{

template<class T>
void appendRaw(std::string& to, T value)
{
    to.append(reinterpret_cast<const char*>(&value), sizeof value);
}

std::string binaryStl(const shapeSurface& s)
{
    std::string text(80, ' ');
    appendRaw(text, std::uint32_t(s.triangles.size()));
    for (const auto& t : s.triangles)
    {
        // Readers compute the normal themselves where it is zero
        text.append(12, '\0');
        for (const int c : t)
        {
            appendRaw(text, float(s.points[c].x));
            appendRaw(text, float(s.points[c].y));
            appendRaw(text, float(s.points[c].z));
        }
        text.append(2, '\0');
    }
    return text;
}

std::string asciiStl(const shapeSurface& s)
{
    std::string text = "solid surface\n";
    for (const auto& t : s.triangles)
    {
        text += "facet normal 0 0 0\nouter loop\n";
        for (const int c : t)
        {
            const vector& p = s.points[c];
            text += fmt::format("vertex {} {} {}\n", p.x, p.y, p.z);
        }
        text += "endloop\nendfacet\n";
    }
    return text + "endsolid surface\n";
}

//- What OBJ, PLY and OFF have in common: points, then numbered faces
std::string indexed
(
    const shapeSurface& s,
    const std::string& header,
    const char* pointMark,
    const char* faceMark,
    int firstNumber
)
{
    std::string text = header;
    for (const vector& p : s.points)
    {
        text += fmt::format("{}{} {} {}\n", pointMark, p.x, p.y, p.z);
    }
    for (const auto& t : s.triangles)
    {
        text += fmt::format
        (
            "{}{} {} {}\n", faceMark,
            t[0] + firstNumber, t[1] + firstNumber, t[2] + firstNumber
        );
    }
    return text;
}

} // namespace

void writeShape
(
    const std::filesystem::path& file,
    const shapeSurface& s,
    bool binary
)
{
    const std::string type = file.extension().string();
    const std::size_t nPoints = s.points.size();
    const std::size_t nTriangles = s.triangles.size();
    std::string text;
    if (type == ".stl")
    {
        text = binary ? binaryStl(s) : asciiStl(s);
    }
    else if (type == ".obj")
    {
        text = indexed(s, "", "v ", "f ", 1);
    }
    else if (type == ".ply")
    {
        text = indexed
        (
            s,
            fmt::format
            (
                "ply\nformat ascii 1.0\nelement vertex {}\nproperty double x\n"
                "property double y\nproperty double z\nelement face {}\n"
                "property list uchar int vertex_indices\nend_header\n",
                nPoints, nTriangles
            ),
            "", "3 ", 0
        );
    }
    else if (type == ".off")
    {
        text = indexed
        (
            s, fmt::format("OFF\n{} {} 0\n", nPoints, nTriangles), "", "3 ", 0
        );
    }
    else
    {
        throw userError
        (
            "Surface file " + file.string() + " has the unknown ending '"
          + type + "'",
            {},
            "Valid endings are .stl, .obj, .ply and .off."
        );
    }
    writeTextFile(file, text);
}

} // namespace gpuFsi
