#include "dictionary/number.H"

#include <cctype>
#include <charconv>

namespace gpuFsi
{

bool readNumber
(
    const std::string& text,
    double& value,
    const sourceSpan& where
)
{
    const char* first = text.data();
    const char* last = first + text.size();
    if (first != last && *first == '+')
    {
        ++first;
    }
    const char* digit = first;
    if (digit != last && *digit == '-' && first == text.data())
    {
        ++digit;
    }
    if (digit != last && *digit == '.')
    {
        ++digit;
    }

    // from_chars would take nan, inf and infinity
    if (digit == last || !std::isdigit(static_cast<unsigned char>(*digit)))
    {
        return false;
    }
    double result = 0;
    const auto [end, status] = std::from_chars(first, last, result);
    if (end != last || status == std::errc::invalid_argument)
    {
        return false;
    }
    if (status == std::errc::result_out_of_range)
    {
        throw userError
        (
            "Number " + text + " is beyond double precision",
            where,
            "Magnitudes lie between about 1e-308 and 1e308; write 0 for"
            " nothing."
        );
    }
    value = result;
    return true;
}


bool readSwitch(const std::string& text, bool& value)
{
    static const char* const words[] =
        {"true", "on", "yes", "y", "t", "false", "off", "no", "n", "f"};
    for (int i = 0; i < 10; ++i)
    {
        if (text == words[i])
        {
            value = i < 5;
            return true;
        }
    }
    return false;
}


std::string numberText(double value)
{
    char buffer[64];
    const auto [end, status] =
        std::to_chars(buffer, buffer + sizeof buffer, value);
    return status == std::errc() ? std::string(buffer, end) : "nan";
}

} // namespace gpuFsi
