#include "exact/exactSolution.H"

namespace gpuFsi
{

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
