#include "study/caseCopy.H"

#include "dictionary/number.H"

#include <algorithm>

namespace gpuFsi
{

namespace fs = std::filesystem;

static bool beginsWith(const std::string& text, const std::string& start)
{
    return text.compare(0, start.size(), start) == 0;
}


bool holdsFields(const std::string& name)
{
    double time = 0;
    return readNumber(name, time) || beginsWith(name, "processor")
     || beginsWith(name, "broken_") || name == "VTK";
}


static bool derived(const fs::path& relative)
{
    const std::string top = relative.begin()->string();
    const std::string file = relative.string();
    for (const char* name : {"polyMesh", "domain", "solid"})
    {
        if (file == std::string("constant/") + name)
        {
            return true;
        }
    }
    return holdsFields(top) || beginsWith(top, "study")
     || beginsWith(top, "log.") || top == "postProcessing"
     || top == "pictures" || relative.extension() == ".foam";
}


std::vector<fs::path> ownFiles
(
    const fs::path& casePath,
    const std::vector<std::string>& others
)
{
    std::vector<fs::path> files;
    fs::recursive_directory_iterator it(casePath), end;
    for (; it != end; ++it)
    {
        const fs::path relative = it->path().lexically_relative(casePath);
        const bool other =
            std::find(others.begin(), others.end(), relative.string())
         != others.end();
        if (other || derived(relative))
        {
            it.disable_recursion_pending();
        }
        else if (it->is_regular_file())
        {
            files.push_back(relative);
        }
    }
    std::sort(files.begin(), files.end());
    return files;
}

} // namespace gpuFsi
