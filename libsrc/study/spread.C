#include "study/spread.H"

#include <algorithm>

namespace gpuFsi
{

spread spread::of(std::vector<double> values)
{
    if (values.empty())
    {
        return {};
    }
    std::sort(values.begin(), values.end());
    const std::size_t n = values.size();
    return
    {
        0.5*(values[(n - 1)/2] + values[n/2]), values.front(), values.back()
    };
}

} // namespace gpuFsi
