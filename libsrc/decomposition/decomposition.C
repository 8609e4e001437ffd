#include "decomposition/decomposition.H"

#include <algorithm>

namespace gpuFsi
{

const dictionary& decompositionInput::coeffs(const std::string& method) const
{
    const dictionary* own = dict.subDictPtr(method + "Coeffs");
    if (!own)
    {
        own = dict.subDictPtr("coeffs");
    }
    return own ? *own : dict.subDict(method + "Coeffs");
}


std::unique_ptr<decomposition> decomposition::make
(
    const dictionary& dict,
    const std::filesystem::path& casePath
)
{
    const std::string method = dict.get<std::string>("method");
    const sourceSpan where = dict.where("method");
    const auto known = selection::words();
    if
    (
        method == "scotch"
     && std::find(known.begin(), known.end(), method) == known.end()
    )
    {
        throw userError
        (
            "This build has no Scotch: the library was not found when it was"
            " configured",
            where,
            "Install it (Debian, Ubuntu: apt-get install libscotch-dev) and"
            " build again, or use method hilbert."
        );
    }
    return selection::make
    (
        "decomposition method", method, where, {dict, casePath}
    );
}

} // namespace gpuFsi
