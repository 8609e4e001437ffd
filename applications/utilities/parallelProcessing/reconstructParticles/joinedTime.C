#include "joinedTime.H"

#include "base/log.H"
#include "case/atomicFolder.H"
#include "decomposition/cloudForm.H"
#include "decomposition/cloudParts.H"

#include <set>

namespace gpuFsi
{

namespace fs = std::filesystem;

static void joinCloud
(
    const std::vector<fs::path>& folders,
    const std::string& name,
    std::optional<std::size_t> size,
    const fs::path& to
)
{
    std::vector<cloud> parts;
    std::vector<fs::path> where;
    cloudForm form;
    for (const fs::path& folder : folders)
    {
        parts.push_back(readCloud(folder, name));
        where.push_back(folder/"lagrangian"/name);
        form.widen(cloudForm::of(folder, name));
    }
    cloud whole = joinParts(std::move(parts), where, size);
    info
    (
        "    {}: {} particles, {} fields",
        name, whole.size(), whole.fields.size()
    );
    form.write(to, std::move(whole));
}


//- All but the clouds and uniform/, which are written anew
static void keepOthers(const fs::path& former, const fs::path& to)
{
    if (!fs::is_directory(former))
    {
        return;
    }
    for (const auto& entry : fs::directory_iterator(former))
    {
        const fs::path name = entry.path().filename();
        if (name != "lagrangian" && name != "uniform")
        {
            fs::copy(entry.path(), to/name, fs::copy_options::recursive);
        }
    }
}


void joinTime
(
    const fs::path& casePath,
    const std::string& time,
    const decompositionRecord& record,
    int nRanks
)
{
    std::vector<fs::path> folders;
    std::set<std::string> names;
    for (int r = 0; r < nRanks; ++r)
    {
        folders.push_back(processorPath(casePath, r)/time);
        for (const std::string& name : cloudNames(folders.back()))
        {
            names.insert(name);
        }
    }
    info("Time = {}", time);
    writeFolderAtomically(casePath, time, [&](const fs::path& to)
    {
        keepOthers(casePath/time, to);
        if (fs::exists(folders[0]/"uniform"))
        {
            fs::copy
            (
                folders[0]/"uniform", to/"uniform",
                fs::copy_options::recursive
            );
        }
        for (const std::string& name : names)
        {
            const auto known = record.clouds.find(name);
            std::optional<std::size_t> size;
            if (known != record.clouds.end())
            {
                size = known->second;
            }
            joinCloud(folders, name, size, to);
        }
    });
}

} // namespace gpuFsi
