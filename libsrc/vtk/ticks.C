#include "vtk/ticks.H"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gpuFsi
{

//- Keeps numbers at most four digits before the point and one after it
static int engineeringExponent(double largest)
{
    if (largest == 0 || (largest >= 0.01 && largest < 1e4))
    {
        return 0;
    }
    return 3*static_cast<int>(std::floor(std::log10(largest)/3));
}


tickMarks ticks(double lo, double hi, int about, double largest)
{
    const double rough = (hi - lo)/std::max(1, about);
    const double power = std::pow(10, std::floor(std::log10(rough)));
    const double lead = rough/power;
    const double step =
        power*(lead < 1.5 ? 1 : lead < 3.5 ? 2 : lead < 7.5 ? 5 : 10);

    tickMarks marks;
    marks.exponent = engineeringExponent
    (
        largest > 0 ? largest : std::max(std::abs(lo), std::abs(hi))
    );
    const double unit = std::pow(10, marks.exponent);
    const int decimals = std::max
    (
        0,
        -static_cast<int>(std::floor(std::log10(step/unit) + 1e-6))
    );
    constexpr double rounding = 1e-6;    // of a step: ends count as within
    const double first = std::ceil(lo/step - rounding);
    const double last = std::floor(hi/step + rounding);
    for (double k = first; k <= last; ++k)
    {
        // Adding 0 turns -0 into 0
        marks.at.push_back(k*step + 0.0);
        marks.labels.push_back
        (
            fmt::format("{:.{}f}", k*step/unit + 0.0, decimals)
        );
    }
    return marks;
}


std::string lengthLabel(const std::string& name, int exponent)
{
    const char* unit =
        exponent == 0 ? "m"
      : exponent == -3 ? "mm"
      : exponent == -6 ? "um"    // the font has no Greek
      : exponent == -9 ? "nm"
      : exponent == 3 ? "km"
      : nullptr;
    return unit
      ? fmt::format("{} [{}]", name, unit)
      : fmt::format("{} [1e{} m]", name, exponent);
}

} // namespace gpuFsi
