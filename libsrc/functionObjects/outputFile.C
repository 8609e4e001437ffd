#include "functionObjects/outputFile.H"

#include "base/error.H"

#include <cerrno>
#include <cstring>

namespace gpuFsi
{

namespace
{

std::filesystem::path unused
(
    const std::filesystem::path& directory,
    const std::string& file,
    const std::string& time
)
{
    namespace fs = std::filesystem;
    const fs::path wanted(file);
    const std::string ending = wanted.extension().string();
    const std::string stem = wanted.stem().string();
    std::string name = file;
    for (int number = 0; fs::exists(directory/name); ++number)
    {
        name = stem + "_" + time
            + (number ? "_" + std::to_string(number) : "") + ending;
    }
    return directory/name;
}

} // namespace


outputFile::outputFile
(
    const std::filesystem::path& casePath,
    const std::string& name,
    const std::string& time,
    const std::string& file
)
{
    const auto directory = casePath/"postProcessing"/name/time;
    std::error_code code;
    std::filesystem::create_directories(directory, code);
    path_ = unused(directory, file, time);
    errno = 0;
    stream_.open(path_);
    if (code || !stream_)
    {
        throw userError
        (
            "Cannot write " + path_.string() + ": "
            + (code ? code.message() : std::strerror(errno)),
            {},
            "Check the directory's permissions and the free space."
        );
    }
}


void outputFile::write(const std::string& text)
{
    errno = 0;
    stream_ << text << std::flush;
    if (!stream_)
    {
        throw userError
        (
            "Cannot write " + path_.string() + ": " + std::strerror(errno),
            {},
            "Check the free space."
        );
    }
}

} // namespace gpuFsi
