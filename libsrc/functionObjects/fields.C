#include "functionObjects/fields.H"

#include <algorithm>

namespace gpuFsi
{

namespace fields
{

namespace
{

const std::vector<std::string> known{"rho", "deltaRho", "p", "U"};

void check(const std::string& field, const sourceSpan& where)
{
    if (std::find(known.begin(), known.end(), field) == known.end())
    {
        throw userError(unknownChoice("field", field, known), where);
    }
}

} // namespace


int nComponents(const std::string& field)
{
    return field == "U" ? 3 : 1;
}


std::string readName(const dictionary& dict, const std::string& key)
{
    const std::string field = dict.get<std::string>(key);
    check(field, dict.where(key));
    return field;
}


std::vector<std::string> readNames
(
    const dictionary& dict,
    const std::string& key
)
{
    const auto names = dict.get<std::vector<std::string>>(key);
    if (names.empty())
    {
        throw userError
        (
            key + " is empty",
            dict.where(key),
            "Name one field or more, e.g. fields (rho U);"
        );
    }
    for (const std::string& field : names)
    {
        check(field, dict.where(key));
    }
    return names;
}


std::vector<double> values
(
    const std::string& field,
    const particleSet& set,
    const hostState& state,
    const runInfo& info
)
{
    if (field == "deltaRho")
    {
        return set.deltaRho;
    }
    std::vector<double> result;
    if (field == "U")
    {
        result.reserve(3*set.size());
        for (const vector& u : set.U)
        {
            result.insert(result.end(), {u.x, u.y, u.z});
        }
        return result;
    }
    result.resize(set.size());
    const bool pressure = field == "p";
    #pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < set.size(); ++i)
    {
        const double rho = state.rho0 + set.deltaRho[i];
        result[i] = pressure ? info.pressure(rho) : rho;
    }
    return result;
}


double restValue(const std::string& field, const runInfo& info)
{
    if (field == "rho")
    {
        return info.rho0;
    }
    return field == "p" ? info.pressure(info.rho0) : 0;
}

} // namespace fields

} // namespace gpuFsi
