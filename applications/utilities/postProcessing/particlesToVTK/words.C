#include "words.H"

#include "base/error.H"

#include <charconv>
#include <cmath>
#include <sstream>

namespace gpuFsi
{

std::vector<std::string> parseWords
(
    const std::string& option,
    const std::string& text
)
{
    const std::size_t first = text.find_first_not_of(" \t");
    const std::size_t last = text.find_last_not_of(" \t");
    std::string inner = text;
    if (first != std::string::npos && text[first] == '(')
    {
        inner = text[last] == ')' && last > first
          ? text.substr(first + 1, last - first - 1)
          : "(";
    }
    std::istringstream in(inner);
    std::vector<std::string> words;
    for (std::string word; in >> word;)
    {
        words.push_back(word);
    }
    if (words.empty() || inner.find_first_of("()") != std::string::npos)
    {
        throw userError
        (
            "-" + option + " '" + text + "' is not a list of names",
            {},
            "Write one name, or several as -" + option + " '(a b)'"
        );
    }
    return words;
}


std::vector<double> parseNumbers
(
    const std::string& option,
    const std::string& text,
    std::size_t n,
    const std::string& example
)
{
    std::istringstream in(text);
    std::vector<double> numbers;
    bool valid = true;
    for (std::string word; in >> word;)
    {
        double value = 0;
        const char* end = word.data() + word.size();
        const auto [stopped, failed] =
            std::from_chars(word.data(), end, value);
        valid = valid && failed == std::errc() && stopped == end
            && std::isfinite(value);
        numbers.push_back(value);
    }
    if (!valid || numbers.size() != n)
    {
        throw userError
        (
            "-" + option + " '" + text + "' is not "
          + (n == 1 ? "a number" : std::to_string(n) + " numbers"),
            {},
            "Write for example -" + option + " '" + example + "'"
        );
    }
    return numbers;
}

} // namespace gpuFsi
