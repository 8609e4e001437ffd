#include "dictionary/dictionaryParser.H"

#include <algorithm>

namespace gpuFsi
{

void dictionaryParser::closeBracket
(
    tokenList& opens,
    const token& t,
    const entry& e
) const
{
    const char open = t.is(')') ? '(' : t.is(']') ? '[' : '{';
    if (opens.empty() || !opens.back().is(open))
    {
        fail
        (
            opens.empty()
          ? "A " + t.text + " in the entry '" + e.key + "' closes nothing"
          : "A " + t.text + " in the entry '" + e.key + "' meets the "
                + opens.back().text + " of line "
                + std::to_string(opens.back().line),
            t,
            "Check the brackets of this entry."
        );
    }
    opens.pop_back();
}


dictionaryParser::tokenList dictionaryParser::readValue
(
    tokenizer& in,
    entry& e
)
{
    tokenList tokens, opens;
    const auto missingSemicolon = [&](const std::string& before)
    {
        throw userError
        (
            "Entry '" + e.key + "' is not ended by ';' before " + before,
            e.where,
            "Put a ';' behind its value."
        );
    };

    token t;
    while (in.next(t))
    {
        if (t.is(';') && opens.empty())
        {
            e.where.last = std::max(t.line, e.where.first);
            return tokens;
        }
        if (t.is(';') && !opens.back().is('{'))
        {
            fail
            (
                "A " + opens.back().text + " in the entry '" + e.key
                    + "' is not closed before ';'",
                opens.back(),
                std::string("Close it with ")
                    + (opens.back().is('(') ? ")." : "].")
            );
        }
        const std::string place = "the " + t.text + " in line "
            + std::to_string(t.line);
        if (t.is('}') && opens.empty())
        {
            missingSemicolon(place);
        }
        if (t.is('{') && opens.empty() && (tokens.empty()
         || tokens.back().type != token::kind::number
         || tokens.back().line != t.line))
        {
            missingSemicolon(place);
        }
        if (t.is('(') || t.is('[') || t.is('{'))
        {
            opens.push_back(t);
        }
        else if (t.is(')') || t.is(']') || t.is('}'))
        {
            closeBracket(opens, t, e);
        }

        else if (t.type == token::kind::punctuation && !t.is(';')
         && (opens.empty() || !opens.back().is('[')))
        {
            fail
            (
                "A stray " + t.text + " in the value of '" + e.key + '\'', t,
                t.is('/') ? "A path stands in quotes: \"a/b\"."
              : "Values are separated by blanks only."
            );
        }

        if (isMacro(t))
        {
            const expansion found = expand(t, e.key);
            if (found.dict)
            {
                token end;
                if (!tokens.empty() || !in.next(end) || !end.is(';'))
                {
                    fail
                    (
                        t.text + " is a dictionary, in the midst of a value",
                        t,
                        "Use it alone, as in key " + t.text + ";"
                    );
                }
                e.dict = std::make_unique<dictionary>
                (
                    found.dict->clone(scopes_.back()->name_ + ':' + e.key)
                );
                return tokens;
            }
            tokens.insert
            (
                tokens.end(), found.tokens.begin(), found.tokens.end()
            );
        }
        else if (!isDirective(t))
        {
            tokens.push_back(t);
        }
        else if (t.text == "#eval" || t.text == "#calc")
        {
            tokens.push_back(calculate(in, t));
        }
        else if (t.text == "#include")
        {
            include(in, t, &tokens);
        }
        else
        {
            fail
            (
                t.text + " cannot stand in the value of '" + e.key + '\'',
                t,
                t.text == "#codeStream"
              ? "Code is not compiled or run here; #eval{..} does arithmetic."
              : "Is a ';' missing before it?"
            );
        }
    }
    if (!opens.empty())
    {
        fail
        (
            "A " + opens.back().text + " in the entry '" + e.key
                + "' is not closed",
            opens.back(),
            "Close it before the ';'."
        );
    }
    missingSemicolon("the end of the file");
    return tokens;
}

} // namespace gpuFsi
