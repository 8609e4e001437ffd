#include "case/caseFileIO.H"
#include "case/cloud.H"
#include "case/fieldClass.H"
#include "case/fieldIO.H"
#include "case/foamFile.H"
#include "case/foamScanner.H"
#include "case/largeFields.H"
#include "case/parallelFiles.H"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

namespace gpuFsi
{

namespace
{

//- Names a value only when it is wanted: for a message
struct valueName
{
    const std::string& field;
    const int nComponents;

    std::string operator()(std::size_t i) const
    {
        return field + " of particle " + std::to_string(i/nComponents);
    }
};

void expectAt
(
    foamScanner& scan,
    char c,
    const char* where,
    const valueName& name,
    std::size_t i
)
{
    if (!scan.accept(c))
    {
        scan.expect(c, (where + (" " + name(i))).c_str());
    }
}

double readNumber(foamScanner& scan, const valueName& name, std::size_t i)
{
    double value;
    if (!scan.number(value))
    {
        value = scan.number(name(i));
    }
    return value;
}

void readComponents
(
    foamScanner& scan,
    const valueName& name,
    std::size_t first,
    double* to
)
{
    const int n = name.nComponents;
    if (n > 1)
    {
        expectAt(scan, '(', "before", name, first);
    }
    for (int c = 0; c < n; ++c)
    {
        to[c] = readNumber(scan, name, first + c);
        if (!std::isfinite(to[c]))
        {
            scan.fail
            (
                "Not a finite number: " + name(first) + " is "
              + std::to_string(to[c]),
                "The run that wrote it had failed; start from an earlier "
                "time."
            );
        }
    }
    if (n > 1)
    {
        expectAt(scan, ')', "after", name, first);
    }
}

void checkSize
(
    const foamScanner& scan,
    const std::string& field,
    std::size_t found,
    std::size_t nParticles
)
{
    if (found != nParticles)
    {
        scan.fail
        (
            "Field " + field + " has " + std::to_string(found)
          + " values, but positions holds " + std::to_string(nParticles)
          + " particles",
            "All files of a cloud must come from the same write."
        );
    }
}

void checkFinite
(
    const foamScanner& scan,
    const std::vector<double>& values,
    const valueName& name
)
{
    for (std::size_t i = 0; i < values.size(); ++i)
    {
        if (!std::isfinite(values[i]))
        {
            scan.fail
            (
                "Not a finite number: " + name(i) + " is "
              + std::to_string(values[i]),
                "The run that wrote it had failed; start from an earlier "
                "time."
            );
        }
    }
}

void readBinaryList
(
    foamScanner& scan,
    const fieldClass& cls,
    const valueName& name,
    std::vector<double>& values
)
{
    if (values.empty() && !scan.accept('('))
    {
        return;
    }
    if (!values.empty())
    {
        scan.expect('(', "before the values");
    }
    scan.setBinaryBody();
    if (cls.isLabel)
    {
        const char* from = scan.raw(4*values.size(), name.field.c_str());
        for (std::size_t i = 0; i < values.size(); ++i)
        {
            std::int32_t label;
            std::memcpy(&label, from + 4*i, 4);
            values[i] = label;
        }
    }
    else if (!values.empty())
    {
        const std::size_t nBytes = values.size()*sizeof(double);
        const char* from = scan.raw(nBytes, name.field.c_str());
        std::memcpy(values.data(), from, nBytes);
        checkFinite(scan, values, name);
    }
    scan.expect
    (
        ')',
        "after the values: the size or the width of the numbers is wrong"
    );
}

std::vector<double> readValues
(
    foamScanner& scan,
    const foamFile& header,
    const fieldClass& cls,
    const std::string& field,
    std::size_t nParticles
)
{
    const int n = cls.nComponents;
    const valueName name{field, n};
    std::vector<double> values;
    const auto readRepeated = [&]()
    {
        std::vector<double> one(n);
        readComponents(scan, name, 0, one.data());
        values.resize(nParticles*n);
        for (std::size_t i = 0; i < values.size(); ++i)
        {
            values[i] = one[i % n];
        }
    };

    if (scan.acceptWord("uniform"))
    {
        readRepeated();
        scan.accept(';');
        return values;
    }
    const bool entry = scan.acceptWord("nonuniform");
    if (entry)
    {
        scan.word();    // List<...>
    }
    if (scan.nextIsNumber())
    {
        checkSize(scan, field, scan.count(), nParticles);
        if (scan.accept('{'))
        {
            readRepeated();
            scan.expect('}', "after the repeated value");
        }
        else if (header.binary())
        {
            values.resize(nParticles*n);
            readBinaryList(scan, cls, name, values);
        }
        else
        {
            values.resize(nParticles*n);
            scan.expect('(', "before the values");
            for (std::size_t i = 0; i < nParticles; ++i)
            {
                readComponents(scan, name, i*n, &values[i*n]);
            }
            scan.expect(')', "after the values: there are more than said");
        }
    }
    else
    {
        scan.expect('(', "or the size of the list");
        std::vector<double> one(n);
        while (!scan.accept(')'))
        {
            readComponents(scan, name, values.size(), one.data());
            values.insert(values.end(), one.begin(), one.end());
        }
        checkSize(scan, field, values.size()/n, nParticles);
    }
    if (entry)
    {
        scan.accept(';');
    }
    return values;
}

void checkLabelValues
(
    const foamScanner& scan,
    const std::vector<double>& values,
    const std::string& field
)
{
    for (std::size_t i = 0; i < values.size(); ++i)
    {
        if
        (
            values[i] != std::floor(values[i])
         || std::abs(values[i]) > 2147483648.
        )
        {
            scan.fail
            (
                field + " of particle " + std::to_string(i)
              + " is not a 32-bit label",
                "A labelField holds whole numbers."
            );
        }
    }
}

void checkEnd(foamScanner& scan)
{
    if (!scan.atEnd())
    {
        scan.fail
        (
            "There is more after the list ("
          + std::to_string(scan.remaining()) + " bytes)",
            "A cloud file holds one list and nothing else."
        );
    }
}

std::vector<vector> readPositions(const std::filesystem::path& file)
{
    const std::string bytes = readCaseFile(file);
    std::size_t begin = 0;
    const foamFile header = foamFile::parse(bytes, file, begin);
    foamScanner scan(bytes, file, begin);
    if (header.cls.find("Cloud") == std::string::npos)
    {
        scan.fail
        (
            "Class " + header.cls + " is not a cloud",
            "The class of positions must be Cloud<passiveParticle>."
        );
    }
    const std::size_t size = scan.count();
    // A record takes 30 bytes in binary, at least 9 in ascii
    if (size > scan.remaining()/(header.binary() ? 30 : 9))
    {
        scan.fail
        (
            "The file is too short for " + std::to_string(size)
          + " positions",
            "It is truncated; start from an earlier time."
        );
    }
    std::vector<vector> positions(size);
    const std::string field = "position";
    const valueName name{field, 3};
    scan.expect('(', "before the positions");
    if (header.binary())
    {
        scan.setBinaryBody();
    }
    for (std::size_t i = 0; i < size; ++i)
    {
        double xyz[3];
        if (header.binary())
        {
            expectAt(scan, '(', "before", name, 3*i);
            std::memcpy(xyz, scan.raw(28, "a position"), 24);
            expectAt(scan, ')', "after", name, 3*i);
            if
            (
                !std::isfinite(xyz[0]) || !std::isfinite(xyz[1])
             || !std::isfinite(xyz[2])
            )
            {
                scan.fail
                (
                    "Not a finite number: " + name(3*i),
                    "The run that wrote it had failed; start from an earlier "
                    "time."
                );
            }
        }
        else
        {
            readComponents(scan, name, 3*i, xyz);
            scan.number("the cell of a particle");
        }
        positions[i] = {xyz[0], xyz[1], xyz[2]};
    }
    scan.expect(')', "after the positions");
    checkEnd(scan);
    return positions;
}

} // namespace

cloudField readField
(
    const std::filesystem::path& file,
    std::optional<std::size_t> size
)
{
    const std::string bytes = readCaseFile(file);
    std::size_t begin = 0;
    const foamFile header = foamFile::parse(bytes, file, begin);
    foamScanner scan(bytes, file, begin);
    const fieldClass* cls = findFieldClass(header.cls);
    if (!cls)
    {
        std::vector<std::string> valid;
        for (const fieldClass& known : fieldClasses())
        {
            valid.push_back(known.name);
        }
        scan.fail
        (
            unknownChoice("cloud field", header.cls, valid),
            "Move the file elsewhere if it is not a field of the cloud."
        );
    }
    cloudField field{header.cls, file.filename().string(), {}};
    if (!size)
    {
        size = foamScanner(scan).count();
        if (*size > scan.remaining())
        {
            scan.fail
            (
                "The file is too short for " + std::to_string(*size)
              + " values",
                "It is truncated: run the program that writes it again."
            );
        }
    }
    field.values = readValues(scan, header, *cls, field.name, *size);
    if (cls->isLabel)
    {
        checkLabelValues(scan, field.values, field.name);
    }
    checkEnd(scan);
    return field;
}

//- Large files at the same time; the general reader takes what is left, in
//  order, and complains
static void readFiles
(
    cloud& particles,
    const std::filesystem::path& directory,
    const std::vector<std::filesystem::path>& files,
    const std::set<std::string>& asVectors
)
{
    std::optional<std::vector<vector>> positions;
    std::vector<std::optional<cloudField>> fields(files.size());
    std::vector<std::optional<std::vector<vector>>> vectors(files.size());
    forEachFile(int(files.size()) + 1, [&](int k)
    {
        if (k == 0)
        {
            positions = largePositions(directory/"positions");
            return;
        }
        const std::filesystem::path& file = files[k - 1];
        if (asVectors.count(file.filename().string()))
        {
            vectors[k - 1] = largeVectors(file);
        }
        else
        {
            fields[k - 1] = largeField(file);
        }
    });
    particles.positions = positions
      ? std::move(*positions) : readPositions(directory/"positions");
    const std::size_t n = particles.size();
    for (std::size_t k = 0; k < files.size(); ++k)
    {
        if (vectors[k] && vectors[k]->size() == n)
        {
            particles.vectors[files[k].filename().string()] =
                std::move(*vectors[k]);
        }
        else if (fields[k] && fields[k]->size() == n)
        {
            particles.fields.push_back(std::move(*fields[k]));
        }
        else
        {
            particles.fields.push_back(readField(files[k], n));
        }
    }
}

cloud readCloud
(
    const std::filesystem::path& timeDirectory,
    const std::string& cloudName,
    const cloudRequest& request
)
{
    const std::filesystem::path directory =
        timeDirectory/"lagrangian"/cloudName;
    if (!std::filesystem::is_directory(directory))
    {
        std::string there;
        for (const std::string& name : cloudNames(timeDirectory))
        {
            there += " " + name;
        }
        throw userError
        (
            "There is no cloud " + cloudName + " in "
          + timeDirectory.string() + (there.empty()
          ? "; no cloud is there at all"
          : "; there are:" + there),
            {directory},
            "Run seedParticles, or start from a time that has it."
        );
    }
    cloud particles;
    particles.name = cloudName;

    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(directory))
    {
        std::filesystem::path file = entry.path();
        if (file.extension() == ".gz")
        {
            file.replace_extension();
        }
        const std::string name = file.filename().string();
        if
        (
            entry.is_regular_file() && name[0] != '.' && name != "positions"
         && name != "coordinates" && !request.leaveOut.count(name)
        )
        {
            files.push_back(file);
        }
    }
    std::sort(files.begin(), files.end());
    files.erase(std::unique(files.begin(), files.end()), files.end());
    readFiles(particles, directory, files, request.vectors);
    return particles;
}

} // namespace gpuFsi
