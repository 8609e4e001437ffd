#include "dictionary/dictionaryParser.H"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>

namespace gpuFsi
{

namespace fs = std::filesystem;


void dictionaryParser::readDirective(tokenizer& in, const token& directive)
{
    const std::string& word = directive.text;
    if (word == "#include" || word == "#includeEtc"
     || word == "#includeIfPresent" || word == "#sinclude")
    {
        include(in, directive, nullptr);
    }
    else if (word == "#includeFunc")
    {
        includeFunc(in, directive);
    }
    else if (word == "#inputMode")
    {
        setInputMode(in, directive);
    }
    else if (word == "#remove")
    {
        remove(in, directive);
    }
    else if (word == "#eval" || word == "#calc")
    {
        fail
        (
            word + " stands where a key belongs", directive,
            "Use it as a value, as in key " + word + "{1 + 2};"
        );
    }
    else if (word == "#codeStream")
    {
        fail
        (
            "#codeStream is not supported: code in a dictionary is not run",
            directive,
            "Use #eval{..} for arithmetic."
        );
    }
    else
    {
        fail
        (
            unknownChoice
            (
                "directive", word,
                {
                    "#include", "#includeIfPresent", "#sinclude",
                    "#includeEtc", "#includeFunc", "#inputMode", "#remove",
                    "#if", "#ifeq", "#elif", "#else", "#endif", "#eval",
                    "#calc"
                }
            ),
            directive, {}
        );
    }
}


void dictionaryParser::setInputMode(tokenizer& in, const token& directive)
{
    static const std::pair<const char*, inputMode> modes[] =
    {
        {"merge", inputMode::merge},
        {"default", inputMode::merge},
        {"overwrite", inputMode::overwrite},
        {"protect", inputMode::protect},
        {"warn", inputMode::warn},
        {"error", inputMode::error}
    };
    token t;
    const std::string found = in.next(t) ? t.text : "";
    std::vector<std::string> valid;
    for (const auto& [word, mode] : modes)
    {
        if (found == word)
        {
            mode_ = mode;
            return;
        }
        valid.push_back(word);
    }
    fail(unknownChoice("inputMode", found, valid), directive, {});
}


void dictionaryParser::remove(tokenizer& in, const token& directive)
{
    tokenList keys;
    token t;
    bool list = in.next(t) && t.is('(');
    if (!list)
    {
        keys.push_back(t);
    }
    while (list && in.next(t) && !t.is(')'))
    {
        keys.push_back(t);
    }
    auto& entries = scopes_.back()->entries_;
    for (const token& key : keys)
    {
        if (key.type != token::kind::word && key.type != token::kind::string)
        {
            fail
            (
                "#remove is followed by '" + key.text + '\'', directive,
                "Give a key, a \"pattern\" or a list of them in parentheses."
            );
        }
        std::shared_ptr<keyPattern> pattern;
        if (key.type == token::kind::string)
        {
            pattern = std::make_shared<keyPattern>
            (
                key.text, sourceSpan{key.file, key.line, key.line}
            );
        }
        const auto goes = [&](const std::shared_ptr<entry>& e)
        {
            return e->key == key.text || (pattern && pattern->matches(e->key));
        };
        entries.erase
        (
            std::remove_if(entries.begin(), entries.end(), goes),
            entries.end()
        );
    }
}


fs::path dictionaryParser::findEtc(const fs::path& name)
{
    std::vector<fs::path> places;
    if (const char* etc = std::getenv("FSI_ETC"))
    {
        places.push_back(etc);
    }

    // Beside bin of an install, or above it in a build directory
    std::error_code ignored;
    fs::path up = fs::read_symlink("/proc/self/exe", ignored).parent_path();
    for (int level = 0; level < 5 && up.has_relative_path(); ++level)
    {
        places.push_back(up/"etc");
        up = up.parent_path();
    }
    for (const fs::path& place : places)
    {
        if (fs::is_regular_file(place/name, ignored))
        {
            return place/name;
        }
    }
    return {};
}


void dictionaryParser::include
(
    tokenizer& in,
    const token& directive,
    tokenList* into
)
{
    token t;
    if (!in.next(t) || t.line != directive.line
     || (t.type != token::kind::string && t.type != token::kind::word))
    {
        fail
        (
            directive.text + " is not followed by a file name", directive,
            "Write " + directive.text + " \"file\"."
        );
    }
    const fs::path name = expandText(t, false);
    const bool etc = directive.text == "#includeEtc"
        || name.string().compare(0, 6, "<etc>/") == 0;
    fs::path file;
    std::error_code ignored;
    if (etc)
    {
        file = findEtc
        (
            directive.text == "#includeEtc" ? name
          : fs::path(name.string().substr(6))
        );
    }
    else
    {
        file = (fs::path(in.file()).parent_path()/name).lexically_normal();
        if (!fs::is_regular_file(file, ignored))
        {
            file.clear();
        }
    }
    if (!file.empty())
    {
        readFile(file, directive, into);
    }
    else if (directive.text != "#includeIfPresent"
     && directive.text != "#sinclude")
    {
        fail
        (
            directive.text + " file \"" + name.string() + "\" is not found",
            directive,
            etc
          ? "It is looked for in $FSI_ETC and in the etc directory of the"
            " installation."
          : "It is looked for beside the file that includes it;"
            " #includeIfPresent allows it to be absent."
        );
    }
}


void dictionaryParser::includeFunc(tokenizer& in, const token& directive)
{
    token t;
    if (!in.next(t) || (t.type != token::kind::string
     && t.type != token::kind::word)
     || t.text.find('(') != std::string::npos)
    {
        fail
        (
            "#includeFunc '" + t.text + "' is not a plain name", directive,
            "Arguments in parentheses are not supported: write the function"
            " object as a sub-dictionary."
        );
    }
    const std::string name = expandText(t, false);
    const fs::path beside = fs::path(in.file()).parent_path();
    std::error_code ignored;
    fs::path file;
    for (const fs::path& place : {beside, beside.parent_path()/"system"})
    {
        if (file.empty() && fs::is_regular_file(place/name, ignored))
        {
            file = place/name;
        }
    }
    if (file.empty())
    {
        file = findEtc(fs::path("caseDicts")/name);
    }
    if (file.empty())
    {
        fail
        (
            "#includeFunc \"" + name + "\" is not found", directive,
            "It is looked for in system and in etc/caseDicts."
        );
    }

    auto e = std::make_shared<entry>();
    e->key = name;
    e->where = {directive.file, directive.line, directive.line};
    dictionary& parent = *scopes_.back();
    dictionary contents(parent.name_ + ':' + name, e->where);
    scopes_.push_back(&contents);
    readFile(file, directive, nullptr);
    scopes_.pop_back();

    // The file may hold the entries, or a dictionary of that name with them
    const entry* inner = contents.literal(name);
    e->dict = std::make_unique<dictionary>
    (
        (inner && inner->dict ? *inner->dict : contents).clone(contents.name_)
    );
    insert(parent, e);
}


void dictionaryParser::readFile
(
    const fs::path& file,
    const token& from,
    tokenList* into
)
{
    const sourceSpan asked = from.file.empty()
        ? sourceSpan{file.string(), 0, 0}
        : sourceSpan{from.file, from.line, from.line};
    std::error_code ignored;
    const fs::path same = fs::weakly_canonical(file, ignored);
    if (std::find(files_.begin(), files_.end(), same) != files_.end())
    {
        throw userError
        (
            "File \"" + file.string() + "\" includes itself", asked,
            "Remove one of the #include lines that lead in a circle."
        );
    }
    std::ifstream stream(file, std::ios::binary);
    if (!stream || !fs::is_regular_file(file, ignored))
    {
        throw userError
        (
            "Cannot read the file \"" + file.string() + '"', asked,
            "Does it exist, and may you read it? Is the case directory right?"
        );
    }
    const std::string text
    {
        std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()
    };
    files_.push_back(same);
    if (into)
    {
        entry value;
        value.key = "#include";
        value.where = asked;
        tokenizer in(text + "\n;", file.string());
        const tokenList tokens = readValue(in, value);
        token more;
        if (value.dict || in.next(more))
        {
            throw userError
            (
                "File \"" + file.string() + "\" does not hold plain values",
                asked,
                "Within a value, an included file has no keys and no ';'."
            );
        }
        into->insert(into->end(), tokens.begin(), tokens.end());
    }
    else
    {
        tokenizer in(text, file.string());
        readBody(in, nullptr);
    }
    files_.pop_back();
}

} // namespace gpuFsi
