#include "study/entryEdit.H"

#include "case/caseFileIO.H"

#include <algorithm>
#include <optional>

namespace gpuFsi
{

namespace fs = std::filesystem;

namespace
{

//- Line, from 1, at which this file itself gives the entry; 0: nowhere
int lineOf(const fs::path& file, const entryAddress& address)
{
    const dictionary top = dictionary::fromFile(file);
    const dictionary* scope = &top;
    for (std::size_t i = 0; i + 1 < address.keys.size(); ++i)
    {
        if (!scope->isDict(address.keys[i]))
        {
            return 0;
        }
        scope = &scope->subDict(address.keys[i]);
    }
    const std::string& key = address.keys.back();
    if (!scope->found(key) || scope->isDict(key))
    {
        return 0;
    }
    const sourceSpan where = scope->where(key);
    return where.file == file.string() ? where.first : 0;
}


//- Where the word stands in a line; npos unless it stands there once
std::size_t wordIn
(
    const std::string& text,
    std::size_t line,
    const std::string& word
)
{
    const std::size_t end = std::min(text.find('\n', line), text.size());
    std::size_t found = text.npos;
    for (std::size_t at = text.find(word, line); at < end;
        at = text.find(word, at + 1))
    {
        const std::string before = at > line ? text.substr(at - 1, 1) : " ";
        const std::string after = text.substr(at + word.size(), 1);
        if (before.find_first_of(" \t{;") == 0
         && after.find_first_of(" \t\n") == 0)
        {
            if (found != text.npos)
            {
                return text.npos;
            }
            found = at;
        }
    }
    return found;
}


//- The semicolon that ends an entry whose value begins at `at`, or npos
std::size_t endOfValue(const std::string& text, std::size_t at)
{
    int depth = 0;
    for (; at < text.size(); ++at)
    {
        const char c = text[at];
        if (c == '"')
        {
            for (++at; at < text.size() && text[at] != '"'; ++at)
            {
                at += text[at] == '\\';
            }
        }
        else if (text.compare(at, 2, "//") == 0)
        {
            at = std::min(text.find('\n', at), text.size());
        }
        else if (text.compare(at, 2, "/*") == 0)
        {
            at = std::min(text.find("*/", at), text.size()) + 1;
        }
        else if (c == ';' && depth == 0)
        {
            return at;
        }
        depth += (c == '{') - (c == '}');
    }
    return text.npos;
}


//- The text with the value in place, if the entry is found in that line
std::optional<std::string> replaced
(
    const std::string& text,
    int line,
    const std::string& key,
    const std::string& valueText
)
{
    std::size_t begin = 0;
    for (int i = 1; i < line && begin != text.npos; ++i)
    {
        begin = text.find('\n', begin);
        begin += begin != text.npos;
    }
    const std::size_t at =
        begin < text.size() ? wordIn(text, begin, key) : text.npos;
    const std::size_t end =
        at == text.npos ? at : endOfValue(text, at + key.size());
    if (end == text.npos)
    {
        return {};
    }
    return text.substr(0, at + key.size()) + ' ' + valueText
      + text.substr(end);
}

} // namespace


void setEntry
(
    const fs::path& file,
    const entryAddress& address,
    const std::string& valueText
)
{
    const std::string text = readCaseFile(file);
    const int line = lineOf(file, address);
    std::optional<std::string> changed;
    if (line > 0)
    {
        changed = replaced(text, line, address.keys.back(), valueText);
    }
    writeTextFile
    (
        file,
        changed ? *changed : text + '\n' + address.assignment(valueText)
    );
    dictionary::fromFile(file);
}

} // namespace gpuFsi
