#include "vtk/shownField.H"

#include <algorithm>
#include <cmath>
#include <set>

namespace gpuFsi
{

//- In the order of OpenFOAM's files
static std::vector<std::string> suffixes(const std::string& cls)
{
    if (cls == "vectorField")
    {
        return {"x", "y", "z"};
    }
    if (cls == "symmTensorField")
    {
        return {"xx", "xy", "xz", "yy", "yz", "zz"};
    }
    if (cls == "tensorField")
    {
        return {"xx", "xy", "xz", "yx", "yy", "yz", "zx", "zy", "zz"};
    }
    return {};
}


static const cloudField* anyOf
(
    const std::vector<cloud>& clouds,
    const std::string& name
)
{
    for (const cloud& candidate : clouds)
    {
        if (const cloudField* field = candidate.find(name))
        {
            return field;
        }
    }
    return nullptr;
}


static std::vector<std::string> fieldNames(const std::vector<cloud>& clouds)
{
    std::set<std::string> names;
    for (const cloud& from : clouds)
    {
        for (const cloudField& field : from.fields)
        {
            names.insert(field.name);
        }
    }
    return {names.begin(), names.end()};
}


shownField::shownField
(
    const std::vector<cloud>& clouds,
    const std::string& name
)
:
    name_(name)
{
    const std::vector<std::string> names = fieldNames(clouds);
    if (name_.empty())
    {
        if (names.empty())
        {
            throw userError
            (
                "There is no field to colour the particles by",
                {},
                "Write at least one field, such as U, beside the positions"
            );
        }
        name_ = anyOf(clouds, "U") ? "U" : names.front();
    }

    const cloudField* field = anyOf(clouds, name_);
    const std::size_t dot = name_.rfind('.');
    if (!field && dot != std::string::npos)
    {
        suffix_ = name_.substr(dot + 1);
        name_.resize(dot);
        field = anyOf(clouds, name_);
    }
    if (!field)
    {
        throw userError(unknownChoice("field", name_, names));
    }
    nComponents_ = field->nComponents();
    if (!suffix_.empty())
    {
        const std::vector<std::string> valid = suffixes(field->cls);
        const auto at = std::find(valid.begin(), valid.end(), suffix_);
        if (at == valid.end())
        {
            throw userError
            (
                valid.empty()
              ? "Field " + name_ + " has no components, but " + name + " asks"
                " for one"
              : unknownChoice("component of " + name_, suffix_, valid)
            );
        }
        component_ = static_cast<int>(at - valid.begin());
    }
}


std::string shownField::title() const
{
    if (component_ >= 0)
    {
        return name_ + '.' + suffix_;
    }
    return nComponents_ > 1 ? '|' + name_ + '|' : name_;
}


double shownField::value(const cloudField& field, std::size_t i) const
{
    const double* v = field.values.data() + i*nComponents_;
    if (component_ >= 0)
    {
        return v[component_];
    }
    if (nComponents_ == 1)
    {
        return v[0];
    }
    double squares = 0;
    for (int c = 0; c < nComponents_; ++c)
    {
        // Off-diagonal entries of a symmetric tensor stand for two
        const bool twice = nComponents_ == 6 && (c == 1 || c == 2 || c == 4);
        squares += (twice ? 2 : 1)*v[c]*v[c];
    }
    return std::sqrt(squares);
}

} // namespace gpuFsi
