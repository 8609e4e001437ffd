#include "study/logWords.H"

#include <deque>
#include <fstream>
#include <iterator>
#include <sstream>

namespace gpuFsi
{

namespace fs = std::filesystem;

std::string bytesOf(const fs::path& file)
{
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}


std::string lastWords(const fs::path& log)
{
    const std::string text = bytesOf(log);
    const std::size_t fatal = text.rfind("FOAM FATAL");
    std::istringstream stream
    (
        fatal == text.npos ? text : text.substr(text.find('\n', fatal))
    );
    std::deque<std::string> lines;
    for (std::string line; std::getline(stream, line);)
    {
        if (!line.empty() && (fatal == text.npos || lines.size() < 5))
        {
            lines.push_back(line);
        }
        if (lines.size() > 5)
        {
            lines.pop_front();
        }
    }
    std::string all;
    for (const std::string& line : lines)
    {
        all += "\n    " + line;
    }
    return all;
}

} // namespace gpuFsi
