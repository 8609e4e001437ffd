#include "study/gnuplot.H"
#include "study/stabilityReport.H"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace gpuFsi
{

namespace
{

//- One an outcome; legible also without red and green
const char* const colours[nOutcomes] =
{
    "#56b4e9", "#f0e442", "#bbbbbb", "#e69f00", "#d55e00", "#882255",
    "#332288", "#000000"
};


//- x, y, outcome, text
std::string blockOf(const std::string& name, const stabilityPlane& plane)
{
    std::string text = name + " << EOD\n";
    for (std::size_t j = 0; j < plane.rows.size(); ++j)
    {
        for (std::size_t i = 0; i < plane.rows[j].size(); ++i)
        {
            const stabilityResult* r = plane.rows[j][i];
            if (r)
            {
                const double e = r->record->error;
                text += fmt::format
                (
                    "{} {} {} {}\n", i, j, int(r->record->kind),
                    std::isfinite(e) ? fmt::format("{:.2g}", e) : "\"\""
                );
            }
        }
    }
    return text + "EOD\n";
}


std::string ticsOf(const char* axis, const parameter& p)
{
    std::string text;
    for (std::size_t i = 0; i < p.choices.size(); ++i)
    {
        text += fmt::format
        (
            "{}{} {}", i ? ", " : "", '"' + p.choices[i].label + '"', i
        );
    }
    return fmt::format("set {}tics ({})\n", axis, text);
}


std::string axesOf(const stabilityDict& s)
{
    const parameter& x = s.parameters[s.resolution];
    const parameter& y = s.parameters[s.y];
    const bool rows = s.y != s.resolution;
    return fmt::format
    (
        "set xrange [-0.5:{}.5]\nset yrange [-0.5:{}.5]\n"
        "set xlabel {}\nset ylabel {}\n{}{}set tics scale 0 noenhanced\n",
        x.choices.size() - 1, rows ? y.choices.size() - 1 : 0,
        gnuplotText(x.name), gnuplotText(rows ? y.name : ""),
        ticsOf("x", x), rows ? ticsOf("y", y) : "unset ytics\n"
    );
}


std::string plotOf(const std::string& block, const std::string& title)
{
    std::string text = "set title " + gnuplotText(title) + "\nplot ";
    for (int k = 0; k < nOutcomes; ++k)
    {
        text += fmt::format
        (
            "{} using ($3=={}?$1:1/0):2:(0.49):(0.47) with boxxyerror "
            "fs solid noborder lc rgb '{}' notitle, \\\n  ",
            block, k, colours[k]
        );
    }
    return text + block + " using 1:2:4 with labels font ',9' notitle";
}


//- Only those that occur
std::string keyOf(const std::vector<stabilityResult>& results)
{
    std::string text;
    for (int k = 0; k < nOutcomes; ++k)
    {
        for (const stabilityResult& r : results)
        {
            if (r.record && int(r.record->kind) == k)
            {
                text += fmt::format
                (
                    ", \\\n  keyentry with boxes fs solid lc rgb '{}' title "
                    "'{}'", colours[k], nameOf(outcome(k))
                );
                break;
            }
        }
    }
    return text;
}

std::size_t longestLabel(const parameter& p)
{
    std::size_t longest = 0;
    for (const parameter::choice& c : p.choices)
    {
        longest = std::max(longest, c.label.size());
    }
    return longest;
}


//- Columns, and labels of the rows
std::size_t widthOf(const stabilityDict& s)
{
    const parameter& x = s.parameters[s.resolution];
    return 310 + 9*std::max<std::size_t>(7, longestLabel(x))*x.choices.size()
      + 7*longestLabel(s.parameters[s.y]);
}

} // namespace


std::string gnuplotOf
(
    const stabilityDict& s,
    const std::vector<stabilityResult>& results,
    const std::string& stem
)
{
    const std::vector<stabilityPlane> planes = planesOf(s, results);
    std::string data, plots;
    std::size_t nRows = 0;
    for (std::size_t i = 0; i < planes.size(); ++i)
    {
        const std::string block = fmt::format("$plane{}", i);
        data += blockOf(block, planes[i]);
        nRows += planes[i].rows.size();
        plots += plotOf
        (
            block, planes[i].name.empty() ? s.title : planes[i].name
        ) + (i ? "" : keyOf(results)) + "\n";
    }
    const std::size_t width = widthOf(s);
    const std::size_t height = 130*planes.size() + 32*nRows;
    std::string text =
        data + axesOf(s)
      + "set key outside right top reverse Left\nset rmargin 22\n";
    const char* terminals[][2] =
    {
        {"svg", "svg size {},{} font 'sans,13' background '#ffffff'"},
        {"png", "pngcairo size {},{} font 'sans,11'"}
    };
    for (const auto& [ending, terminal] : terminals)
    {
        text += fmt::format
        (
            "set terminal {}\nset output '{}.{}'\nset multiplot layout {},1 "
            "title {}\n{}unset multiplot\n",
            fmt::format(fmt::runtime(terminal), width, height), stem, ending,
            planes.size(),
            gnuplotText(planes.size() > 1 ? s.title : ""), plots
        );
    }
    return text + "set output\n";
}

} // namespace gpuFsi
