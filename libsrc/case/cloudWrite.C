#include "case/caseFileIO.H"
#include "case/cloud.H"
#include "case/fieldClass.H"
#include "case/fieldIO.H"
#include "case/foamFile.H"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace gpuFsi
{

namespace
{

constexpr int maxNumberLength = 40;

//- `value` as an ostream of this precision prints it
char* print(char* to, double value, int precision)
{
    return std::to_chars
    (
        to,
        to + maxNumberLength,
        value,
        std::chars_format::general,
        precision
    ).ptr;
}

char* printValue(char* to, const double* value, int n, int precision)
{
    if (n == 1)
    {
        return print(to, *value, precision);
    }
    *to++ = '(';
    for (int c = 0; c < n; ++c)
    {
        to = print(to, value[c], precision);
        *to++ = c + 1 < n ? ' ' : ')';
    }
    return to;
}

template<class Print>
void appendPrinted(caseFileWriter& out, int nNumbers, const Print& printer)
{
    char* begin = out.space(nNumbers*(maxNumberLength + 1) + 8);
    out.advance(printer(begin) - begin);
}

foamFile headerFor
(
    const std::string& location,
    const std::string& cls,
    const std::string& object,
    const writeOptions& options
)
{
    foamFile header;
    header.format = options.binary ? "binary" : "ascii";
    header.cls = cls;
    header.location = location;
    header.object = object;
    return header;
}

void appendPositions
(
    caseFileWriter& out,
    const std::vector<vector>& positions,
    const writeOptions& options
)
{
    out.append(std::to_string(positions.size()) + "\n(\n");
    const std::int32_t celli = 0;
    for (const vector& p : positions)
    {
        const double xyz[3] = {p.x, p.y, p.z};
        if (options.binary)
        {
            char* to = out.space(31);
            to[0] = '(';
            std::memcpy(to + 1, xyz, 24);
            std::memcpy(to + 25, &celli, 4);
            to[29] = ')';
            to[30] = '\n';
            out.advance(31);
        }
        else
        {
            appendPrinted(out, 4, [&](char* to)
            {
                to = printValue(to, xyz, 3, options.precision);
                std::memcpy(to, " 0\n", 3);
                return to + 3;
            });
        }
    }
    out.append(")\n");
}

void checkLabels(const cloudField& field)
{
    for (std::size_t i = 0; i < field.values.size(); ++i)
    {
        const double v = field.values[i];
        if (!(std::abs(v) <= 2147483647.) || v != std::floor(v))
        {
            throw userError
            (
                "Field " + field.name + ": value " + std::to_string(v)
              + " of particle " + std::to_string(i)
              + " is not a 32-bit label",
                {},
                "Labels are whole numbers of at most 2147483647."
            );
        }
    }
}

void appendBinary(caseFileWriter& out, const cloudField& field, bool labels)
{
    const std::vector<double>& values = field.values;
    out.append(std::to_string(field.size()) + "\n");
    if (values.empty())
    {
        return;    // as OpenFOAM: no parentheses
    }
    out.append("(");
    if (labels)
    {
        for (double v : values)
        {
            const std::int32_t label = std::int32_t(v);
            std::memcpy(out.space(4), &label, 4);
            out.advance(4);
        }
    }
    else
    {
        out.append
        (
            reinterpret_cast<const char*>(values.data()),
            values.size()*sizeof(double)
        );
    }
    out.append(")\n");
}

//- Without this OpenFOAM looks for barycentric coordinates and, finding none,
//  takes the cloud to be empty
std::size_t writeCloudProperties
(
    const std::filesystem::path& timeDirectory,
    const std::string& cloudName
)
{
    const std::filesystem::path place =
        std::filesystem::path("uniform/lagrangian")/cloudName;
    foamFile header;
    header.cls = "dictionary";
    header.location = (timeDirectory.filename()/place).string();
    header.object = "cloudProperties";
    return writeTextFile
    (
        timeDirectory/place/"cloudProperties",
        header.text() + "geometry        positions;\n"
    );
}

//- Decided by what is printed: so a file that is read and written again stays
//  the same, though values that differ in later digits have become equal
bool allPrintAlike(const std::vector<double>& values, int n, int digits)
{
    char first[maxNumberLength], other[maxNumberLength];
    for (std::size_t i = n; i < values.size(); ++i)
    {
        if (std::memcmp(&values[i], &values[i % n], sizeof(double)) == 0)
        {
            continue;
        }
        const std::size_t length = print(first, values[i % n], digits) - first;
        if
        (
            std::size_t(print(other, values[i], digits) - other) != length
         || std::memcmp(first, other, length) != 0
        )
        {
            return false;
        }
    }
    return true;
}

void appendAscii
(
    caseFileWriter& out,
    const cloudField& field,
    bool labels,
    int precision
)
{
    const int n = field.nComponents();
    const std::size_t size = field.size();
    const int digits = labels ? 10 : precision;
    const auto appendOne = [&](std::size_t i, const char* after)
    {
        appendPrinted(out, n, [&](char* to)
        {
            to = printValue(to, &field.values[i*n], n, digits);
            const std::size_t length = std::strlen(after);
            std::memcpy(to, after, length);
            return to + length;
        });
    };
    out.append(std::to_string(size));
    if (size > 1 && allPrintAlike(field.values, n, digits))
    {
        out.append("{");
        appendOne(0, "}\n");
    }
    else if (size < 11)
    {
        out.append("(");
        for (std::size_t i = 0; i < size; ++i)
        {
            appendOne(i, i + 1 < size ? " " : "");
        }
        out.append(")\n");
    }
    else
    {
        out.append("\n(\n");
        for (std::size_t i = 0; i < size; ++i)
        {
            appendOne(i, "\n");
        }
        out.append(")\n");
    }
}

} // namespace

std::size_t writeField
(
    const std::filesystem::path& directory,
    const std::string& location,
    const cloudField& field,
    const writeOptions& options
)
{
    const bool labels = findFieldClass(field.cls)->isLabel;
    if (labels)
    {
        checkLabels(field);
    }
    caseFileWriter out
    (
        directory/field.name, options.compress && !options.binary
    );
    out.append(headerFor(location, field.cls, field.name, options).text());
    if (options.binary)
    {
        appendBinary(out, field, labels);
    }
    else
    {
        appendAscii(out, field, labels, options.precision);
    }
    return out.finish();
}

std::size_t writeCloud
(
    const std::filesystem::path& timeDirectory,
    const cloud& particles,
    const writeOptions& options
)
{
    const std::filesystem::path directory =
        timeDirectory/"lagrangian"/particles.name;
    const std::string location =
        timeDirectory.filename().string() + "/lagrangian/" + particles.name;
    std::size_t written =
        writeCloudProperties(timeDirectory, particles.name);

    caseFileWriter out
    (
        directory/"positions", options.compress && !options.binary
    );
    out.append
    (
        headerFor
        (
            location, "Cloud<passiveParticle>", "positions", options
        ).text()
    );
    appendPositions(out, particles.positions, options);
    written += out.finish();
    for (const cloudField& field : particles.fields)
    {
        developerAssert
        (
            field.values.size() == particles.size()*field.nComponents(),
            "cloud field with another size than the positions"
        );
        written += writeField(directory, location, field, options);
    }
    return written;
}

} // namespace gpuFsi
