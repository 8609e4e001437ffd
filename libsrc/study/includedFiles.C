#include "study/includedFiles.H"

#include "dictionary/dictionaryParser.H"

#include <algorithm>
#include <fstream>
#include <iterator>

namespace gpuFsi
{

namespace fs = std::filesystem;

namespace
{

//- Where a directive looks for a name
std::vector<fs::path> candidates
(
    const fs::path& file,
    const std::string& directive,
    const std::string& name
)
{
    const fs::path beside = file.parent_path();
    if (directive == "includeEtc")
    {
        return {dictionaryParser::findEtc(name)};
    }
    if (directive == "includeFunc")
    {
        return
        {
            beside/name, beside.parent_path()/"system"/name,
            dictionaryParser::findEtc(fs::path("caseDicts")/name)
        };
    }
    if (name.compare(0, 6, "<etc>/") == 0)
    {
        return {dictionaryParser::findEtc(name.substr(6))};
    }
    return {beside/name};
}


//- The first of them that is there
fs::path found(const std::vector<fs::path>& places)
{
    std::error_code ignored;
    const auto it = std::find_if
    (
        places.begin(), places.end(),
        [&](const fs::path& p) { return fs::is_regular_file(p, ignored); }
    );
    return it == places.end() ? fs::path() : it->lexically_normal();
}


void collect
(
    const fs::path& file,
    const std::string& text,
    std::vector<fs::path>& all
)
{
    for (std::size_t at = text.find("include"); at != text.npos;
        at = text.find("include", at + 1))
    {
        const std::size_t hash = text.find_last_not_of('s', at - 1);
        if (at == 0 || hash == text.npos || text[hash] != '#')
        {
            continue;
        }
        const std::size_t end = text.find_first_of(" \t\"<", at);
        const std::size_t name = text.find_first_not_of(" \t\"", end);
        if (name == text.npos)
        {
            return;
        }
        const fs::path next = found(candidates
        (
            file, text.substr(at, end - at),
            text.substr(name, text.find_first_of(" \t\r\n\";", name) - name)
        ));
        if (!next.empty()
         && std::find(all.begin(), all.end(), next) == all.end())
        {
            all.push_back(next);
            std::ifstream stream(next, std::ios::binary);
            collect(next, {std::istreambuf_iterator<char>(stream), {}}, all);
        }
    }
}

} // namespace


std::vector<fs::path> includedFiles
(
    const fs::path& file,
    const std::string& text
)
{
    std::vector<fs::path> all;
    collect(file, text, all);
    return all;
}

} // namespace gpuFsi
