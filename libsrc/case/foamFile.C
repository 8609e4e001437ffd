#include "case/foamFile.H"

#include "base/error.H"
#include "case/foamScanner.H"

#include <map>

namespace gpuFsi
{

namespace
{

std::string headerValue(foamScanner& scan)
{
    if (scan.accept('"'))
    {
        std::string value;
        while (!scan.acceptHere('"'))
        {
            value += scan.raw(1, "a closing quote")[0];
        }
        return value;
    }
    return scan.word();
}

void checkArch(const foamScanner& scan, const std::string& arch)
{
    const auto reject = [&](const std::string& what)
    {
        scan.fail
        (
            "Binary file written with " + what + " (arch \"" + arch
          + "\"); this program reads LSB;label=32;scalar=64",
            "Write it with a double precision, 32-bit label build, or in "
            "ascii."
        );
    };
    if (arch.find("MSB") != std::string::npos)
    {
        reject("the other byte order");
    }
    for (const char* width : {"label=64", "scalar=32"})
    {
        if (arch.find(width) != std::string::npos)
        {
            reject(width);
        }
    }
}

} // namespace

std::string foamFile::text() const
{
    return "FoamFile\n{\n"
        "    version     2.0;\n"
        "    format      " + format + ";\n"
        "    arch        \"" + arch + "\";\n"
        "    class       " + cls + ";\n"
        "    location    \"" + location + "\";\n"
        "    object      " + object + ";\n"
        "}\n\n";
}

foamFile foamFile::parse
(
    std::string_view bytes,
    const std::filesystem::path& file,
    std::size_t& bodyOffset
)
{
    foamScanner scan(bytes, file);
    if (!scan.acceptWord("FoamFile"))
    {
        scan.fail
        (
            "There is no FoamFile header",
            "Is this a file of a case? Its first entry must be FoamFile."
        );
    }
    scan.expect('{', "to open the FoamFile header");
    std::map<std::string, std::string> entries;
    while (!scan.accept('}'))
    {
        const std::string key = scan.word();
        if (scan.accept('{'))    // as meta{}
        {
            while (!scan.accept('}'))
            {
                scan.raw(1, "the } of a header entry");
            }
            continue;
        }
        entries[key] = headerValue(scan);
        scan.expect(';', ("after the header entry " + key).c_str());
    }
    for (const char* key : {"format", "class", "object"})
    {
        if (!entries.count(key))
        {
            scan.fail
            (
                "Entry '" + std::string(key) + "' not found in the FoamFile "
                "header",
                "Add it: format, class and object are required."
            );
        }
    }

    foamFile header;
    header.format = entries["format"];
    header.cls = entries["class"];
    header.location = entries["location"];
    header.object = entries["object"];
    header.arch = entries["arch"];
    if (header.format != "ascii" && header.format != "binary")
    {
        scan.fail
        (
            unknownChoice("format", header.format, {"ascii", "binary"}),
            ""
        );
    }
    if (header.binary())
    {
        checkArch(scan, header.arch);
    }
    bodyOffset = scan.offset();
    return header;
}

} // namespace gpuFsi
