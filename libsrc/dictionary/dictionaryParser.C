#include "dictionary/dictionaryParser.H"

#include "base/log.H"

namespace gpuFsi
{

static constexpr std::size_t maxDepth = 100;


void dictionaryParser::fail
(
    const std::string& message,
    const token& at,
    const std::string& remedy
)
{
    throw userError(message, {at.file, at.line, at.line}, remedy);
}


bool dictionaryParser::isDirective(const token& t)
{
    return t.type == token::kind::word && t.text[0] == '#';
}


bool dictionaryParser::isMacro(const token& t)
{
    return t.type == token::kind::word && t.text[0] == '$';
}


dictionary dictionaryParser::file(const std::filesystem::path& file)
{
    dictionary top(file.string(), {file.string(), 0, 0});
    dictionaryParser parser;
    parser.scopes_.push_back(&top);
    parser.readFile(file, token{}, nullptr);
    return top;
}


dictionary dictionaryParser::text
(
    const std::string& text,
    const std::string& name
)
{
    dictionary top(name, {name, 0, 0});
    dictionaryParser parser;
    parser.scopes_.push_back(&top);
    tokenizer in(text, name);
    parser.readBody(in, nullptr);
    return top;
}


std::shared_ptr<entry> dictionaryParser::value
(
    dictionary& scope,
    const std::string& key,
    const std::string& valueText
)
{
    dictionary inner(scope.name_);
    dictionaryParser parser;
    parser.scopes_ = {&scope, &inner};
    const std::size_t first = valueText.find_first_not_of(" \t\n");
    const bool isDict = first != std::string::npos && valueText[first] == '{';
    tokenizer in("value " + valueText + (isDict ? "" : ";"), scope.name_);
    parser.readBody(in, nullptr);
    if (inner.entries_.size() != 1)
    {
        throw userError
        (
            "'" + valueText + "' is not one value for the entry '" + key + "'",
            {scope.name_, 0, 0},
            "Give one value, or { .. } for a sub-dictionary."
        );
    }
    std::shared_ptr<entry> e = inner.entries_[0];
    e->key = key;
    e->where = {scope.name_, 0, 0};
    if (e->dict)
    {
        e->dict->name_ = scope.name_ + ':' + key;
    }
    return e;
}


void dictionaryParser::readBody(tokenizer& in, const token* open)
{
    tokenList ifs;
    token t;
    bool closed = false;
    while (!closed && in.next(t))
    {
        if (t.is('}'))
        {
            if (!open)
            {
                fail
                (
                    "A } closes nothing", t,
                    "Remove it, or add the { that it belongs to."
                );
            }
            closed = true;
        }
        else if (isDirective(t))
        {
            if (!readIf(in, t, ifs))
            {
                readDirective(in, t);
            }
        }
        else if (isMacro(t))
        {
            readSubstitution(in, t);
        }
        else if (t.type == token::kind::word || t.type == token::kind::string)
        {
            readEntry(in, t);
        }
        else if (!t.is(';'))
        {
            fail
            (
                "Found '" + tokensText({t}, 40) + "' where a key or } belongs",
                t,
                "Is there a stray character, a ';' too early, or a missing"
                " key?"
            );
        }
    }
    if (!ifs.empty())
    {
        fail
        (
            ifs.back().text + " is not closed", ifs.back(),
            "Close it with #endif in the same dictionary."
        );
    }
    if (open && !closed)
    {
        fail("A { is not closed", *open, "Close it with }.");
    }
    if (closed)
    {
        scopes_.back()->where_.last = t.line;
    }
}


void dictionaryParser::readEntry(tokenizer& in, const token& key)
{
    auto e = std::make_shared<entry>();
    e->key = key.text;
    e->where = {key.file, key.line, key.line};
    if (key.type == token::kind::string)
    {
        e->pattern = std::make_shared<keyPattern>(key.text, e->where);
    }

    token t;
    if (in.next(t))
    {
        if (t.is('{'))
        {
            readSubDict(in, *e, t);
            return;
        }
        in.putBack(t);
    }
    e->tokens = readValue(in, *e);
    insert(*scopes_.back(), e);
}


void dictionaryParser::readSubDict
(
    tokenizer& in,
    const entry& head,
    const token& open
)
{
    if (scopes_.size() > maxDepth)
    {
        fail
        (
            "Dictionaries are nested more than " + std::to_string(maxDepth)
                + " deep",
            open,
            "Is a } missing further up?"
        );
    }
    dictionary& parent = *scopes_.back();
    entry* old = parent.literal(head.key, bool(head.pattern));
    auto e = std::make_shared<entry>(entry{head.key, head.pattern, {}, {},
        head.where, false});
    e->dict = std::make_unique<dictionary>
    (
        parent.name_ + ':' + head.key, head.where
    );

    // Read in place, so that macros inside may look at it from the parent
    const bool kept = old && mode_ != inputMode::merge
        && mode_ != inputMode::overwrite;
    dictionary* target = e->dict.get();
    if (old && old->dict && mode_ == inputMode::merge)
    {
        target = old->dict.get();
    }
    else
    {
        insert(parent, e);
    }
    scopes_.push_back(target);
    readBody(in, &open);
    scopes_.pop_back();
    if (!kept)
    {
        entry* now = parent.literal(head.key, bool(head.pattern));
        if (now && now->dict)
        {
            now->where.last = now->dict->where_.last;
        }
    }
}


void dictionaryParser::readSubstitution(tokenizer& in, const token& macro)
{
    const expansion found = expand(macro);
    token t;
    const bool more = in.next(t);
    const bool alone = more && t.is(';');
    if (more && !alone)
    {
        in.putBack(t);
    }
    if (found.dict)
    {
        const dictionary copy = found.dict->clone(scopes_.back()->name_);
        for (const auto& e : copy.entries_)
        {
            insert(*scopes_.back(), e);
        }
        return;
    }
    if (alone || found.tokens.size() != 1
     || (found.tokens[0].type != token::kind::word
      && found.tokens[0].type != token::kind::string))
    {
        fail
        (
            macro.text + " is '" + tokensText(found.tokens, 60)
                + "', where a dictionary belongs",
            macro,
            "Only a dictionary can be inserted here, or a word as a key."
        );
    }
    readEntry(in, found.tokens[0]);
}


void dictionaryParser::insert
(
    dictionary& to,
    const std::shared_ptr<entry>& e
)
{
    entry* old = to.literal(e->key, bool(e->pattern));
    if (!old || mode_ == inputMode::overwrite)
    {
        to.put(e);
        return;
    }
    const std::string twice = "Entry '" + e->key + "' in \"" + to.name_
        + "\" at line " + std::to_string(e->where.first)
        + " was given at line " + std::to_string(old->where.first)
        + " already";
    if (mode_ == inputMode::error)
    {
        throw userError
        (
            twice, e->where, "Remove one; #inputMode error forbids it."
        );
    }
    if (mode_ == inputMode::warn)
    {
        warning(twice + ": the first is kept.");
    }
    if (mode_ != inputMode::merge)
    {
        return;
    }
    if (old->dict && e->dict)
    {
        for (const auto& sub : e->dict->entries_)
        {
            insert(*old->dict, sub);
        }
        return;
    }
    to.put(e);
}

} // namespace gpuFsi
