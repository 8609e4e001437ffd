#include "study/entryText.H"

#include <algorithm>

namespace gpuFsi
{

namespace
{

class scanner
{
public:

    scanner(const std::string& text, const std::vector<std::string>& keys)
    :
        text_(text),
        keys_(keys)
    {}

    std::vector<entryPlace> places()
    {
        body(0);
        return std::move(found_);
    }

private:

    static constexpr std::size_t elsewhere = std::string::npos;

    bool at(const char* word) const
    {
        return text_.compare(at_, std::string(word).size(), word) == 0;
    }

    //- Behind the next `end`
    void skipTo(const char* end)
    {
        const std::size_t found = text_.find(end, at_);
        at_ = found == text_.npos
          ? text_.size() : found + std::string(end).size();
    }

    void skipString()
    {
        for (++at_; at_ < text_.size() && text_[at_] != '"'; ++at_)
        {
            at_ += text_[at_] == '\\';
        }
        ++at_;
    }

    //- A comment, string or text between #{ and #}, or one character
    void skipPiece()
    {
        if (at("//"))
        {
            skipTo("\n");
        }
        else if (at("/*"))
        {
            at_ += 2;
            skipTo("*/");
        }
        else if (at("#{"))
        {
            skipTo("#}");
        }
        else if (text_[at_] == '"')
        {
            skipString();
        }
        else
        {
            ++at_;
        }
    }

    void skipBlanks()
    {
        while (at_ < text_.size() && (at("//") || at("/*")
         || std::string(" \t\r\n;").find(text_[at_]) != std::string::npos))
        {
            skipPiece();
        }
    }

    //- To the semicolon, or past the end of the text
    void skipValue()
    {
        int depth = 0;
        while (at_ < text_.size() && !(text_[at_] == ';' && depth == 0))
        {
            depth += (text_[at_] == '{') - (text_[at_] == '}');
            skipPiece();
        }
    }

    //- Empty for a pattern
    std::string key()
    {
        if (text_[at_] == '"')
        {
            skipString();
            return {};
        }
        const std::size_t begin = at_;
        if (at("${"))
        {
            skipTo("}");
        }
        at_ = std::min(text_.find_first_of(" \t\r\n;{}\"", at_), text_.size());
        return text_.substr(begin, at_ - begin);
    }

    //- Entries up to the closing brace; level: of keys_ that they may be
    void body(std::size_t level)
    {
        skipBlanks();
        while (at_ < text_.size() && text_[at_] != '}')
        {
            if (text_[at_] == '#')
            {
                skipTo("\n");
            }
            else if (text_[at_] == '{')
            {
                ++at_;
                body(elsewhere);
            }
            else
            {
                oneEntry(level);
            }
            skipBlanks();
        }
        ++at_;
    }

    void oneEntry(std::size_t level)
    {
        const std::size_t begin = at_;
        const std::string name = key();
        const bool ours = level != elsewhere && name == keys_[level];
        const bool last = ours && level + 1 == keys_.size();
        const std::size_t value = at_;
        skipBlanks();
        if (at_ < text_.size() && text_[at_] == '{')
        {
            ++at_;
            body(ours && !last ? level + 1 : elsewhere);
            return;
        }
        at_ = value;
        skipValue();
        if (last && at_ < text_.size())
        {
            found_.push_back({lineAt(begin), value, at_});
        }
    }

    int lineAt(std::size_t i) const
    {
        return 1 + int(std::count(text_.begin(), text_.begin() + i, '\n'));
    }

    const std::string& text_;
    const std::vector<std::string>& keys_;
    std::size_t at_ = 0;
    std::vector<entryPlace> found_;
};

} // namespace


std::vector<entryPlace> placesOf
(
    const std::string& text,
    const std::vector<std::string>& keys
)
{
    return scanner(text, keys).places();
}

} // namespace gpuFsi
