#include "dictionary/dictionary.H"

#include "base/log.H"
#include "dictionary/entry.H"

namespace gpuFsi
{

std::string tokensText(const std::vector<token>& tokens, std::size_t limit)
{
    std::string text;
    bool tight = true;
    for (const token& t : tokens)
    {
        const bool closes = t.is(')') || t.is(']') || t.is('}') || t.is(';');
        if (!tight && !closes)
        {
            text += ' ';
        }
        tight = t.is('(') || t.is('[');
        if (t.type == token::kind::verbatim)
        {
            text += "#{" + t.text + "#}";
        }
        else if (t.type == token::kind::string)
        {
            text += '"';
            for (const char c : t.text)
            {
                text += c == '"' ? "\\\"" : std::string(1, c);
            }
            text += '"';
        }
        else
        {
            text += t.text;
        }
        if (text.size() > limit)
        {
            return text.substr(0, limit) + "...";
        }
    }
    return text;
}


std::string dictionary::toText(int indent) const
{
    const std::string margin(indent, ' ');
    std::string text;
    for (const auto& e : entries_)
    {
        token key;
        key.type = e->pattern ? token::kind::string : token::kind::word;
        key.text = e->key;
        text += margin + tokensText({key});
        if (e->dict)
        {
            text += '\n' + margin + "{\n" + e->dict->toText(indent + 4)
                + margin + "}\n";
            continue;
        }
        if (!e->tokens.empty())
        {
            const std::size_t column = key.text.size() + 1;
            text += std::string(column < 16 ? 16 - column : 1, ' ')
                + tokensText(e->tokens);
        }
        text += ";\n";
    }
    return text;
}


std::vector<std::string> dictionary::unread() const
{
    // A key that is missing is more likely meant than one that is there too
    std::vector<std::string> absent, present;
    for (const std::string& key : *askedFor_)
    {
        (literal(key) ? present : absent).push_back(key);
    }

    std::vector<std::string> list;
    for (const auto& e : entries_)
    {
        if (e->key == "FoamFile")
        {
            continue;
        }
        if (e->read)
        {
            if (e->dict)
            {
                for (const std::string& sentence : e->dict->unread())
                {
                    list.push_back(sentence);
                }
            }
            continue;
        }
        std::string text = e->dict ? "Unused sub-dictionary '"
            : "Unused entry '";
        text += e->key + "' in \"" + name_ + '"';
        if (e->where.first > 0)
        {
            text += " at line " + std::to_string(e->where.first);
            if (name_.compare(0, e->where.file.size(), e->where.file) != 0)
            {
                text += " of \"" + e->where.file + '"';
            }
        }
        std::string near = nearestWord(e->key, absent);
        if (near.empty())
        {
            near = nearestWord(e->key, present);
        }
        if (near == e->key)
        {
            near.clear();
        }
        list.push_back
        (
            text + (near.empty() ? "." : ": is '" + near + "' meant?")
        );
    }
    return list;
}


void dictionary::warnUnread() const
{
    for (const std::string& sentence : unread())
    {
        warning(sentence);
    }
}

} // namespace gpuFsi
