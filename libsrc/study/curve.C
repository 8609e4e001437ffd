#include "study/curve.H"

#include <algorithm>
#include <cmath>

namespace gpuFsi
{

namespace
{

double logRatio(double a, double b)
{
    return a > 0 && b > 0 ? std::log(a/b) : curvePoint::none;
}


//- ln(s1/s2), positive towards the finer
double refinement(const curvePoint& coarse, const curvePoint& fine)
{
    const bool spacings = coarse.run.h > 0 && fine.run.h > 0
     && coarse.run.h != fine.run.h;
    return spacings
      ? logRatio(coarse.run.h, fine.run.h)
      : std::fabs(logRatio(coarse.size, fine.size));
}


bool beats(const curvePoint& a, const curvePoint& b)
{
    return a.error <= b.error && a.seconds.median <= b.seconds.median
     && (a.error < b.error || a.seconds.median < b.seconds.median);
}

} // namespace


void addOrders(curve& c)
{
    for (std::size_t i = 1; i < c.points.size(); ++i)
    {
        const curvePoint& a = c.points[i - 1];
        curvePoint& b = c.points[i];
        const double gain = logRatio(a.error, b.error);
        const double step = refinement(a, b);
        b.order = step != 0 ? gain/step : curvePoint::none;
        // Of an error that hardly falls it would say nothing
        b.slope = gain > 0.05
          ? logRatio(b.seconds.median, a.seconds.median)/gain
          : curvePoint::none;
    }
}


void markPareto(std::vector<curve>& curves, const std::string& machine)
{
    std::vector<curvePoint*> points;
    for (curve& c : curves)
    {
        for (curvePoint& p : c.points)
        {
            if (p.run.machine == machine)
            {
                points.push_back(&p);
            }
        }
    }
    for (curvePoint* p : points)
    {
        p->pareto = std::none_of
        (
            points.begin(), points.end(),
            [p](const curvePoint* other) { return beats(*other, *p); }
        );
    }
}


std::optional<reach> secondsToReach(const curve& c, double error)
{
    std::optional<reach> best;
    const auto offer = [&](double seconds, bool atMost)
    {
        if (!best || seconds < best->seconds)
        {
            best = reach{seconds, atMost};
        }
    };
    if (!c.points.empty() && c.points[0].error <= error)
    {
        offer(c.points[0].seconds.median, true);
    }
    for (std::size_t i = 1; i < c.points.size(); ++i)
    {
        const curvePoint& a = c.points[i - 1];
        const curvePoint& b = c.points[i];
        if (a.error > error && b.error <= error)
        {
            const double part =
                b.error > 0 ? std::log(a.error/error)/std::log(a.error/b.error)
                            : 1;
            const double from = a.seconds.median, to = b.seconds.median;
            offer
            (
                from > 0 && to > 0 ? from*std::pow(to/from, part) : to, false
            );
        }
    }
    return best;
}


std::vector<std::string> machinesOf(const curve& c)
{
    std::vector<std::string> machines;
    for (const curvePoint& p : c.points)
    {
        if (std::find(machines.begin(), machines.end(), p.run.machine)
         == machines.end())
        {
            machines.push_back(p.run.machine);
        }
    }
    return machines;
}

} // namespace gpuFsi
