#include "case/atomicFolder.H"

#include "base/error.H"

#include <fcntl.h>
#include <stdio.h>

namespace gpuFsi
{

namespace fs = std::filesystem;

void writeFolderAtomically
(
    const fs::path& parent,
    const std::string& name,
    const std::function<void(const fs::path&)>& body
)
{
    const fs::path partial = parent/("." + name + ".partial");
    const fs::path inside = partial/name;
    const fs::path target = parent/name;
    if (fs::exists(target) && !fs::is_directory(target))
    {
        throw userError
        (
            "Cannot write the folder " + target.string()
          + ": a file has that name",
            {target.string()},
            "Move the file elsewhere and run again."
        );
    }
    try
    {
        fs::remove_all(partial);    // of a run that was killed
        fs::create_directories(inside);
        body(inside);
        if (!fs::exists(target))
        {
            fs::rename(inside, target);
        }
        else if
        (
            renameat2
            (
                AT_FDCWD,
                inside.c_str(),
                AT_FDCWD,
                target.c_str(),
                RENAME_EXCHANGE
            ) != 0
        )
        {
            // A file system that cannot exchange two folders
            fs::rename(target, partial/"former");
            fs::rename(inside, target);
        }
        fs::remove_all(partial);
    }
    catch (const fs::filesystem_error& e)
    {
        std::error_code ignored;
        fs::remove_all(partial, ignored);
        throw userError
        (
            "Cannot write " + target.string() + ": " + e.code().message(),
            {target.string()},
            "Check that there is space and that the case may be written to."
        );
    }
    catch (...)
    {
        std::error_code ignored;
        fs::remove_all(partial, ignored);
        throw;
    }
}

} // namespace gpuFsi
