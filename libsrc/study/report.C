#include "study/report.H"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace gpuFsi
{

namespace
{

std::string numberOr(double value, const char* form, const char* otherwise)
{
    return std::isfinite(value)
      ? fmt::format(fmt::runtime(form), value) : otherwise;
}


std::string rangeOf(const curvePoint& p)
{
    return p.repeats < 2
      ? "" : fmt::format("{:.3g} to {:.3g}", p.seconds.least,
            p.seconds.greatest);
}


std::string joined(const std::vector<std::string>& texts)
{
    std::string all;
    for (const std::string& t : texts)
    {
        all += (all.empty() ? "" : "; ") + t;
    }
    return all;
}


std::string tableOf(const studyDict& s, const curve& c)
{
    std::string text = fmt::format
    (
        "### {}\n\n| {} | dt | error | order | seconds | range | slope | "
        "million particle-steps/s | front |\n"
        "|---|---|---|---|---|---|---|---|---|\n",
        c.name, s.parameters[s.resolution].name
    );
    for (const curvePoint& p : c.points)
    {
        const runRecord& r = p.run;
        const double rate = r.loopSeconds > 0 && r.particleSteps > 0
          ? r.particleSteps/r.loopSeconds/1e6 : curvePoint::none;
        text += fmt::format
        (
            "| {} | {} | {:.3g} | {} | {:.3g} | {} | {} | {} | {} |\n",
            p.resolution, r.deltaT > 0 ? fmt::format("{:.4g}", r.deltaT) : "",
            p.error, numberOr(p.order, "{:.2f}", ""), p.seconds.median,
            rangeOf(p), numberOr(p.slope, "{:.2f}", ""),
            numberOr(rate, "{:.3g}", ""), p.pareto ? "*" : ""
        );
    }
    const std::vector<std::string> machines = machinesOf(c);
    const runRecord& r = c.points.front().run;
    text += "\n";
    if (!r.device.empty())
    {
        text += fmt::format
        (
            "{}{}, {} precision, {}. ", r.device,
            r.ranks > 1 ? fmt::format(" on {} ranks", r.ranks) : "",
            r.precision, r.scheme
        );
    }
    return text + (machines.size() > 1 ? "MACHINES MIXED: " : "Machine: ")
      + joined(machines) + ".\n\n";
}


std::string timeTo(const curve& c, double target)
{
    const auto found = secondsToReach(c, target);
    return !found ? "not reached"
      : fmt::format("{}{:.3g}", found->atMost ? "at most " : "",
            found->seconds);
}


std::string targetsOf(const studyDict& s, const std::vector<curve>& all)
{
    if (s.targets.empty() || all.empty())
    {
        return "";
    }
    std::string head = "## Seconds to reach an error\n\n| curve |";
    std::string rule = "|---|";
    for (const double target : s.targets)
    {
        head += fmt::format(" {:g} |", target);
        rule += "---|";
    }
    std::string text = head + "\n" + rule + "\n";
    for (const curve& c : all)
    {
        text += "| " + c.name + " |";
        for (const double target : s.targets)
        {
            text += " " + timeTo(c, target) + " |";
        }
        text += "\n";
    }
    return text + "\n";
}


std::string frontOf(const std::vector<curve>& all)
{
    struct place
    {
        const curve* of;
        const curvePoint* point;
    };
    std::vector<place> front;
    for (const curve& c : all)
    {
        for (const curvePoint& p : c.points)
        {
            if (p.pareto)
            {
                front.push_back({&c, &p});
            }
        }
    }
    std::stable_sort(front.begin(), front.end(), [](auto& a, auto& b)
    {
        return a.point->seconds.median < b.point->seconds.median;
    });
    std::string text = "## Pareto front, from fast to exact\n\n";
    for (const place& f : front)
    {
        text += fmt::format
        (
            "- {}, {}: {:.3g} in {:.3g} s\n", f.of->name, f.point->resolution,
            f.point->error, f.point->seconds.median
        );
    }
    return text + "\n";
}

} // namespace


std::string errorLabel(const studyDict& s)
{
    const auto& e = s.error;
    if (!e.label.empty())
    {
        return e.label
          + (e.finest ? ", difference from its own finest run" : "");
    }
    if (e.finest)
    {
        return "difference from its own finest run, relative";
    }
    if (e.direct)
    {
        return "error";
    }
    if (!e.command.empty())
    {
        return fmt::format("relative difference from {:.6g}", e.exact);
    }
    return e.functionObject + ", "
      + (e.norm == "rmsByMax" ? "rms over the largest exact value" : e.norm);
}


std::string markdownOf
(
    const studyDict& s,
    const std::vector<curve>& own,
    const std::vector<curve>& compared,
    const std::vector<std::string>& failures
)
{
    std::vector<curve> all = own;
    all.insert(all.end(), compared.begin(), compared.end());
    std::string text = fmt::format
    (
        "# {}: error against run time\n\n"
        "Error: {}. Seconds: clock time of {}, median of the runs of a "
        "variant. order: of the error from the line before; slope: by how "
        "much the logarithm of the seconds grows with that of 1/error; "
        "front: no other is faster and more exact.\n\n",
        s.title, errorLabel(s),
        s.total ? "the whole program" : "the solver's loop"
    );
    for (const curve& c : own)
    {
        text += tableOf(s, c);
    }
    if (!compared.empty())
    {
        text += "## Compared with\n\n";
        for (const curve& c : compared)
        {
            text += tableOf(s, c);
        }
    }
    text += targetsOf(s, all) + frontOf(all);
    if (!failures.empty())
    {
        text += "## Failed\n\n";
        for (const std::string& f : failures)
        {
            // With the first line of what the program said
            const std::size_t end = f.find('\n');
            text += "- " + f.substr(0, f.find('\n', end + 1)) + "\n";
        }
    }
    return text;
}

} // namespace gpuFsi
