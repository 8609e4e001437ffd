#include "functionObjects/referenceField.H"

#include "functionObjects/fields.H"

namespace gpuFsi
{

namespace
{

fluidConstants constantsOf(const runInfo& info)
{
    fluidConstants fluid;
    fluid.dimensions = info.dimensions;
    fluid.rho0 = info.rho0;
    fluid.c = info.c;
    fluid.nu = info.mu/info.rho0;
    fluid.g = info.gravity;
    fluid.forceVaries = info.forceVaries;
    return fluid;
}


std::vector<std::string> expressionTexts
(
    const dictionary& dict,
    int nComponents
)
{
    if (nComponents == 1)
    {
        const auto& tokens = dict.tokens("reference");
        if (tokens.size() == 1)
        {
            return {tokens[0].text};
        }
    }
    else
    {
        auto texts = dict.get<std::vector<std::string>>("reference");
        if (texts.size() == 3)
        {
            return texts;
        }
    }
    throw userError
    (
        nComponents == 1
      ? "reference of a scalar field is not one expression"
      : "reference of a vector field is not a list of three expressions",
        dict.where("reference"),
        nComponents == 1
      ? "Write reference \"0.01*exp(-r^2)\";"
      : "Write reference (\"y\" \"-x\" \"0\");"
    );
}

} // namespace


referenceField::referenceField
(
    const std::string& field,
    const dictionary& dict,
    const runInfo& info,
    const vector& centre
)
:
    field_(field),
    centre_(centre)
{
    if (dict.found("exact") == dict.found("reference"))
    {
        std::string words;
        for (const std::string& word : exactSolution::selection::words())
        {
            words += " " + word;
        }
        throw userError
        (
            dict.found("exact")
          ? "both exact and reference are given"
          : "neither exact nor reference is given: nothing to compare with",
            dict.where(),
            "Give one: exact followed by one of:" + words
            + ", or reference \"expression of x y z r t\"."
        );
    }
    if (dict.found("reference"))
    {
        const int n = fields::nComponents(field);
        for (const std::string& text : expressionTexts(dict, n))
        {
            expressions_.emplace_back(text, dict.where("reference"));
        }
        return;
    }
    const std::string word = dict.get<std::string>("exact");
    exact_ = exactSolution::make
    (
        word,
        dict,
        constantsOf(info),
        dict.where("exact")
    );
    const bool derived = field == "rho" || field == "p";
    if (!exact_->has(field) && !(derived && exact_->has("deltaRho")))
    {
        throw userError
        (
            "The exact solution " + word + " does not tell " + field,
            dict.where("field"),
            "Choose another field, or give a reference expression."
        );
    }
}


std::vector<double> referenceField::values
(
    const std::vector<vector>& points,
    const runInfo& info
) const
{
    if (exact_)
    {
        return exactValues(points, info);
    }
    std::vector<vector> fromCentre;
    fromCentre.reserve(points.size());
    for (const vector& p : points)
    {
        fromCentre.push_back(p - centre_);
    }
    const std::size_t n = expressions_.size();
    std::vector<double> result(n*points.size());
    for (std::size_t k = 0; k < n; ++k)
    {
        const auto component = expressions_[k].at(fromCentre, info.time);
        for (std::size_t i = 0; i < points.size(); ++i)
        {
            result[n*i + k] = component[i];
        }
    }
    return result;
}


std::vector<double> referenceField::exactValues
(
    const std::vector<vector>& points,
    const runInfo& info
) const
{
    if (field_ == "U")
    {
        std::vector<double> result;
        result.reserve(3*points.size());
        for (const vector& u : exact_->vectors(field_, points, info.time))
        {
            result.insert(result.end(), {u.x, u.y, u.z});
        }
        return result;
    }
    if (exact_->has(field_))
    {
        return exact_->scalar(field_, points, info.time);
    }
    // rho and p follow from deltaRho and the run's equation of state
    auto result = exact_->scalar("deltaRho", points, info.time);
    for (double& value : result)
    {
        const double rho = info.rho0 + value;
        value = field_ == "p" ? info.pressure(rho) : rho;
    }
    return result;
}

} // namespace gpuFsi
