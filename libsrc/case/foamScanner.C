#include "case/foamScanner.H"

#include "base/error.H"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>

namespace gpuFsi
{

namespace
{

const char* const damaged =
    "The file is damaged or cut short; write it again or start from an "
    "earlier time.";

bool isSpace(char c)
{
    return c == ' ' || c == '\n' || c == '\t' || c == '\r';
}

bool isWordCharacter(char c)
{
    return !isSpace(c) && std::string_view("\"'/;{}()").find(c)
        == std::string_view::npos && c != '\0';
}

} // namespace

foamScanner::foamScanner
(
    std::string_view bytes,
    const std::filesystem::path& file,
    std::size_t offset
)
:
    bytes_(bytes),
    file_(file),
    at_(offset)
{}

void foamScanner::skipSpace()
{
    while (at_ < bytes_.size())
    {
        if (isSpace(bytes_[at_]))
        {
            ++at_;
        }
        else if (bytes_.compare(at_, 2, "//") == 0)
        {
            at_ = std::min(bytes_.find('\n', at_), bytes_.size());
        }
        else if (bytes_.compare(at_, 2, "/*") == 0)
        {
            const std::size_t end = bytes_.find("*/", at_ + 2);
            if (end == std::string_view::npos)
            {
                fail("Comment without an end", "Close it with */.");
            }
            at_ = end + 2;
        }
        else
        {
            return;
        }
    }
}

bool foamScanner::atEnd()
{
    skipSpace();
    return at_ == bytes_.size();
}

bool foamScanner::accept(char c)
{
    skipSpace();
    return acceptHere(c);
}

bool foamScanner::acceptHere(char c)
{
    const bool here = at_ < bytes_.size() && bytes_[at_] == c;
    at_ += here;
    return here;
}

bool foamScanner::acceptWord(std::string_view word)
{
    skipSpace();
    const std::size_t end = at_ + word.size();
    if
    (
        bytes_.compare(at_, word.size(), word) != 0
     || (end < bytes_.size() && isWordCharacter(bytes_[end]))
    )
    {
        return false;
    }
    at_ = end;
    return true;
}

void foamScanner::expect(char c, const char* why)
{
    if (!accept(c))
    {
        fail
        (
            std::string("Expected '") + c + "' " + why + ", found "
          + found(),
            damaged
        );
    }
}

bool foamScanner::nextIsNumber()
{
    skipSpace();
    return at_ < bytes_.size()
        && std::string_view("+-.0123456789").find(bytes_[at_])
        != std::string_view::npos;
}

std::string foamScanner::word()
{
    skipSpace();
    const std::size_t begin = at_;
    while (at_ < bytes_.size() && isWordCharacter(bytes_[at_]))
    {
        ++at_;
    }
    if (at_ == begin)
    {
        fail("Expected a word, found " + found(), damaged);
    }
    return std::string(bytes_.substr(begin, at_ - begin));
}

bool foamScanner::number(double& value)
{
    skipSpace();
    const char* begin = bytes_.data() + at_;
    const char* end = bytes_.data() + bytes_.size();
    if (begin != end && *begin == '+')
    {
        ++begin;
    }
    const auto result = std::from_chars(begin, end, value);
    if (result.ec == std::errc::invalid_argument)
    {
        return false;
    }
    if (result.ec == std::errc::result_out_of_range)
    {
        // from_chars does not say whether too large or too small
        value = std::strtod(std::string(begin, result.ptr).c_str(), nullptr);
    }
    if (result.ptr != end && isWordCharacter(*result.ptr))
    {
        return false;
    }
    at_ = result.ptr - bytes_.data();
    return true;
}

double foamScanner::number(const std::string& what)
{
    double value;
    if (!number(value))
    {
        fail("Expected a number for " + what + ", found " + found(), damaged);
    }
    return value;
}

long foamScanner::count()
{
    const double value = number("the size of the list");
    if (!(value >= 0 && value < 1e18) || value != double(long(value)))
    {
        fail
        (
            "The size of a list must be a whole number, not negative; found "
          + fmt::format("{}", value),
            damaged
        );
    }
    return long(value);
}

const char* foamScanner::raw(std::size_t nBytes, const char* what)
{
    if (remaining() < nBytes)
    {
        fail
        (
            std::string("The file ends within ") + what + ": "
          + std::to_string(nBytes) + " bytes are missing, "
          + std::to_string(remaining()) + " are left",
            "It is truncated; write it again or start from an earlier time."
        );
    }
    const char* begin = bytes_.data() + at_;
    at_ += nBytes;
    return begin;
}

std::string foamScanner::found() const
{
    if (at_ >= bytes_.size())
    {
        return "the end of the file (truncated?)";
    }
    std::string text;
    for (char c : bytes_.substr(at_, 20))
    {
        if (isSpace(c) && !text.empty())
        {
            break;
        }
        text += (c >= ' ' && c < 127) ? c : '?';
    }
    return "'" + text + "'";
}

void foamScanner::fail
(
    const std::string& message,
    const std::string& remedy
) const
{
    sourceSpan where{file_.string()};
    if (!binaryBody_)
    {
        const std::size_t end = std::min(at_, bytes_.size());
        where.first = where.last =
            1 + std::count(bytes_.begin(), bytes_.begin() + end, '\n');
    }
    throw userError(message, where, remedy);
}

} // namespace gpuFsi
