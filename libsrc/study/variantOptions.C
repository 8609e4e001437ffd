#include "study/variantOptions.H"
#include "base/error.H"
#include "base/log.H"

namespace gpuFsi
{

std::vector<argList::option> variantOptions::besides
(
    std::vector<argList::option> own
)
{
    own.push_back({"list", "", "name the variants and run nothing"});
    own.push_back
    (
        {"tableOnly", "", "run nothing, take the results that are there"}
    );
    own.push_back({"force", "", "run again what has been run"});
    return own;
}


variantOptions::variantOptions(const argList& args)
:
    list_(args.found("list")),
    tableOnly_(args.found("tableOnly")),
    force_(args.found("force"))
{
    if (tableOnly_ && force_)
    {
        throw userError
        (
            "-force throws away the results that -tableOnly takes", {},
            "Give one of them."
        );
    }
}


bool variantOptions::lists(const variantSet& set) const
{
    if (list_)
    {
        for (const variant& v : allVariants(set))
        {
            info("{}", v.name);
        }
    }
    return list_;
}


void variantOptions::lock(const std::filesystem::path& directory)
{
    if (!tableOnly_)
    {
        lock_.emplace(directory);
    }
}

} // namespace gpuFsi
