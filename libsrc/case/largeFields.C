#include "case/largeFields.H"

#include "case/fieldClass.H"
#include "case/largeList.H"

#include <cstdint>
#include <cstring>

namespace gpuFsi
{

namespace
{

//- Of a position: a line's end, (x y z cell)
constexpr std::size_t positionBytes = 31;

bool takePositions
(
    const char* from,
    std::size_t n,
    std::vector<vector>& positions
)
{
    const std::size_t first = positions.size();
    positions.resize(first + n);
    bool sound = true;
    for (std::size_t i = 0; i < n; ++i, from += positionBytes)
    {
        double xyz[3];
        std::memcpy(xyz, from + 2, sizeof(xyz));
        positions[first + i] = {xyz[0], xyz[1], xyz[2]};
        sound &= from[0] == '\n' && from[1] == '(' && from[30] == ')';
    }
    return sound && allFinite(&positions[first].x, 3*n);
}

bool takeLabels(const char* from, std::size_t n, std::vector<double>& values)
{
    const std::size_t first = values.size();
    values.resize(first + n);
    for (std::size_t i = 0; i < n; ++i)
    {
        std::int32_t label;
        std::memcpy(&label, from + 4*i, 4);
        values[first + i] = label;
    }
    return true;
}

//- n numbers, where the buffer that `from` points to holds numbers
bool takeNumbers(const char* from, std::size_t n, std::vector<double>& values)
{
    const double* numbers = reinterpret_cast<const double*>(from);
    values.insert(values.end(), numbers, numbers + n);
    return allFinite(numbers, n);
}

} // namespace

std::optional<std::vector<vector>> largePositions
(
    const std::filesystem::path& file
)
{
    static_assert(sizeof(vector) == 3*sizeof(double), "positions lie flat");
    std::vector<vector> positions;
    const bool read = readLargeList
    (
        file,
        [&](const foamFile& header, std::size_t size)
        {
            const bool fits = header.cls.find("Cloud") != std::string::npos;
            positions.reserve(fits ? size : 0);
            return fits ? positionBytes : 0;
        },
        [&](const char* from, std::size_t n)
        {
            return takePositions(from, n, positions);
        }
    );
    return read ? std::make_optional(std::move(positions)) : std::nullopt;
}


std::optional<std::vector<vector>> largeVectors
(
    const std::filesystem::path& file
)
{
    std::vector<vector> values;
    const bool read = readLargeList
    (
        file,
        [&](const foamFile& header, std::size_t size)
        {
            const bool fits = header.cls == "vectorField";
            values.reserve(fits ? size : 0);
            return fits ? sizeof(vector) : 0;
        },
        [&](const char* from, std::size_t n)
        {
            const std::size_t first = values.size();
            values.resize(first + n);
            std::memcpy(&values[first], from, n*sizeof(vector));
            return allFinite(&values[first].x, 3*n);
        }
    );
    return read ? std::make_optional(std::move(values)) : std::nullopt;
}


std::optional<cloudField> largeField(const std::filesystem::path& file)
{
    cloudField field{"", file.filename().string(), {}};
    std::size_t each = 0;    // numbers
    bool labels = false;
    const bool read = readLargeList
    (
        file,
        [&](const foamFile& header, std::size_t size) -> std::size_t
        {
            const fieldClass* cls = findFieldClass(header.cls);
            if (!cls)
            {
                return 0;
            }
            field.cls = header.cls;
            each = cls->nComponents;
            labels = cls->isLabel;
            field.values.reserve(size*each);
            return (labels ? sizeof(std::int32_t) : sizeof(double))*each;
        },
        [&](const char* from, std::size_t n)
        {
            return labels
              ? takeLabels(from, n*each, field.values)
              : takeNumbers(from, n*each, field.values);
        }
    );
    return read ? std::make_optional(std::move(field)) : std::nullopt;
}

} // namespace gpuFsi
