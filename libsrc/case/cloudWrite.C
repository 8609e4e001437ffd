#include "case/caseFileIO.H"
#include "case/cloud.H"
#include "case/fieldClass.H"
#include "case/fieldIO.H"
#include "case/foamFile.H"
#include "case/parallelFiles.H"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <numeric>

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

void checkLabels(const fieldView& field)
{
    for (std::size_t i = 0; i < field.nValues; ++i)
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

void appendBinary
(
    caseFileWriter& out,
    const fieldView& field,
    const fieldClass& cls
)
{
    out.append(std::to_string(field.nValues/cls.nComponents) + "\n");
    if (field.nValues == 0)
    {
        return;    // as OpenFOAM: no parentheses
    }
    out.append("(");
    if (cls.isLabel)
    {
        for (std::size_t i = 0; i < field.nValues; ++i)
        {
            const std::int32_t label = std::int32_t(field.values[i]);
            std::memcpy(out.space(4), &label, 4);
            out.advance(4);
        }
    }
    else
    {
        out.append
        (
            reinterpret_cast<const char*>(field.values),
            field.nValues*sizeof(double)
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
bool allPrintAlike(const fieldView& field, int n, int digits)
{
    const double* const values = field.values;
    char first[maxNumberLength], other[maxNumberLength];
    for (std::size_t i = n; i < field.nValues; ++i)
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
    const fieldView& field,
    const fieldClass& cls,
    int precision
)
{
    const int n = cls.nComponents;
    const std::size_t size = field.nValues/n;
    const int digits = cls.isLabel ? 10 : precision;
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
    if (size > 1 && allPrintAlike(field, n, digits))
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
    const fieldView& field,
    const writeOptions& options
)
{
    const fieldClass* cls = findFieldClass(field.cls);
    developerAssert(cls, "field of an unknown class");
    if (cls->isLabel)
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
        appendBinary(out, field, *cls);
    }
    else
    {
        appendAscii(out, field, *cls, options.precision);
    }
    return out.finish();
}

static std::size_t writePositions
(
    const std::filesystem::path& directory,
    const std::string& location,
    const std::vector<vector>& positions,
    const writeOptions& options
)
{
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
    appendPositions(out, positions, options);
    return out.finish();
}

std::size_t writeCloud
(
    const std::filesystem::path& timeDirectory,
    const cloudView& particles,
    const writeOptions& options
)
{
    const std::filesystem::path directory =
        timeDirectory/"lagrangian"/particles.name();
    const std::string location =
        timeDirectory.filename().string() + "/lagrangian/" + particles.name();
    const std::size_t n = particles.positions().size();
    const std::vector<fieldView>& fields = particles.fields();
    for (const fieldView& field : fields)
    {
        const fieldClass* cls = findFieldClass(field.cls);
        developerAssert
        (
            cls && field.nValues == n*cls->nComponents,
            "cloud field with another size than the positions"
        );
    }
    std::vector<std::size_t> written(fields.size() + 1);
    forEachFile(int(written.size()), [&](int k)
    {
        written[k] = k == 0
          ? writePositions
            (
                directory, location, particles.positions(), options
            )
          : writeField(directory, location, fields[k - 1], options);
    });
    return std::accumulate
    (
        written.begin(), written.end(),
        writeCloudProperties(timeDirectory, particles.name())
    );
}

std::size_t writeCloud
(
    const std::filesystem::path& timeDirectory,
    const cloud& particles,
    const writeOptions& options
)
{
    return writeCloud(timeDirectory, cloudView(particles), options);
}

} // namespace gpuFsi
