#include "functionObjects/functionObjectList.H"

#include "base/log.H"

#include <algorithm>

namespace gpuFsi
{

namespace
{

//- Entries of what is switched off are no user's slip
void markRead(const dictionary& dict)
{
    for (const std::string& key : dict.keys())
    {
        if (dict.isDict(key))
        {
            markRead(dict.subDict(key));
        }
        else
        {
            dict.tokens(key);
        }
    }
}

} // namespace


functionObjectList::functionObjectList
(
    const dictionary& controlDict,
    const runInfo& info,
    bool enabled
)
{
    const dictionary* functions = controlDict.subDictPtr("functions");
    if (!functions)
    {
        return;
    }
    if (!enabled)
    {
        markRead(*functions);
        return;
    }
    for (const std::string& name : functions->keys())
    {
        if (!functions->isDict(name))
        {
            throw userError
            (
                "functions: " + name + " is not a sub-dictionary",
                functions->where(name),
                "Write " + name + " { type probes; ... }"
            );
        }
        const dictionary& dict = functions->subDict(name);
        if (!dict.getOrDefault<bool>("enabled", true))
        {
            markRead(dict);
            continue;
        }
        if (dict.found("libs"))
        {
            // OpenFOAM names a shared library here; ours are linked in
            dict.tokens("libs");
        }
        objects_.push_back
        (
            functionObject::selection::make
            (
                "function object",
                dict.get<std::string>("type"),
                dict.where("type"),
                name,
                dict,
                info
            )
        );
    }
}


bool functionObjectList::needsLedger() const
{
    for (const auto& object : objects_)
    {
        if (object->needsLedger())
        {
            return true;
        }
    }
    return false;
}


void functionObjectList::start(const hostState& state, const runInfo& info)
{
    for (const auto& object : objects_)
    {
        object->start(state, info);
        if (object->dueAtStart(info))
        {
            object->execute(state, info);
        }
        object->passed(info);
    }
}


void functionObjectList::dropLedgers()
{
    const auto first = std::stable_partition
    (
        objects_.begin(), objects_.end(),
        [](const auto& object) { return !object->needsLedger(); }
    );
    for (auto o = first; o != objects_.end(); ++o)
    {
        warning
        (
            "Function object " + (*o)->name() + " keeps an energy ledger, "
            "which needs one rank: it is left out"
        );
    }
    objects_.erase(first, objects_.end());
}


bool functionObjectList::due(const runInfo& info) const
{
    for (const auto& object : objects_)
    {
        if (object->due(info))
        {
            return true;
        }
    }
    return false;
}


void functionObjectList::execute(const hostState& state, const runInfo& info)
{
    for (const auto& object : objects_)
    {
        if (object->due(info))
        {
            object->execute(state, info);
            object->passed(info);
        }
    }
}


void functionObjectList::end(const runInfo& info)
{
    for (const auto& object : objects_)
    {
        object->end(info);
    }
}

} // namespace gpuFsi
