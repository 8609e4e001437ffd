#include "functionObjects/errorNorms.H"

#include "base/sum.H"

#include <cmath>

namespace gpuFsi
{

norms normsOf
(
    const std::vector<double>& size,
    const std::vector<double>& volume
)
{
    const std::size_t n = size.size();
    norms result;
    const double total =
        pairwiseSum(0, n, [&](std::size_t i) { return volume[i]; });
    result.L1 = pairwiseSum
    (
        0, n, [&](std::size_t i) { return volume[i]*size[i]; }
    )/total;
    result.L2 = std::sqrt
    (
        pairwiseSum
        (
            0, n, [&](std::size_t i) { return volume[i]*size[i]*size[i]; }
        )/total
    );
    for (double e : size)
    {
        if (!(e <= result.Linf))
        {
            result.Linf = e;
        }
        if (std::isnan(e))
        {
            break;
        }
    }
    return result;
}


std::vector<double> distances
(
    const std::vector<double>& a,
    const std::vector<double>& b,
    int nComponents
)
{
    std::vector<double> result(a.size()/nComponents);
    for (std::size_t i = 0; i < result.size(); ++i)
    {
        double square = 0;
        for (int k = 0; k < nComponents; ++k)
        {
            const double d = a[nComponents*i + k] - b[nComponents*i + k];
            square += d*d;
        }
        result[i] = std::sqrt(square);
    }
    return result;
}

} // namespace gpuFsi
