#include "study/stabilityReport.H"

#include "study/textTable.H"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

namespace gpuFsi
{

namespace
{

std::string errorText(const stabilityRecord& r, const char* form)
{
    return std::isfinite(r.error)
      ? fmt::format(fmt::runtime(form), r.error) : "";
}


//- Accurate runs: their error alone
std::string cellOf(const stabilityResult* r)
{
    if (!r)
    {
        return "";
    }
    const outcome kind = r->record->kind;
    const std::string error = errorText(*r->record, "{:.2g}");
    return kind == outcome::accurate ? error
      : kind == outcome::inaccurate ? "inaccurate, " + error
      : allowed(kind) ? nameOf(kind)
      : fmt::format("**{}**", nameOf(kind));
}


std::string tableOf(const stabilityDict& s, const stabilityPlane& plane)
{
    const parameter& x = s.parameters[s.resolution];
    const parameter& y = s.parameters[s.y];
    const bool rows = s.y != s.resolution;
    std::string head = "| " + (rows ? y.name + " \\ " : "") + x.name + " |";
    std::string rule = "|---|";
    for (const parameter::choice& c : x.choices)
    {
        head += " " + c.label + " |";
        rule += "---|";
    }
    std::string text = (plane.name.empty() ? "" : "### " + plane.name + "\n\n")
      + head + " along " + x.name + " |\n" + rule + "---|\n";
    for (std::size_t j = 0; j < plane.rows.size(); ++j)
    {
        text += "| " + (rows ? y.choices[j].label : "") + " |";
        for (const stabilityResult* r : plane.rows[j])
        {
            text += " " + cellOf(r) + " |";
        }
        text += " " + boundariesOf(s, plane.rows[j]) + " |\n";
    }
    return text + "\n";
}


//- "12 accurate, 3 stopped"
std::string countsOf(const std::vector<stabilityResult>& results)
{
    std::array<int, nOutcomes> n{};
    for (const stabilityResult& r : results)
    {
        n[int(r.record ? r.record->kind : outcome::failed)] += bool(r.record);
    }
    std::string text;
    for (int i = 0; i < nOutcomes; ++i)
    {
        if (n[i])
        {
            text += (text.empty() ? "" : ", ")
              + fmt::format("{} {}", n[i], nameOf(outcome(i)));
        }
    }
    return text;
}


//- The first sentence or so
std::string shortened(const std::string& word)
{
    constexpr std::size_t most = 160;
    return word.size() <= most ? word : word.substr(0, most) + "...";
}


//- Runs that ended alike and say the same, by how it begins
struct saying
{
    const stabilityResult* first;
    int n;

    bool fits(const stabilityRecord& r) const
    {
        constexpr std::size_t alike = 30;
        return first->record->kind == r.kind
         && first->record->word.compare(0, alike, r.word, 0, alike) == 0;
    }
};


std::vector<saying> sayingsOf
(
    const std::vector<stabilityResult>& results,
    bool wanted(outcome)
)
{
    std::vector<saying> all;
    for (const stabilityResult& r : results)
    {
        if (!r.record || !wanted(r.record->kind))
        {
            continue;
        }
        const auto same = std::find_if(all.begin(), all.end(), [&](auto& s)
        {
            return s.fits(*r.record);
        });
        if (same == all.end())
        {
            all.push_back({&r, 1});
        }
        else
        {
            ++same->n;
        }
    }
    return all;
}


std::string wordsOf
(
    const std::vector<stabilityResult>& results,
    const std::string& heading,
    bool wanted(outcome)
)
{
    std::string text;
    for (const saying& s : sayingsOf(results, wanted))
    {
        text += fmt::format
        (
            "- {}{}: {}: {}\n", s.first->what.name,
            s.n > 1 ? fmt::format(" and {} more", s.n - 1) : "",
            nameOf(s.first->record->kind), shortened(s.first->record->word)
        );
    }
    return text.empty() ? "" : "## " + heading + "\n\n" + text + "\n";
}

} // namespace


std::string csvOf
(
    const stabilityDict& s,
    const std::vector<stabilityResult>& results
)
{
    std::string text;
    for (const parameter& p : s.parameters)
    {
        text += csvText(p.name) + ",";
    }
    text += "class,error,seconds,word\n";
    for (const stabilityResult& r : results)
    {
        if (!r.record)
        {
            continue;
        }
        for (std::size_t i = 0; i < s.parameters.size(); ++i)
        {
            text += csvText(s.parameters[i].choices[r.what.choice[i]].label)
              + ",";
        }
        text += fmt::format
        (
            "{},{},{:.4g},{}\n", nameOf(r.record->kind),
            errorText(*r.record, "{:.9g}"), r.record->seconds,
            csvText(r.record->word)
        );
    }
    return text;
}


std::string markdownOf
(
    const stabilityDict& s,
    const std::vector<stabilityResult>& results
)
{
    std::string text = fmt::format
    (
        "# {}: what is stable\n\n{}. Numbers: errors{}, accurate up to "
        "{:g}.\n\n",
        s.title, countsOf(results),
        s.error.label.empty() ? "" : " (" + s.error.label + ")", s.errorLimit
    );
    for (const stabilityPlane& plane : planesOf(s, results))
    {
        text += tableOf(s, plane);
    }
    text += wordsOf(results, "What was said", [](outcome o)
    {
        return o == outcome::refused || o == outcome::stopped;
    });
    return text + wordsOf(results, "Never allowed", [](outcome o)
    {
        return !allowed(o);
    });
}

} // namespace gpuFsi
