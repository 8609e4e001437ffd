#include "study/entryEdit.H"

#include "case/caseFileIO.H"
#include "dictionary/entry.H"
#include "study/entryText.H"

#include <algorithm>
#include <optional>

namespace gpuFsi
{

namespace fs = std::filesystem;

namespace
{

//- Line, from 1, at which this file gives the entry; 0: elsewhere, nowhere
int lineOf(const fs::path& file, const entryAddress& address)
{
    const dictionary top = dictionary::fromFile(file);
    const dictionary* scope = &top;
    for (std::size_t i = 0; i + 1 < address.keys.size(); ++i)
    {
        const std::string& key = address.keys[i];
        if (!scope->isDict(key))
        {
            return 0;
        }
        const auto known = scope->keys();
        if (std::find(known.begin(), known.end(), key) == known.end())
        {
            throw userError
            (
                "The dictionary " + key + " is given by a pattern: to set '"
              + address.keys.back() + "' in it would change others as well, "
                "or hide the rest of it",
                scope->where(key), "Write " + key + " { .. } out."
            );
        }
        scope = &scope->subDict(key);
    }
    const std::string& key = address.keys.back();
    if (!scope->found(key) || scope->isDict(key))
    {
        return 0;
    }
    const sourceSpan where = scope->where(key);
    return where.file == file.string() ? where.first : 0;
}


//- The text with the value in place. Entries that a macro brings have the line
//  of their origin, where the address does not stand.
std::optional<std::string> replaced
(
    const std::string& text,
    int line,
    const entryAddress& address,
    const std::string& valueText
)
{
    std::optional<std::string> changed;
    for (const entryPlace& p : placesOf(text, address.keys))
    {
        if (p.line == line)
        {
            changed =
                text.substr(0, p.value) + ' ' + valueText + text.substr(p.end);
        }
    }
    return changed;
}


//- Does the file give this value now? One of macros is not looked into.
bool hasTaken
(
    const fs::path& file,
    const entryAddress& address,
    const std::string& valueText
)
{
    const dictionary top = dictionary::fromFile(file);
    if (valueText.find_first_of("$#{") != std::string::npos)
    {
        return true;
    }
    const dictionary* scope = &top;
    for (std::size_t i = 0; i + 1 < address.keys.size(); ++i)
    {
        scope = &scope->subDict(address.keys[i]);
    }
    const dictionary wanted =
        dictionary::fromString("value " + valueText + ";");
    const std::string& key = address.keys.back();
    return !scope->isDict(key) && tokensText(scope->tokens(key))
     == tokensText(wanted.tokens("value"));
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
    const std::optional<std::string> changed =
        replaced(text, lineOf(file, address), address, valueText);
    if (changed)
    {
        writeTextFile(file, *changed);
        if (hasTaken(file, address, valueText))
        {
            return;
        }
    }
    writeTextFile(file, text + '\n' + address.assignment(valueText));
    if (!hasTaken(file, address, valueText))
    {
        throw userError
        (
            "'" + address.keys.back() + "' does not take the value "
          + valueText, {file.string()},
            "Does #inputMode keep what was given first?"
        );
    }
}

} // namespace gpuFsi
