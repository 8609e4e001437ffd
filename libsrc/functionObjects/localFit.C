#include "functionObjects/localFit.H"

#include <cmath>

namespace gpuFsi
{

bool spdSystem::solveFirst(int n, polynomials& x)
{
    const double least = 1e-6*at[0][0];
    for (int a = 0; a < n; ++a)
    {
        for (int b = 0; b <= a; ++b)
        {
            for (int k = 0; k < b; ++k)
            {
                at[a][b] -= at[a][k]*at[b][k];
            }
            if (a > b)
            {
                at[a][b] /= at[b][b];
            }
        }
        if (!(at[a][a] > least))
        {
            return false;
        }
        at[a][a] = std::sqrt(at[a][a]);
    }
    x = {1};
    for (int a = 0; a < n; ++a)
    {
        for (int k = 0; k < a; ++k)
        {
            x[a] -= at[a][k]*x[k];
        }
        x[a] /= at[a][a];
    }
    for (int a = n - 1; a >= 0; --a)
    {
        for (int k = a + 1; k < n; ++k)
        {
            x[a] -= at[k][a]*x[k];
        }
        x[a] /= at[a][a];
    }
    return true;
}

} // namespace gpuFsi
