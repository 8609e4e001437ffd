#include "exact/exactSolution.H"

namespace gpuFsi
{

vector fluidConstants::steadyForce(const dictionary& dict) const
{
    if (forceVaries && !dict.found("g"))
    {
        throw userError
        (
            "This exact solution is that of a steady body force, but "
            "constant/g varies with time",
            dict.where(),
            "Give a vector g here, or choose another solution."
        );
    }
    return dict.getOrDefault<vector>("g", g);
}


std::unique_ptr<exactSolution> exactSolution::make
(
    const std::string& word,
    const dictionary& dict,
    const fluidConstants& fluid,
    const sourceSpan& where
)
{
    const dictionary* coeffs = dict.subDictPtr(word + "Coeffs");
    return selection::make
    (
        "exact solution",
        word,
        where,
        coeffs ? *coeffs : dict,
        fluid
    );
}


bool exactSolution::has(const std::string& field) const
{
    return field == "deltaRho" || field == "U";
}

} // namespace gpuFsi
