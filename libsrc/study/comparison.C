#include "study/comparison.H"

#include "base/error.H"
#include "base/log.H"
#include "dictionary/number.H"

#include <cmath>
#include <fmt/format.h>

namespace gpuFsi
{

namespace fs = std::filesystem;

namespace
{

double numberOr
(
    const textTable& t,
    std::size_t row,
    const std::string& column,
    double otherwise
)
{
    return t.has(column) && !t.text(row, column).empty()
      ? t.number(row, column) : otherwise;
}


std::string textOr
(
    const textTable& t,
    std::size_t row,
    const std::string& column,
    const std::string& otherwise
)
{
    return t.has(column) ? t.text(row, column) : otherwise;
}


curvePoint pointOf(const textTable& t, std::size_t i)
{
    curvePoint p;
    p.resolution = textOr(t, i, "resolution", "");
    p.size = numberOr(t, i, "size", curvePoint::none);
    p.error = t.number(i, "error");
    p.seconds.median = t.number(i, "seconds");
    p.seconds.least = numberOr(t, i, "secondsLeast", p.seconds.median);
    p.seconds.greatest = numberOr(t, i, "secondsGreatest", p.seconds.median);
    p.repeats = std::size_t(numberOr(t, i, "repeats", 1));
    p.run.error = p.error;
    p.run.loopSeconds = numberOr(t, i, "loopSeconds", 0);
    p.run.totalSeconds = numberOr(t, i, "totalSeconds", 0);
    p.run.particleSteps = numberOr(t, i, "particleSteps", 0);
    p.run.h = numberOr(t, i, "h", 0);
    p.run.deltaT = numberOr(t, i, "deltaT", 0);
    p.run.ranks = int(numberOr(t, i, "ranks", 1));
    p.run.device = textOr(t, i, "device", "");
    p.run.precision = textOr(t, i, "precision", "");
    p.run.scheme = textOr(t, i, "scheme", "");
    p.run.machine = textOr(t, i, "machine", "machine not named");
    return p;
}


//- Has it a place among logarithms? Warns where not.
bool canBeDrawn(const curvePoint& p, const textTable& t, std::size_t row)
{
    const bool good = p.error > 0 && p.seconds.median > 0;
    if (!good)
    {
        warning
        (
            fmt::format
            (
                "Row {} of {} is left out: it has error {} and seconds {}, of "
                "which both must be greater than 0", row + 1,
                t.file().string(), p.error, p.seconds.median
            )
        );
    }
    return good;
}


std::string numberOrNone(double value)
{
    return std::isfinite(value) ? fmt::format("{:.6g}", value) : "";
}

} // namespace


std::vector<curve> readCurves(const fs::path& given)
{
    if (!fs::exists(given))
    {
        throw userError
        (
            "There is no " + given.string() + " to compare with", {},
            "-compare takes the directory of a study, or a csv file; several "
            "separated by commas."
        );
    }
    const fs::path file =
        fs::is_directory(given) ? given/"errorVsRunTime.csv" : given;
    const textTable t = textTable::fromCsv(file);
    std::vector<curve> all;
    for (std::size_t i = 0; i < t.size(); ++i)
    {
        const curvePoint p = pointOf(t, i);
        if (!canBeDrawn(p, t, i))
        {
            continue;
        }
        const std::string name = t.text(i, "curve");
        auto c = all.begin();
        while (c != all.end() && c->name != name)
        {
            ++c;
        }
        if (c == all.end())
        {
            all.push_back({name, true, {}});
            c = all.end() - 1;
        }
        c->points.push_back(p);
    }
    for (curve& c : all)
    {
        addOrders(c);
    }
    return all;
}


std::string csvOf(const std::vector<curve>& curves)
{
    std::string text = "curve,resolution,size,error,order,seconds,"
        "secondsLeast,secondsGreatest,repeats,slope,pareto,loopSeconds,"
        "totalSeconds,particleSteps,particleStepsPerSecond,h,deltaT,ranks,"
        "device,precision,scheme,machine\n";
    for (const curve& c : curves)
    {
        for (const curvePoint& p : c.points)
        {
            const runRecord& r = p.run;
            text += fmt::format
            (
                "{},{},{},{:.9g},{},{:.6g},{:.6g},{:.6g},{},{},{},{:.6g},"
                "{:.6g},{:.12g},{:.6g},{:.12g},{:.12g},{},{},{},{},{}\n",
                csvText(c.name), csvText(p.resolution), numberOrNone(p.size),
                p.error, numberOrNone(p.order), p.seconds.median,
                p.seconds.least, p.seconds.greatest, p.repeats,
                numberOrNone(p.slope), p.pareto ? "yes" : "no", r.loopSeconds,
                r.totalSeconds, r.particleSteps,
                r.loopSeconds > 0 ? r.particleSteps/r.loopSeconds : 0, r.h,
                r.deltaT, r.ranks, csvText(r.device), r.precision,
                csvText(r.scheme), csvText(r.machine)
            );
        }
    }
    return text;
}

} // namespace gpuFsi
