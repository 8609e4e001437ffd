#include "study/variant.H"

#include "dictionary/number.H"

#include <algorithm>

namespace gpuFsi
{

namespace
{

//- For a directory
std::string plain(std::string text)
{
    for (char& c : text)
    {
        const bool good = std::isalnum(static_cast<unsigned char>(c))
         || std::string("+-.=").find(c) != std::string::npos;
        c = good ? c : '_';
    }
    return text;
}


variant make(const variantSet& s, const std::vector<std::size_t>& choice)
{
    variant v;
    v.choice = choice;
    for (std::size_t i = 0; i < choice.size(); ++i)
    {
        const parameter& p = s.parameters[i];
        const std::string& label = p.choices[choice[i]].label;
        if (p.choices.size() == 1 && i != s.resolution)
        {
            continue;    // tells nothing apart
        }
        v.name += (v.name.empty() ? "" : "_") + p.name + "=" + plain(label);
        if (i == s.resolution)
        {
            v.resolution = label;
            v.size = p.number(choice[i]);
        }
        else
        {
            // A number alone would say nothing
            double number = 0;
            const bool bare = readNumber(label, number);
            v.curve += (v.curve.empty() ? "" : ", ")
              + (bare ? p.name + " " : "") + label;
        }
    }
    if (v.curve.empty())
    {
        v.curve = s.title;
    }
    return v;
}


bool skipped(const variantSet& s, const std::vector<std::size_t>& choice)
{
    return std::any_of(s.skip.begin(), s.skip.end(), [&](const auto& rule)
    {
        for (std::size_t i = 0; i < choice.size(); ++i)
        {
            const parameter& p = s.parameters[i];
            const auto wanted = rule.find(p.name);
            if (wanted != rule.end()
             && wanted->second != p.choices[choice[i]].label)
            {
                return false;
            }
        }
        return true;
    });
}


//- The next combination; false after the last
bool advance(const variantSet& s, std::vector<std::size_t>& choice)
{
    std::vector<std::size_t> order{s.resolution};
    for (std::size_t i = choice.size(); i-- > 0;)
    {
        if (i != s.resolution)
        {
            order.push_back(i);
        }
    }
    for (const std::size_t i : order)
    {
        if (++choice[i] < s.parameters[i].choices.size())
        {
            return true;
        }
        choice[i] = 0;
    }
    return false;
}

} // namespace


std::vector<variant::change> variant::changes(const variantSet& s) const
{
    std::vector<change> all;
    for (std::size_t i = 0; i < choice.size(); ++i)
    {
        const parameter& p = s.parameters[i];
        for (std::size_t e = 0; e < p.entries.size(); ++e)
        {
            const std::string& value = p.choices[choice[i]].values[e];
            if (value != "asIs")
            {
                all.push_back({p.entries[e], value});
            }
        }
    }
    return all;
}


std::vector<std::string> variant::environment(const variantSet& s) const
{
    std::vector<std::string> settings;
    for (std::size_t i = 0; i < choice.size(); ++i)
    {
        const parameter& p = s.parameters[i];
        settings.push_back(p.name + "=" + p.choices[choice[i]].label);
    }
    return settings;
}


std::vector<variant> allVariants(const variantSet& s)
{
    std::vector<variant> list;
    std::vector<std::size_t> choice(s.parameters.size(), 0);
    do
    {
        if (!skipped(s, choice))
        {
            list.push_back(make(s, choice));
        }
    }
    while (advance(s, choice));
    if (list.empty())
    {
        throw userError
        (
            "The rules of skip leave no variant", {}, "Take some out."
        );
    }
    for (std::size_t i = 0; i < list.size(); ++i)
    {
        for (std::size_t j = 0; j < i; ++j)
        {
            if (list[i].name == list[j].name)
            {
                throw userError
                (
                    "Two variants are called " + list[i].name, {},
                    "Give labels that differ in letters or digits."
                );
            }
        }
    }
    return list;
}

} // namespace gpuFsi
