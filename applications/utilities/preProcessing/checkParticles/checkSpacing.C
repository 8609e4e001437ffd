#include "checks.H"

#include "base/log.H"
#include "base/sum.H"
#include "functionObjects/nearestDistance.H"

#include <algorithm>
#include <array>

using namespace gpuFsi;

//- Nearer than this, in spacings, two particles overlap: shifting keeps 0.7,
//  and weights lose their sign long before
static constexpr double overlap = 0.2;

static void printHistogram(const std::vector<double>& nearest)
{
    constexpr std::array<double, 8> bounds
    {
        overlap, 0.4, 0.6, 0.8, 0.95, 1.05, 1.2, 1.5
    };
    std::array<long, bounds.size() + 1> count{};
    for (double d : nearest)
    {
        const auto at = std::upper_bound(bounds.begin(), bounds.end(), d);
        ++count[at - bounds.begin()];
    }
    double from = 0;
    for (std::size_t b = 0; b < count.size(); ++b)
    {
        const std::string to = b < bounds.size()
          ? fmt::format("{:.2f}", bounds[b]) : "    ";
        info("        {:.2f} to {} h {:>12} {:>6.1f} %", from, to, count[b],
            100.0*count[b]/nearest.size());
        from = b < bounds.size() ? bounds[b] : from;
    }
}


void checkSpacing
(
    const checkedCase& c,
    const checkedTime& t,
    findings& found
)
{
    info("Checking spacing...");
    const std::vector<double> nearest = nearestDistance(t.state, c.space);
    const auto [least, greatest] =
        std::minmax_element(nearest.begin(), nearest.end());
    const double mean = pairwiseSum
    (
        0, nearest.size(), [&](std::size_t i) { return nearest[i]; }
    )/nearest.size();
    info
    (
        "    Nearest particle: min = {:.3f} mean = {:.3f} max = {:.3f} h",
        *least, mean, *greatest
    );
    info("        min of {}", t.name(least - nearest.begin()));
    info("        max of {}", t.name(greatest - nearest.begin()));
    printHistogram(nearest);
    const long close = std::count_if
    (
        nearest.begin(), nearest.end(), [](double d) { return d < overlap; }
    );
    if (close > 0)
    {
        found.bad
        (
            fmt::format
            (
                "{} particles overlap (nearer than {:g} h), the nearest {}",
                close, overlap, t.name(least - nearest.begin())
            )
        );
    }
    else
    {
        found.good("No particles overlap");
    }
}
