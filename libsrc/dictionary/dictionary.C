#include "dictionary/dictionary.H"

#include "dictionary/dictionaryParser.H"
#include "dictionary/entry.H"

#include <algorithm>

namespace gpuFsi
{

dictionary::dictionary(std::string name, sourceSpan where)
:
    name_(std::move(name)),
    where_(std::move(where)),
    askedFor_(std::make_shared<std::vector<std::string>>())
{}


dictionary dictionary::fromFile(const std::filesystem::path& file)
{
    return dictionaryParser::file(file);
}


dictionary dictionary::fromString
(
    const std::string& text,
    const std::string& name
)
{
    return dictionaryParser::text(text, name);
}


void dictionary::ask(const std::string& key) const
{
    if (std::find(askedFor_->begin(), askedFor_->end(), key)
     == askedFor_->end())
    {
        askedFor_->push_back(key);
    }
}


entry* dictionary::literal(const std::string& key, bool pattern) const
{
    for (const auto& e : entries_)
    {
        if (e->key == key && bool(e->pattern) == pattern)
        {
            return e.get();
        }
    }
    return nullptr;
}


entry* dictionary::match(const std::string& key) const
{
    if (entry* exact = literal(key))
    {
        return exact;
    }
    for (auto e = entries_.rbegin(); e != entries_.rend(); ++e)
    {
        if ((*e)->pattern && (*e)->pattern->matches(key))
        {
            return e->get();
        }
    }
    return nullptr;
}


bool dictionary::found(const std::string& key) const
{
    ask(key);
    return match(key) != nullptr;
}


bool dictionary::isDict(const std::string& key) const
{
    ask(key);
    const entry* e = match(key);
    return e && e->dict;
}


void dictionary::throwMissing(const std::string& key, const char* what) const
{
    const std::vector<std::string> present = keys();
    std::string remedy = std::string("Add ") + what + " '" + key + "'";
    const std::string near = nearestWord(key, present);
    if (!near.empty())
    {
        remedy += "; is '" + near + "' at line "
            + std::to_string(where(near).first) + " meant for it?";
    }
    else if (present.empty())
    {
        remedy += "; the dictionary is empty.";
    }
    else
    {
        remedy += "; the keys there are:";
        for (const std::string& k : present)
        {
            remedy += ' ' + k;
        }
    }
    throw userError
    (
        "Entry '" + key + "' not found in dictionary \"" + name_ + '"',
        where_,
        remedy
    );
}


const dictionary* dictionary::subDictPtr(const std::string& key) const
{
    ask(key);
    entry* e = match(key);
    if (!e)
    {
        return nullptr;
    }
    if (!e->dict)
    {
        throw userError
        (
            "Entry '" + key + "' in dictionary \"" + name_
                + "\" is '" + tokensText(e->tokens, 60)
                + "', a sub-dictionary was expected",
            e->where,
            "Write " + key + " { ... }."
        );
    }
    e->read = true;
    return e->dict.get();
}


const dictionary& dictionary::subDict(const std::string& key) const
{
    const dictionary* sub = subDictPtr(key);
    if (!sub)
    {
        throwMissing(key, "the sub-dictionary");
    }
    return *sub;
}


const entry& dictionary::primitive
(
    const std::string& key,
    const std::string& what
) const
{
    ask(key);
    entry* e = match(key);
    if (!e)
    {
        throwMissing(key, "the entry");
    }
    if (e->dict)
    {
        throw userError
        (
            "Entry '" + key + "' in dictionary \"" + name_
                + "\" is a sub-dictionary, " + what + " was expected",
            e->where,
            "Write " + key + " value;"
        );
    }
    e->read = true;
    return *e;
}


const std::vector<token>& dictionary::tokens(const std::string& key) const
{
    return primitive(key, "a value").tokens;
}


std::vector<std::string> dictionary::keys() const
{
    std::vector<std::string> list;
    for (const auto& e : entries_)
    {
        list.push_back(e->key);
    }
    return list;
}


sourceSpan dictionary::where(const std::string& key) const
{
    const entry* e = match(key);
    if (!e)
    {
        e = literal(key, true);
    }
    return e ? e->where : where_;
}


void dictionary::put(const std::shared_ptr<entry>& e)
{
    for (auto& old : entries_)
    {
        if (old->key == e->key && bool(old->pattern) == bool(e->pattern))
        {
            old = e;
            return;
        }
    }
    entries_.push_back(e);
}


void dictionary::set(const std::string& key, const std::string& valueText)
{
    put(dictionaryParser::value(*this, key, valueText));
}


dictionary dictionary::clone(const std::string& name) const
{
    dictionary copy(name, where_);
    for (const auto& e : entries_)
    {
        auto c = std::make_shared<entry>();
        c->key = e->key;
        c->pattern = e->pattern;
        c->tokens = e->tokens;
        c->where = e->where;
        if (e->dict)
        {
            c->dict = std::make_unique<dictionary>
            (
                e->dict->clone(name + ':' + e->key)
            );
        }
        copy.entries_.push_back(c);
    }
    return copy;
}


std::size_t dictionary::markAllRead() const
{
    std::size_t n = 0;
    for (const auto& e : entries_)
    {
        e->read = true;
        n += 1 + e->tokens.size() + (e->dict ? e->dict->markAllRead() : 0);
    }
    return n;
}

} // namespace gpuFsi
