#include "study/studyLock.H"

#include "base/error.H"

#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace gpuFsi
{

studyLock::studyLock(const std::filesystem::path& directory)
{
    std::filesystem::create_directories(directory);
    const std::filesystem::path path = directory/".lock";
    // The commands do not inherit it
    file_ = open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (file_ >= 0 && flock(file_, LOCK_EX | LOCK_NB) == 0)
    {
        return;
    }
    const int number = errno;
    if (file_ >= 0)
    {
        close(file_);
    }
    throw userError
    (
        number == EWOULDBLOCK
          ? std::string("Another program runs this study")
          : std::string("Cannot lock: ") + std::strerror(number),
        {path.string()},
        "Wait for it, or give its dictionary a directory of its own; "
        "-tableOnly reads what is there."
    );
}


studyLock::~studyLock()
{
    close(file_);
}

} // namespace gpuFsi
