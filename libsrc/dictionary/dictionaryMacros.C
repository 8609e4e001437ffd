#include "dictionary/dictionaryParser.H"

#include "dictionary/expression.H"
#include "dictionary/number.H"

#include <algorithm>
#include <cctype>
#include <cstdlib>

namespace gpuFsi
{

//- More than this many tokens out of macros is taken for a runaway
static constexpr std::size_t maxExpanded = 1000000;


void dictionaryParser::countExpansion(std::size_t n, const token& macro)
{
    nExpanded_ += n;
    if (nExpanded_ > maxExpanded)
    {
        fail
        (
            "Macros have grown to more than "
                + std::to_string(maxExpanded) + " tokens",
            macro,
            "Do macros multiply each other?"
        );
    }
}


const entry* dictionaryParser::descend
(
    const dictionary& from,
    const std::string& name,
    char separator
)
{
    if (entry* e = from.literal(name))
    {
        e->read = true;
        return e;
    }

    // A key may hold dots itself: try every place to split
    for
    (
        std::size_t i = name.find(separator);
        i != std::string::npos;
        i = name.find(separator, i + 1)
    )
    {
        entry* sub = from.literal(name.substr(0, i));
        if (sub && sub->dict)
        {
            const entry* e =
                descend(*sub->dict, name.substr(i + 1), separator);
            if (e)
            {
                sub->read = true;
                return e;
            }
        }
    }
    return nullptr;
}


const entry* dictionaryParser::lookupFrom
(
    std::size_t depth,
    const std::string& name,
    bool outwards
) const
{
    const char separator = name.find('/') == std::string::npos ? '.' : '/';
    for (std::size_t i = depth + 1; i-- > 0;)
    {
        if (const entry* e = descend(*scopes_[i], name, separator))
        {
            return e;
        }
        if (!outwards)
        {
            break;
        }
    }
    return nullptr;
}


const entry* dictionaryParser::lookup(const std::string& name) const
{
    const std::size_t here = scopes_.size() - 1;
    if (name.find_first_of(":^!") == 0)
    {
        return lookupFrom(0, name.substr(1), false);
    }

    // .org: ../key    .com: .key here, ..key parent, ...key grandparent
    std::size_t up = 0, at = 0;
    while (name.compare(at, 3, "../") == 0)
    {
        ++up;
        at += 3;
    }
    if (at == 0)
    {
        at = std::min(name.find_first_not_of('.'), name.size());
        up = at > 0 ? at - 1 : 0;
    }
    if (up > here)
    {
        return nullptr;
    }
    return lookupFrom(here - up, name.substr(at), at == 0);
}


dictionaryParser::expansion dictionaryParser::expand
(
    const token& macro,
    const std::string& key
)
{
    std::string name = macro.text.substr(1), otherwise;
    bool hasDefault = false;
    if (name[0] == '{')
    {
        name = name.substr(1, name.size() - 2);
        const std::size_t colon = name.find(":-");
        if (colon != std::string::npos && colon > 0)
        {
            hasDefault = true;
            otherwise = name.substr(colon + 2);
            name.erase(colon);
        }
    }

    expansion result;
    if (const entry* e = lookup(name))
    {
        if (e->dict)
        {
            for (const dictionary* open : scopes_)
            {
                if (open == e->dict.get())
                {
                    fail
                    (
                        macro.text + " stands inside the dictionary that it"
                            " names",
                        macro,
                        "Move the common entries into a dictionary of their"
                        " own."
                    );
                }
            }
            countExpansion(e->dict->markAllRead(), macro);
            result.dict = e->dict.get();
            return result;
        }
        result.tokens = e->tokens;
    }
    else
    {
        const char* variable = std::getenv(name.c_str());
        if (!variable && !hasDefault)
        {
            std::vector<std::string> known;
            for (const dictionary* scope : scopes_)
            {
                for (const std::string& k : scope->keys())
                {
                    known.push_back(k);
                }
            }
            const std::string near = nearestWord(name, known);
            fail
            (
                name == key && !key.empty()
              ? "Entry '" + key + "' is given by itself, " + macro.text
              : "Macro " + macro.text + " names nothing that was read before"
                " it, nor an environment variable",
                macro,
                near.empty() || near == key
              ? "Define '" + name + "' above this line, or give a default,"
                " as in ${" + name + ":-1}."
              : "Is $" + near + " meant?"
            );
        }
        const std::string text = variable ? variable : otherwise;
        token t;
        const bool plain = !text.empty()
            && text.find_first_of(" \t\r\n\"'/;{}[]()$#,:=")
                == std::string::npos;
        t.type = plain ? token::kind::word : token::kind::string;
        t.text = text;
        if (plain && readNumber(text, t.number,
            {macro.file, macro.line, macro.line}))
        {
            t.type = token::kind::number;
        }
        result.tokens.push_back(t);
    }
    countExpansion(result.tokens.size(), macro);
    for (token& t : result.tokens)
    {
        t.line = macro.line;
        t.file = macro.file;
    }
    return result;
}


std::string dictionaryParser::expandText(const token& t, bool arithmetic)
{
    const std::string& text = t.text;
    const auto isName = [&](std::size_t i)
    {
        return i < text.size()
            && (std::isalnum(static_cast<unsigned char>(text[i]))
             || text[i] == '_');
    };

    std::string result;
    for (std::size_t i = 0; i < text.size();)
    {
        if (text[i] != '$')
        {
            result += text[i++];
            continue;
        }
        token macro = t;
        macro.type = token::kind::word;
        std::size_t end = i + 1;
        if (end < text.size() && text[end] == '{')
        {
            end = text.find('}', end);
            end = end == std::string::npos ? text.size() : end + 1;
        }
        else
        {
            // Dots and a colon belong to it only in front of a name
            while (end < text.size() && (isName(end) || text[end] == '.'
             || (end == i + 1 && std::string(":^!").find(text[end])
                 != std::string::npos)))
            {
                ++end;
            }
            while (!isName(end - 1) && end > i + 1)
            {
                --end;
            }
        }
        macro.text = text.substr(i, end - i);
        if (macro.text.size() < 2 || (macro.text[1] == '{'
         && (macro.text.back() != '}' || macro.text.size() < 4)))
        {
            fail
            (
                "A $ in '" + text + "' names nothing", t,
                "Write $name or ${name}."
            );
        }
        const expansion found = expand(macro);
        if (found.dict)
        {
            fail
            (
                macro.text + " is a dictionary; text or a number belongs"
                " here",
                t,
                "Name one of its entries, as in ${sub.key}."
            );
        }
        for (std::size_t j = 0; j < found.tokens.size(); ++j)
        {
            const token& value = found.tokens[j];
            const bool negative = arithmetic && value.number < 0;
            result += (j ? " " : "") + std::string(negative ? "(" : "")
                + value.text + (negative ? ")" : "");
        }
        i = end;
    }
    return result;
}


token dictionaryParser::calculate(tokenizer& in, const token& directive)
{
    token code = in.code(directive);
    code.line = directive.line;
    token t;
    t.type = token::kind::number;
    t.line = directive.line;
    t.file = directive.file;
    t.number = evaluate
    (
        expandText(code, true),
        {directive.file, directive.line, std::max(in.line(), directive.line)}
    );
    t.text = numberText(t.number);
    return t;
}

} // namespace gpuFsi
