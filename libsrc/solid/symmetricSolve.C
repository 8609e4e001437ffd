#include "solid/symmetricSolve.H"

#include <algorithm>
#include <cmath>

namespace gpuFsi
{

//- Makes a[p][q] zero and turns the columns of v along
static void rotate
(
    std::vector<double>& a,
    std::vector<double>& v,
    std::size_t n,
    std::size_t p,
    std::size_t q
)
{
    const double theta = (a[q*n + q] - a[p*n + p])/(2*a[p*n + q]);
    const double t =
        (theta >= 0 ? 1 : -1)/(std::fabs(theta) + std::hypot(theta, 1));
    const double c = 1/std::hypot(t, 1), s = t*c;
    for (std::size_t i = 0; i < n; ++i)
    {
        const double x = a[i*n + p], y = a[i*n + q];
        a[i*n + p] = c*x - s*y;
        a[i*n + q] = s*x + c*y;
    }
    for (std::size_t i = 0; i < n; ++i)
    {
        const double x = a[p*n + i], y = a[q*n + i];
        a[p*n + i] = c*x - s*y;
        a[q*n + i] = s*x + c*y;
        const double u = v[i*n + p], w = v[i*n + q];
        v[i*n + p] = c*u - s*w;
        v[i*n + q] = s*u + c*w;
    }
}


std::vector<double> leastSquares
(
    std::vector<double> a,
    const std::vector<double>& b
)
{
    const std::size_t n = b.size();
    std::vector<double> v(n*n, 0);
    double largest = 0;
    for (std::size_t i = 0; i < n; ++i)
    {
        v[i*n + i] = 1;
        largest = std::max(largest, a[i*n + i]);
    }
    int sweeps = 0;
    for (bool turned = true; turned && sweeps < 30; ++sweeps)
    {
        turned = false;
        for (std::size_t p = 0; p < n; ++p)
        {
            for (std::size_t q = p + 1; q < n; ++q)
            {
                if (std::fabs(a[p*n + q]) > 1e-15*largest)
                {
                    rotate(a, v, n, p, q);
                    turned = true;
                }
            }
        }
    }
    std::vector<double> x(n, 0);
    for (std::size_t e = 0; e < n; ++e)
    {
        if (a[e*n + e] <= 1e-10*largest)
        {
            continue;
        }
        double along = 0;
        for (std::size_t i = 0; i < n; ++i)
        {
            along += v[i*n + e]*b[i];
        }
        for (std::size_t i = 0; i < n; ++i)
        {
            x[i] += along/a[e*n + e]*v[i*n + e];
        }
    }
    return x;
}

} // namespace gpuFsi
