#include "decomposition/cloudParts.H"

#include "base/error.H"

#include <fmt/format.h>

#include <algorithm>

namespace gpuFsi
{

namespace fs = std::filesystem;

namespace
{

constexpr const char* idField = "origId";
constexpr const char* remedy =
    "Files of all ranks must come from the same run: take another time, or"
    " decompose and run again.";

const cloudField& idsOf(const cloud& part, const fs::path& where)
{
    const cloudField* ids = part.find(idField);
    if (!ids || !(ids->cls == "labelField"))
    {
        throw userError
        (
            "There is no labelField origId, the places of the particles in"
            " the whole cloud",
            {(where/idField).string()},
            "decomposeParticles writes it, and a run on several ranks."
        );
    }
    return *ids;
}

//- How often each id is there
class idCheck
{
public:

    idCheck
    (
        const std::vector<cloud>& parts,
        const std::vector<fs::path>& where,
        std::optional<std::size_t> size
    )
    {
        std::size_t all = size ? *size : 0;
        for (std::size_t r = 0; r < parts.size(); ++r)
        {
            for (double id : idsOf(parts[r], where[r]).values)
            {
                if (id < 0 || (size && id >= double(*size)))
                {
                    throw userError
                    (
                        fmt::format("{} is not the id of a particle{}", id,
                            size ? fmt::format(" of {}", *size) : ""),
                        {(where[r]/idField).string()},
                        remedy
                    );
                }
                all = std::max(all, std::size_t(id) + 1);
            }
        }
        count_.resize(all, 0);
        for (const cloud& part : parts)
        {
            for (double id : part.find(idField)->values)
            {
                unsigned char& n = count_[std::size_t(id)];
                n = std::min(n + 1, 2);
            }
        }
    }

    //- Throws unless each is there once
    void require(const std::string& cloudName, const fs::path& where) const
    {
        std::size_t missing = 0, twice = 0, firstMissing = 0, firstTwice = 0;
        for (std::size_t i = count_.size(); i-- > 0;)
        {
            if (count_[i] == 0)
            {
                ++missing;
                firstMissing = i;
            }
            else if (count_[i] > 1)
            {
                ++twice;
                firstTwice = i;
            }
        }
        if (missing + twice == 0)
        {
            return;
        }
        std::string found;
        if (missing > 0)
        {
            found = fmt::format
            (
                "{} missing (the first is {})", missing, firstMissing
            );
        }
        if (twice > 0)
        {
            found += fmt::format
            (
                "{}{} more than once (the first is {})",
                found.empty() ? "" : " and ", twice, firstTwice
            );
        }
        throw userError
        (
            fmt::format
            (
                "Of the {} particles of cloud {} {}",
                count_.size(), cloudName, found
            ),
            {where.string()},
            remedy
        );
    }

    std::size_t size() const { return count_.size(); }

private:

    std::vector<unsigned char> count_;    // 2: twice or more
};

void checkAlike
(
    const cloud& part,
    const cloud& first,
    const fs::path& where,
    const fs::path& firstWhere
)
{
    const auto lacks = [](const cloud& a, const cloud& b, const fs::path& at)
    {
        for (const cloudField& f : b.fields)
        {
            const cloudField* other = a.find(f.name);
            if (!other || other->cls != f.cls)
            {
                throw userError
                (
                    "There is no " + f.cls + " " + f.name + " in "
                  + at.string() + ", as other ranks have it",
                    {(at/f.name).string()},
                    remedy
                );
            }
        }
    };
    lacks(part, first, where);
    lacks(first, part, firstWhere);
}

void scatter
(
    const std::vector<double>& from,
    const std::vector<double>& ids,
    int n,
    std::vector<double>& to
)
{
    for (std::size_t i = 0; i < ids.size(); ++i)
    {
        const std::size_t at = std::size_t(ids[i])*n;
        std::copy_n(from.begin() + i*n, n, to.begin() + at);
    }
}

} // namespace


cloud partOf(const cloud& whole, const std::vector<std::size_t>& ids)
{
    if (whole.find(idField))
    {
        throw userError
        (
            "Cloud " + whole.name + " has a field origId already",
            {},
            "Rename it: the programs for several ranks keep ids under this"
            " name."
        );
    }
    cloud part;
    part.name = whole.name;
    part.positions.reserve(ids.size());
    for (std::size_t id : ids)
    {
        part.positions.push_back(whole.positions[id]);
    }
    for (const cloudField& f : whole.fields)
    {
        const int n = f.nComponents();
        cloudField own{f.cls, f.name, {}};
        own.values.reserve(ids.size()*n);
        for (std::size_t id : ids)
        {
            const auto from = f.values.begin() + id*n;
            own.values.insert(own.values.end(), from, from + n);
        }
        part.fields.push_back(std::move(own));
    }
    part.addLabel(idField, {ids.begin(), ids.end()});
    return part;
}


cloud joinParts
(
    std::vector<cloud> parts,
    const std::vector<fs::path>& where,
    std::optional<std::size_t> size
)
{
    developerAssert(!parts.empty(), "parts to join");
    const idCheck check(parts, where, size);
    check.require(parts.front().name, where.front());
    for (std::size_t r = 1; r < parts.size(); ++r)
    {
        checkAlike(parts[r], parts[0], where[r], where[0]);
    }

    cloud whole;
    whole.name = parts.front().name;
    whole.positions.resize(check.size());
    for (const cloudField& f : parts.front().fields)
    {
        if (f.name != idField)
        {
            const std::size_t n = check.size()*f.nComponents();
            whole.fields.push_back
            (
                {f.cls, f.name, std::vector<double>(n)}
            );
        }
    }
    for (cloud& part : parts)
    {
        const std::vector<double>& ids = part.find(idField)->values;
        for (std::size_t i = 0; i < ids.size(); ++i)
        {
            whole.positions[std::size_t(ids[i])] = part.positions[i];
        }
        for (cloudField& f : whole.fields)
        {
            scatter
            (
                part.find(f.name)->values, ids, f.nComponents(), f.values
            );
        }
        part = cloud();
    }
    return whole;
}

} // namespace gpuFsi
