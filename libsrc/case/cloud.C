#include "case/cloud.H"

#include "case/fieldClass.H"

#include <algorithm>

namespace gpuFsi
{

int cloudField::nComponents() const
{
    const fieldClass* known = findFieldClass(cls);
    developerAssert(known, "cloudField of an unknown class");
    return known->nComponents;
}

const cloudField* cloud::find(const std::string& field) const
{
    for (const cloudField& f : fields)
    {
        if (f.name == field)
        {
            return &f;
        }
    }
    return nullptr;
}

void cloud::addScalar(const std::string& field, std::vector<double> values)
{
    fields.push_back({"scalarField", field, std::move(values)});
}

void cloud::addLabel(const std::string& field, std::vector<double> values)
{
    fields.push_back({"labelField", field, std::move(values)});
}

void cloud::addVector
(
    const std::string& field,
    const std::vector<vector>& values
)
{
    cloudField f{"vectorField", field, {}};
    f.values.reserve(3*values.size());
    for (const vector& v : values)
    {
        f.values.insert(f.values.end(), {v.x, v.y, v.z});
    }
    fields.push_back(std::move(f));
}

std::vector<std::string> cloudNames(const std::filesystem::path& time)
{
    std::vector<std::string> names;
    const std::filesystem::path parent = time/"lagrangian";
    if (std::filesystem::is_directory(parent))
    {
        for (const auto& entry : std::filesystem::directory_iterator(parent))
        {
            if
            (
                std::filesystem::exists(entry.path()/"positions")
             || std::filesystem::exists(entry.path()/"positions.gz")
            )
            {
                names.push_back(entry.path().filename().string());
            }
        }
    }
    std::sort(names.begin(), names.end());
    return names;
}

} // namespace gpuFsi
