#include "study/stabilityGrid.H"

#include <algorithm>

namespace gpuFsi
{

namespace
{

std::string planeName(const stabilityDict& s, const variant& v)
{
    std::string name;
    for (std::size_t i = 0; i < s.parameters.size(); ++i)
    {
        const parameter& p = s.parameters[i];
        if (i != s.resolution && i != s.y && p.choices.size() > 1)
        {
            name += (name.empty() ? "" : ", ") + p.name + " "
              + p.choices[v.choice[i]].label;
        }
    }
    return name;
}


std::size_t nRows(const stabilityDict& s)
{
    return s.y == s.resolution ? 1 : s.parameters[s.y].choices.size();
}


std::size_t rowOf(const stabilityDict& s, const variant& v)
{
    return s.y == s.resolution ? 0 : v.choice[s.y];
}


//- Neighbours of a row that ended alike
struct stretch
{
    outcome kind;
    std::size_t first, last;     // choices of x
};

} // namespace


std::vector<stabilityPlane> planesOf
(
    const stabilityDict& s,
    const std::vector<stabilityResult>& results
)
{
    std::vector<stabilityPlane> planes;
    for (const stabilityResult& r : results)
    {
        const std::string name = planeName(s, r.what);
        const auto found = std::find_if
        (
            planes.begin(), planes.end(),
            [&](const stabilityPlane& p) { return p.name == name; }
        );
        stabilityPlane& plane =
            found == planes.end() ? planes.emplace_back() : *found;
        if (plane.rows.empty())
        {
            plane.name = name;
            plane.rows.assign
            (
                nRows(s),
                std::vector<const stabilityResult*>
                (
                    s.parameters[s.resolution].choices.size(), nullptr
                )
            );
        }
        if (r.record)
        {
            plane.rows[rowOf(s, r.what)][r.what.choice[s.resolution]] = &r;
        }
    }
    return planes;
}


std::string boundariesOf
(
    const stabilityDict& s,
    const std::vector<const stabilityResult*>& row
)
{
    std::vector<stretch> all;
    for (std::size_t i = 0; i < row.size(); ++i)
    {
        if (!row[i])
        {
            continue;
        }
        const outcome kind = row[i]->record->kind;
        if (all.empty() || all.back().kind != kind)
        {
            all.push_back({kind, i, i});
        }
        all.back().last = i;
    }
    const auto& choices = s.parameters[s.resolution].choices;
    std::string text;
    for (std::size_t i = 0; i < all.size(); ++i)
    {
        const stretch& r = all[i];
        text += (i ? "; " : "") + std::string(nameOf(r.kind));
        if (all.size() == 1)
        {
            return text;
        }
        text += i == 0 ? " to " + choices[r.last].label
          : i + 1 == all.size() ? " from " + choices[r.first].label
          : r.first == r.last ? " at " + choices[r.first].label
          : " from " + choices[r.first].label + " to " + choices[r.last].label;
    }
    return text;
}

} // namespace gpuFsi
