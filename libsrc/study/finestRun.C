#include "study/finestRun.H"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace gpuFsi
{

static bool strictlyFalls(const std::vector<double>& values)
{
    return std::is_sorted(values.begin(), values.end(), std::greater_equal<>());
}


//- Points whose spacings and sizes say nothing pass
static bool goesOneWay(const curve& c)
{
    std::vector<double> h, size;
    for (const curvePoint& p : c.points)
    {
        h.push_back(p.run.h);
        size.push_back(p.size);
    }
    const auto isNumber = [](double x) { return std::isfinite(x); };
    if (std::any_of(h.begin(), h.end(), [&](double x) { return x != h[0]; }))
    {
        return strictlyFalls(h);
    }
    const std::vector<double> back(size.rbegin(), size.rend());
    return !std::all_of(size.begin(), size.end(), isNumber)
     || strictlyFalls(size) || strictlyFalls(back);
}


std::string compareWithFinest(curve& c, const std::string& finestLabel)
{
    if (c.points.empty() || c.points.back().resolution != finestLabel)
    {
        return "the run at " + finestLabel + ", which the others are to be "
            "compared with, has no result";
    }
    if (!goesOneWay(c))
    {
        return "the resolutions do not go from coarse to fine: which is the "
            "finest?";
    }
    const double finest = c.points.back().error;
    if (!std::isfinite(finest) || finest == 0)
    {
        return fmt::format
        (
            "the run at {} gives {}, to which nothing is relative",
            finestLabel, finest
        );
    }
    c.points.pop_back();
    for (curvePoint& p : c.points)
    {
        p.error = std::fabs(p.error/finest - 1);
    }
    return {};
}

} // namespace gpuFsi
