#include "solid/cellSprings.H"

#include "solid/symmetricSolve.H"

#include <cmath>

namespace gpuFsi
{

//- Below this part of its cube's value a constant is clipped
static constexpr double leastShare = 0.01;

//- Above this one, too: a few cells whose bonds have hardly enough directions
//  would set the step of a whole solid
static constexpr double mostShare = 10;

//- f(i, j, l) for the distinct components of a symmetric tensor of rank 4: how
//  often each direction occurs
template<class F>
static void forComponents(int D, const F& f)
{
    for (int i = 4; i >= 0; --i)
    {
        for (int j = 4 - i; j >= 0; --j)
        {
            const int l = 4 - i - j;
            if (D == 3 || l == 0)
            {
                f(i, j, l);
            }
        }
    }
}


//- The distinct components of n n n n, times the root of how often each occurs:
//  the plain norm of these is the tensor's
static std::vector<double> fourthMoment(const vector& n, int D)
{
    std::vector<double> m;
    forComponents(D, [&](int i, int j, int l)
    {
        const double often = 24
            /(std::tgamma(i + 1)*std::tgamma(j + 1)*std::tgamma(l + 1));
        m.push_back
        (
            std::sqrt(std::round(often))
           *std::pow(n.x, i)*std::pow(n.y, j)*std::pow(n.z, l)
        );
    });
    return m;
}


static std::vector<double> isotropicMoment(int D)
{
    std::vector<double> m;
    forComponents(D, [&](int i, int j, int l)
    {
        const bool even = i%2 == 0 && j%2 == 0;
        const bool pure = i == 4 || j == 4 || l == 4;
        m.push_back(!even ? 0 : pure ? 3 : std::sqrt(6.0));
    });
    return m;
}


int pairClass(int a, int b)
{
    return __builtin_popcount(unsigned(a^b)) - 1;
}


double cubeShare(int dimensions, int pairClass)
{
    return dimensions == 2 ? 1 : pairClass == 2 ? 1.0/4 : 1.0/3;
}


cellSprings isotropicSprings
(
    const std::vector<vector>& x,
    int dimensions,
    double volume,
    double mu
)
{
    const double side = dimensions == 2 ? 1 : std::cbrt(volume);
    std::vector<double> base;
    std::vector<std::vector<double>> rows;
    std::vector<double> missing = isotropicMoment(dimensions);
    const std::size_t m = missing.size();
    for (std::size_t a = 0; a < x.size(); ++a)
    {
        for (std::size_t b = a + 1; b < x.size(); ++b)
        {
            const vector d = x[b] - x[a];
            const double L2 = dot(d, d);
            base.push_back(side*cubeShare(dimensions, pairClass(a, b)));
            rows.push_back(fourthMoment((1/std::sqrt(L2))*d, dimensions));
            for (std::size_t i = 0; i < m; ++i)
            {
                rows.back()[i] *= L2/volume;
                missing[i] -= base.back()*rows.back()[i];
            }
        }
    }
    std::vector<double> matrix(m*m, 0);
    for (std::size_t p = 0; p < base.size(); ++p)
    {
        for (std::size_t i = 0; i < m; ++i)
        {
            for (std::size_t j = 0; j < m; ++j)
            {
                matrix[i*m + j] += base[p]*rows[p][i]*rows[p][j];
            }
        }
    }
    const std::vector<double> multiplier = leastSquares(matrix, missing);

    cellSprings springs;
    for (std::size_t p = 0; p < base.size(); ++p)
    {
        double factor = 1;
        for (std::size_t i = 0; i < m; ++i)
        {
            factor += multiplier[i]*rows[p][i];
        }
        if (factor < leastShare || factor > mostShare)
        {
            factor = factor < leastShare ? leastShare : mostShare;
            ++springs.nClipped;
        }
        springs.k.push_back(mu*base[p]*factor);
    }
    return springs;
}

} // namespace gpuFsi
