#include "particles/needField.H"

#include "base/error.H"

#include <fmt/format.h>

namespace gpuFsi
{

namespace fs = std::filesystem;

const cloudField& needField
(
    const cloud& c,
    const std::string& field,
    const std::string& cls,
    const fs::path& time
)
{
    const fs::path file = time/"lagrangian"/c.name/field;
    const cloudField* f = c.find(field);
    if (!f)
    {
        throw userError
        (
            fmt::format("Cloud {} has no field '{}'", c.name, field),
            {file.string()},
            "Run seedParticles, or write the field."
        );
    }
    if (f->cls != cls)
    {
        throw userError
        (
            fmt::format("Field '{}' is a {}, not a {}", field, f->cls, cls),
            {file.string()},
            "Is the file under the right name? Seed again, or start from an "
            "earlier time."
        );
    }
    return *f;
}


std::vector<double> takeValues
(
    cloud& c,
    const std::string& field,
    const std::string& cls,
    const fs::path& time
)
{
    const cloudField& f = needField(c, field, cls, time);
    return std::move(c.fields[&f - c.fields.data()].values);
}


std::vector<vector> takeVectors
(
    cloud& c,
    const std::string& field,
    const fs::path& time
)
{
    const auto found = c.vectors.find(field);
    return found != c.vectors.end()
      ? std::move(found->second)
      : vectorsOf(needField(c, field, "vectorField", time));
}


std::vector<vector> vectorsOf(const cloudField& f)
{
    const std::size_t n = f.size();
    std::vector<vector> v;
    v.reserve(n);
    for (std::size_t i = 0; i < n; ++i)
    {
        v.push_back
        ({
            f.values[3*i], f.values[3*i + 1], f.values[3*i + 2]
        });
    }
    return v;
}

} // namespace gpuFsi
