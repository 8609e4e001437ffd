#include "dictionary/tokenizer.H"

#include "dictionary/number.H"

#include <cctype>
#include <cstring>

namespace gpuFsi
{

static bool isBlank(char c)
{
    return c == ' ' || (c >= '\t' && c <= '\r');
}


static bool isPunctuation(char c)
{
    return c != '\0' && std::strchr("{}()[];,:=/", c);
}


static bool endsWord(char c)
{
    const unsigned char u = static_cast<unsigned char>(c);
    return u <= ' ' || u == 127 || std::strchr("\"'/;{}[]$", c);
}


tokenizer::tokenizer(std::string text, std::string file)
:
    text_(std::move(text)),
    file_(std::move(file))
{
    // Some editors begin a file with a byte order mark
    if (text_.compare(0, 3, "\xEF\xBB\xBF") == 0)
    {
        at_ = 3;
    }
}


char tokenizer::peek(std::size_t ahead) const
{
    return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0';
}


char tokenizer::take()
{
    const char c = text_[at_++];
    line_ += c == '\n';
    return c;
}


void tokenizer::fail
(
    const std::string& message,
    int line,
    const std::string& remedy
) const
{
    throw userError(message, {file_, line, line}, remedy);
}


token tokenizer::begin(token::kind type) const
{
    token t;
    t.type = type;
    t.line = line_;
    t.file = file_;
    return t;
}


void tokenizer::skipBlanks()
{
    while (at_ < text_.size())
    {
        if (isBlank(peek()))
        {
            take();
        }
        else if (peek() == '/' && peek(1) == '/')
        {
            while (at_ < text_.size() && peek() != '\n')
            {
                take();
            }
        }
        else if (peek() == '/' && peek(1) == '*')
        {
            const int opened = line_;
            const std::size_t end = text_.find("*/", at_ + 2);
            if (end == std::string::npos)
            {
                fail("Comment /* is not closed", opened, "Close it with */.");
            }
            while (at_ < end + 2)
            {
                take();
            }
        }
        else
        {
            return;
        }
    }
}


void tokenizer::putBack(const token& t)
{
    pending_.push_back(t);
}


bool tokenizer::next(token& t)
{
    if (!pending_.empty())
    {
        t = pending_.back();
        pending_.pop_back();
        return true;
    }
    skipBlanks();
    if (at_ >= text_.size())
    {
        return false;
    }
    const char c = peek();
    if (c == '"')
    {
        t = quoted();
    }
    else if (c == '#' && peek(1) == '{')
    {
        t = verbatim();
    }
    else if (c == '$')
    {
        t = macro();
    }
    else if (isPunctuation(c))
    {
        t = begin(token::kind::punctuation);
        t.text = take();
    }
    else
    {
        t = wordOrNumber();
    }
    return true;
}


token tokenizer::quoted()
{
    token t = begin(token::kind::string);
    take();
    bool escaped = false;
    while (at_ < text_.size())
    {
        const char c = take();
        if (c == '"' && !escaped)
        {
            return t;
        }
        if (escaped && (c == '"' || c == '\n'))
        {
            t.text.pop_back();
        }
        else if (c == '\n')
        {
            break;
        }
        if (c != '\n')
        {
            t.text += c;
        }
        escaped = c == '\\' && !escaped;
    }
    fail
    (
        "String \"" + t.text.substr(0, 40) + " is not closed",
        t.line,
        "Close it with \" on the same line, or end the line with \\."
    );
}


token tokenizer::verbatim()
{
    token t = begin(token::kind::verbatim);
    const std::size_t end = text_.find("#}", at_ + 2);
    if (end == std::string::npos)
    {
        fail("Verbatim text #{ is not closed", t.line, "Close it with #}.");
    }
    t.text = text_.substr(at_ + 2, end - at_ - 2);
    while (at_ < end + 2)
    {
        take();
    }
    return t;
}


token tokenizer::macro()
{
    token t = begin(token::kind::word);
    t.text = take();
    if (peek() == '{')
    {
        int depth = 0;
        do
        {
            if (at_ >= text_.size() || peek() == '\n' || peek() == ';')
            {
                fail
                (
                    "Macro " + t.text + " is not closed",
                    t.line,
                    "Close it with }, as in ${name}."
                );
            }
            t.text += take();
            depth += t.text.back() == '{';
            depth -= t.text.back() == '}';
        }
        while (depth > 0);
        return t;
    }
    while
    (
        std::isalnum(static_cast<unsigned char>(peek()))
     || (peek() != '\0' && std::strchr("_.:!^-", peek()))
     || (peek() == '/' && peek(1) != '/' && peek(1) != '*')
    )
    {
        t.text += take();
    }
    if (t.text.size() == 1)
    {
        fail
        (
            "A $ stands alone",
            t.line,
            "Write $name or ${name} to use the entry 'name'."
        );
    }
    return t;
}


token tokenizer::wordOrNumber()
{
    token t = begin(token::kind::word);
    const sourceSpan here{file_, line_, line_};
    int depth = 0;
    while (at_ < text_.size() && !endsWord(peek()))
    {
        const char c = peek();
        if (c == ')' && depth == 0)
        {
            break;
        }
        if (c == '(' && depth == 0 && readNumber(t.text, t.number, here))
        {
            break;
        }
        depth += c == '(';
        depth -= c == ')';
        t.text += take();
    }
    if (t.text.empty())
    {
        const unsigned char c = static_cast<unsigned char>(peek());
        const std::string shown =
            std::isprint(c) ? std::string(1, c) : std::to_string(int(c));
        fail
        (
            std::isprint(c)
          ? "Character " + shown + " cannot stand here"
          : "Character code " + shown + " is not text",
            line_,
            c == '\'' ? "Strings take double quotes: \"text\"."
          : "Remove it; is this a binary file?"
        );
    }
    if (depth > 0)
    {
        fail
        (
            "Word " + t.text + " has an unclosed parenthesis",
            t.line,
            "A word holds no spaces; put a space before '(' to begin a list."
        );
    }
    if (readNumber(t.text, t.number, here))
    {
        t.type = token::kind::number;
    }
    return t;
}


token tokenizer::code(const token& directive)
{
    skipBlanks();
    if (peek() == '"')
    {
        return quoted();
    }
    if (peek() == '#' && peek(1) == '{')
    {
        return verbatim();
    }
    token t = begin(token::kind::verbatim);
    if (peek() != '{')
    {
        fail
        (
            directive.text + " is not followed by an expression",
            directive.line,
            "Write " + directive.text + "{2*$x} or "
                + directive.text + " \"2*$x\"."
        );
    }
    take();
    for (int depth = 1; at_ < text_.size();)
    {
        const char c = take();
        depth += c == '{';
        depth -= c == '}';
        if (depth == 0)
        {
            return t;
        }
        t.text += c;
    }
    fail
    (
        "Expression of " + directive.text + " is not closed",
        t.line,
        "Close it with }."
    );
}

} // namespace gpuFsi
