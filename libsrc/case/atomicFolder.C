#include "case/atomicFolder.H"

#include "base/error.H"

#include <fcntl.h>
#include <stdio.h>

namespace gpuFsi
{

namespace fs = std::filesystem;

static void throwIfFile(const fs::path& target)
{
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
}


//- f, its file system errors as the user's
template<class F>
static void writing(const fs::path& target, const F& f)
{
    try
    {
        f();
    }
    catch (const fs::filesystem_error& e)
    {
        throw userError
        (
            "Cannot write " + target.string() + ": " + e.code().message(),
            {target.string()},
            "Check that there is space and that the case may be written to."
        );
    }
}


atomicFolder::atomicFolder(fs::path parent, std::string name)
:
    partial_(parent/("." + name + ".partial")),
    inside_(partial_/name),
    target_(parent/name)
{}


atomicFolder::~atomicFolder()
{
    std::error_code ignored;
    fs::remove_all(partial_, ignored);
}


void atomicFolder::fill(const std::function<void(const fs::path&)>& body)
{
    throwIfFile(target_);
    writing(target_, [&]
    {
        fs::remove_all(partial_);    // of a run that was killed
        fs::create_directories(inside_);
        body(inside_);
    });
}


void atomicFolder::clear()
{
    writing(target_, [&]
    {
        if (fs::exists(target_))
        {
            fs::rename(target_, partial_/"former");
        }
    });
}


void atomicFolder::restore()
{
    std::error_code ignored;
    if (!fs::exists(target_, ignored))
    {
        fs::rename(partial_/"former", target_, ignored);
    }
}


void atomicFolder::publish()
{
    writing(target_, [&] { fs::rename(inside_, target_); });
}


//- Takes the name at once, where the file system can exchange two folders
static bool exchanged(const fs::path& a, const fs::path& b)
{
    return renameat2
    (
        AT_FDCWD, a.c_str(), AT_FDCWD, b.c_str(), RENAME_EXCHANGE
    ) == 0;
}


void writeFolderAtomically
(
    const fs::path& parent,
    const std::string& name,
    const std::function<void(const fs::path&)>& body
)
{
    const fs::path target = parent/name;
    atomicFolder folder(parent, name);
    folder.fill(body);
    const fs::path inside = parent/("." + name + ".partial")/name;
    if (!fs::exists(target) || !exchanged(inside, target))
    {
        folder.clear();
        folder.publish();
    }
}

} // namespace gpuFsi
