#include "case/largeList.H"

#include "case/caseFileIO.H"
#include "case/foamScanner.H"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <fcntl.h>
#include <memory>
#include <unistd.h>

namespace gpuFsi
{

namespace
{

constexpr std::size_t headBytes = std::size_t(1) << 14;
constexpr std::size_t tailBytes = 64;
constexpr std::size_t pieceBytes = std::size_t(1) << 18;

class openFile
{
public:

    explicit openFile(const std::filesystem::path& file)
    :
        descriptor_(open(file.c_str(), O_RDONLY))
    {
        posix_fadvise(descriptor_, 0, 0, POSIX_FADV_SEQUENTIAL);
    }

    ~openFile()
    {
        if (descriptor_ >= 0)
        {
            close(descriptor_);
        }
    }

    openFile(const openFile&) = delete;
    openFile& operator=(const openFile&) = delete;

    bool read(std::size_t offset, char* to, std::size_t n) const
    {
        while (n > 0)
        {
            const ssize_t got = pread(descriptor_, to, n, offset);
            if (got < 0 && errno == EINTR)
            {
                continue;
            }
            if (got <= 0)
            {
                return false;
            }
            to += got;
            offset += got;
            n -= got;
        }
        return true;
    }

private:

    int descriptor_;
};

//- Nothing but the end of the list
bool isEnd(const std::string& tail, const std::filesystem::path& file)
{
    foamScanner scan(tail, file);
    return scan.accept(')') && scan.atEnd();
}

} // namespace

bool readLargeList
(
    const std::filesystem::path& file,
    const std::function<std::size_t(const foamFile&, std::size_t)>& begin,
    const std::function<bool(const char*, std::size_t)>& piece
) noexcept
try
{
    const std::filesystem::path plain = existingCaseFile(file);
    const std::size_t fileSize = std::filesystem::file_size(plain);
    const openFile in(plain);
    std::string head(headBytes, '\0');
    if
    (
        plain.extension() == ".gz" || fileSize < 2*headBytes
     || !in.read(0, head.data(), headBytes)
    )
    {
        return false;
    }
    std::size_t at = 0;
    const foamFile header = foamFile::parse(head, plain, at);
    foamScanner scan(head, plain, at);
    if (!header.binary() || !scan.nextIsNumber())
    {
        return false;
    }
    const std::size_t size = scan.count();
    if (!scan.accept('('))
    {
        return false;
    }
    at = scan.offset();
    const std::size_t each = size <= fileSize ? begin(header, size) : 0;
    const std::size_t end = at + size*each;
    if (each == 0 || end >= fileSize || fileSize - end > tailBytes)
    {
        return false;
    }

    const std::size_t perPiece = pieceBytes/each;
    const std::unique_ptr<double[]> buffer(new double[pieceBytes/8]);
    char* const bytes = reinterpret_cast<char*>(buffer.get());
    for (std::size_t first = 0; first < size; first += perPiece)
    {
        const std::size_t n = std::min(perPiece, size - first);
        if (!in.read(at + first*each, bytes, n*each) || !piece(bytes, n))
        {
            return false;
        }
    }
    std::string tail(fileSize - end, '\0');
    return in.read(end, tail.data(), tail.size()) && isEnd(tail, plain);
}
catch (...)
{
    return false;
}


bool allFinite(const double* values, std::size_t n)
{
    constexpr std::uint64_t exponent = std::uint64_t(0x7ff) << 52;
    std::uint64_t found = 0;
    for (std::size_t i = 0; i < n; ++i)
    {
        std::uint64_t bits;
        std::memcpy(&bits, values + i, sizeof(bits));
        found |= (bits & exponent) == exponent;
    }
    return found == 0;
}

} // namespace gpuFsi
