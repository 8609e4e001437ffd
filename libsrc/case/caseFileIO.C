#include "case/caseFileIO.H"

#include "base/error.H"

#include <fcntl.h>
#include <unistd.h>
#include <zlib.h>

#include <cerrno>
#include <cstring>

namespace gpuFsi
{

namespace
{

// In the cache of a core
constexpr std::size_t bufferBytes = std::size_t(1) << 20;
constexpr std::size_t chunkBytes = std::size_t(64) << 20;

[[noreturn]] void cannotRead
(
    const std::filesystem::path& file,
    const std::string& why
)
{
    throw userError
    (
        "Cannot read " + file.string() + ": " + why,
        {file},
        "Is it a file that you may read, and whole? Or start from an earlier "
        "time."
    );
}

std::string inflateFile(const std::filesystem::path& file)
{
    gzFile in = gzopen(file.c_str(), "rb");
    if (!in)
    {
        cannotRead(file, std::strerror(errno));
    }
    gzbuffer(in, 1 << 20);
    std::string bytes;
    std::size_t size = 0;
    int got;
    do
    {
        bytes.resize(size + (std::size_t(1) << 22));
        got = gzread(in, &bytes[size], 1 << 22);
        size += got > 0 ? got : 0;
    }
    while (got > 0);
    int status = Z_OK;
    const std::string reason = gzerror(in, &status);
    gzclose(in);
    if (got < 0 || (status != Z_OK && status != Z_STREAM_END))
    {
        cannotRead(file, reason + ": the compressed file is damaged");
    }
    bytes.resize(size);
    return bytes;
}

} // namespace

std::filesystem::path existingCaseFile(const std::filesystem::path& file)
{
    std::filesystem::path zipped = file;
    zipped += ".gz";
    std::error_code none;
    const bool plain = std::filesystem::is_regular_file(file, none);
    const bool gz = std::filesystem::is_regular_file(zipped, none);
    if (plain && gz)
    {
        throw userError
        (
            "Both " + file.string() + " and its .gz exist",
            {file},
            "Remove the one that is out of date."
        );
    }
    if (!plain && !gz)
    {
        throw userError
        (
            "There is no file " + file.string(),
            {file},
            "Run the program that writes it, or start from an earlier time."
        );
    }
    return plain ? file : zipped;
}

std::string readCaseFile(const std::filesystem::path& file)
{
    const std::filesystem::path name = existingCaseFile(file);
    if (name.extension() == ".gz")
    {
        return inflateFile(name);
    }
    const int in = open(name.c_str(), O_RDONLY);
    if (in < 0)
    {
        cannotRead(name, std::strerror(errno));
    }
    std::string bytes(std::filesystem::file_size(name), '\0');
    std::size_t size = 0;
    ssize_t got = 1;
    while (size < bytes.size() && got != 0)
    {
        got = read
        (
            in,
            &bytes[size],
            std::min(chunkBytes, bytes.size() - size)
        );
        if (got < 0 && errno != EINTR)
        {
            const std::string why = std::strerror(errno);
            close(in);
            cannotRead(name, why);
        }
        size += got > 0 ? got : 0;
    }
    close(in);
    bytes.resize(size);
    return bytes;
}

caseFileWriter::caseFileWriter
(
    const std::filesystem::path& file,
    bool compress
)
:
    file_(file),
    buffer_(new char[bufferBytes])
{
    if (compress)
    {
        file_ += ".gz";
    }
    std::error_code failed;
    std::filesystem::create_directories(file_.parent_path(), failed);
    descriptor_ = open(file_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
    if (descriptor_ < 0)
    {
        fail(errno);
    }
    if (compress)
    {
        gzip_ = gzdopen(descriptor_, "wb");
        if (!gzip_)
        {
            fail(ENOMEM);
        }
        gzbuffer(static_cast<gzFile>(gzip_), 1 << 20);
    }
}

caseFileWriter::~caseFileWriter()
{
    if (descriptor_ < 0)
    {
        return;
    }
    if (gzip_)
    {
        gzclose(static_cast<gzFile>(gzip_));
    }
    else
    {
        close(descriptor_);
    }
    std::error_code ignored;
    if (std::filesystem::is_regular_file(file_, ignored))
    {
        std::filesystem::remove(file_, ignored);
    }
}

void caseFileWriter::append(const std::string& text)
{
    append(text.data(), text.size());
}

void caseFileWriter::append(const char* data, std::size_t nBytes)
{
    if (nBytes > bufferBytes - used_)
    {
        flush();
    }
    if (nBytes > bufferBytes)
    {
        put(data, nBytes);
        return;
    }
    std::memcpy(buffer_.get() + used_, data, nBytes);
    used_ += nBytes;
}

char* caseFileWriter::space(std::size_t nBytes)
{
    if (nBytes > bufferBytes - used_)
    {
        flush();
    }
    return buffer_.get() + used_;
}

void caseFileWriter::flush()
{
    put(buffer_.get(), used_);
    used_ = 0;
}

void caseFileWriter::put(const char* data, std::size_t nBytes)
{
    while (nBytes)
    {
        const std::size_t part = std::min(nBytes, chunkBytes);
        errno = 0;
        const ssize_t done = gzip_
            ? gzwrite(static_cast<gzFile>(gzip_), data, unsigned(part))
            : ::write(descriptor_, data, part);
        if (done <= 0)
        {
            if (errno == EINTR && !gzip_)
            {
                continue;
            }
            fail(errno ? errno : EIO);
        }
        data += done;
        nBytes -= done;
    }
}

std::size_t caseFileWriter::finish()
{
    flush();
    errno = 0;
    const int status = gzip_
        ? gzclose(static_cast<gzFile>(gzip_))
        : close(descriptor_);
    gzip_ = nullptr;
    descriptor_ = -1;
    if (status != 0)
    {
        const int reason = errno ? errno : EIO;
        std::error_code ignored;
        if (std::filesystem::is_regular_file(file_, ignored))
        {
            std::filesystem::remove(file_, ignored);
        }
        fail(reason);
    }
    std::error_code ignored;
    const auto size = std::filesystem::file_size(file_, ignored);
    return ignored ? 0 : size;
}

void caseFileWriter::fail(int errorNumber) const
{
    const bool full = errorNumber == ENOSPC || errorNumber == EDQUOT;
    throw userError
    (
        "Cannot write " + file_.string() + ": "
      + (full ? "the disk is full" : std::strerror(errorNumber)),
        {file_},
        full
      ? "Free some space (purgeWrite keeps only the last times) and restart "
        "from the latest time."
      : "Check that the directory exists and may be written to."
    );
}

std::size_t writeTextFile
(
    const std::filesystem::path& file,
    const std::string& text
)
{
    caseFileWriter out(file);
    out.append(text);
    return out.finish();
}

} // namespace gpuFsi
