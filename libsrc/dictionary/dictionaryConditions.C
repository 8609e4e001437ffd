#include "dictionary/dictionaryParser.H"

#include "dictionary/number.H"

namespace gpuFsi
{

dictionaryParser::tokenList dictionaryParser::readLine
(
    tokenizer& in,
    const token& directive
)
{
    tokenList tokens;
    token t;
    while (in.next(t))
    {
        if (t.line != directive.line)
        {
            in.putBack(t);
            break;
        }
        if (isMacro(t))
        {
            const expansion found = expand(t);
            if (found.dict)
            {
                fail
                (
                    t.text + " is a dictionary, in a condition", t,
                    "Name one of its entries, as in ${sub.key}."
                );
            }
            tokens.insert
            (
                tokens.end(), found.tokens.begin(), found.tokens.end()
            );
        }
        else if (t.text == "#eval" || t.text == "#calc")
        {
            tokens.push_back(calculate(in, t));
        }
        else
        {
            tokens.push_back(t);
        }
    }
    return tokens;
}


bool dictionaryParser::condition(tokenizer& in, const token& directive)
{
    const tokenList line = readLine(in, directive);
    if (directive.text == "#ifeq")
    {
        if (line.size() != 2)
        {
            fail
            (
                "#ifeq is followed by '" + tokensText(line, 60) + '\'',
                directive,
                "It compares two words or numbers, as in #ifeq $model linear."
            );
        }
        return line[0].type == token::kind::number
            && line[1].type == token::kind::number
          ? line[0].number == line[1].number
          : line[0].text == line[1].text;
    }
    if (line.size() == 1)
    {
        if (line[0].type == token::kind::number)
        {
            return line[0].number != 0;
        }
        bool holds = false;
        if (readSwitch(line[0].text, holds))
        {
            return holds;
        }
    }
    fail
    (
        directive.text + " is followed by '" + tokensText(line, 60) + '\'',
        directive,
        "It takes one switch or number, as in #if $withSolid or"
        " #if #eval{ $n > 2 }."
    );
}


void dictionaryParser::skipBranch
(
    tokenizer& in,
    bool lookForElse,
    tokenList& ifs
)
{
    std::size_t nested = 0;
    token t;
    while (in.next(t))
    {
        if (t.text == "#eval" || t.text == "#calc")
        {
            in.code(t);
        }
        else if (!isDirective(t))
        {
            continue;
        }
        else if (t.text == "#if" || t.text == "#ifeq")
        {
            ++nested;
        }
        else if (t.text == "#endif" && nested-- == 0)
        {
            ifs.pop_back();
            return;
        }
        else if (nested == 0 && lookForElse && t.text == "#else")
        {
            return;
        }
        else if (nested == 0 && lookForElse && t.text == "#elif")
        {
            if (condition(in, t))
            {
                return;
            }
        }
    }
    fail
    (
        ifs.back().text + " is not closed", ifs.back(), "Close it with #endif."
    );
}


bool dictionaryParser::readIf
(
    tokenizer& in,
    const token& directive,
    tokenList& ifs
)
{
    if (directive.text == "#if" || directive.text == "#ifeq")
    {
        const bool holds = condition(in, directive);
        ifs.push_back(directive);
        if (!holds)
        {
            skipBranch(in, true, ifs);
        }
        return true;
    }
    if (directive.text != "#else" && directive.text != "#elif"
     && directive.text != "#endif")
    {
        return false;
    }
    if (ifs.empty())
    {
        fail
        (
            directive.text + " without an #if in this dictionary", directive,
            "Remove it, or begin with #if."
        );
    }
    if (directive.text == "#endif")
    {
        ifs.pop_back();
    }
    else
    {
        // This branch was taken; the others are not
        skipBranch(in, false, ifs);
    }
    return true;
}

} // namespace gpuFsi
