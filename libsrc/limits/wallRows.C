#include "limits/wallRows.H"

#include "limits/stencil.H"

#include <array>
#include <cmath>
#include <complex>

namespace gpuFsi
{

namespace
{

//- Rows; those in the middle are as between no walls
constexpr int nRows = 8;

using number = std::complex<double>;
using row = std::array<number, nRows>;
using matrix = std::array<row, nRows>;

//- A row's neighbours; y is across the rows, walls are rows -1 and nRows
stencil neighboursOf
(
    int r,
    const particleSchemes& schemes,
    int dimensions,
    double gap
)
{
    const auto height = [gap](int at)
    {
        return at < 0 ? -gap : at == nRows ? nRows - 1 + gap : double(at);
    };
    const int deep = dimensions == 3 ? 1 : 0;
    stencil all;
    for (int k = -deep; k <= deep; ++k)
    for (int j = -1; j <= 1; ++j)
    for (int i = -1; i <= 1; ++i)
    {
        if (i != 0 || j != 0 || k != 0)
        {
            const vector e{double(i), height(r + j) - height(r), double(k)};
            all.push_back({e, std::sqrt(dot(e, e))});
        }
    }
    weigh(all, schemes, dimensions);
    return all;
}

int rowOf(int r, const vector& e)
{
    return e.y > 0 ? r + 1 : e.y < 0 ? r - 1 : r;
}

bool isWall(int r) { return r < 0 || r == nRows; }

number phase(const vector& k, const vector& e)
{
    return std::polar(1.0, k.x*e.x + k.z*e.z);
}

using stencils = std::array<stencil, nRows>;

double component(const vector& e, int axis)
{
    return axis == 0 ? e.x : axis == 1 ? e.y : e.z;
}

//- Of velocity against walls at rest, by component
std::array<matrix, 3> gradients(const stencils& all, const vector& k)
{
    std::array<matrix, 3> g{};
    for (int r = 0; r < nRows; ++r)
    {
        for (const stencilNeighbour& n : all[r])
        {
            const int to = rowOf(r, n.e);
            for (int axis = 0; axis < 3; ++axis)
            {
                const double w = 0.5*n.gradient*component(n.e, axis);
                g[axis][r][r] -= w;
                if (!isWall(to))
                {
                    g[axis][r][to] += w*phase(k, n.e);
                }
            }
        }
    }
    return g;
}

matrix laplacian
(
    const stencils& all,
    const vector& k,
    double a
)
{
    const std::array<matrix, 3> g = gradients(all, k);
    matrix m{};
    for (int r = 0; r < nRows; ++r)
    {
        for (const stencilNeighbour& n : all[r])
        {
            const int to = rowOf(r, n.e);
            const bool wall = isWall(to);
            m[r][r] -= a*n.laplacian;
            if (!wall)
            {
                m[r][to] += a*n.laplacian*phase(k, n.e);
            }
            for (int axis = 0; axis < 3; ++axis)
            {
                const double w =
                    0.5*(1 - a)*n.laplacian*component(n.e, axis);
                for (int c = 0; c < nRows; ++c)
                {
                    const number other =
                        wall ? g[axis][r][c] : phase(k, n.e)*g[axis][to][c];
                    m[r][c] += w*(g[axis][r][c] + other);
                }
            }
        }
    }
    return m;
}

//- By Gelfand: the norm of m^(2^12), over 2^12
double spectralRadius(matrix m)
{
    constexpr int squarings = 12;
    double log = 0;
    for (int s = 0; s <= squarings; ++s)
    {
        double size = 0;
        for (const row& r : m)
        for (const number& v : r)
        {
            size = std::max(size, std::abs(v));
        }
        log = 2*log + std::log(size);
        matrix square{};
        for (int i = 0; i < nRows; ++i)
        for (int j = 0; j < nRows; ++j)
        {
            m[i][j] /= size;
        }
        for (int i = 0; i < nRows; ++i)
        for (int l = 0; l < nRows; ++l)
        for (int j = 0; j < nRows; ++j)
        {
            square[i][j] += m[i][l]*m[l][j];
        }
        m = square;
    }
    return std::exp(std::ldexp(log, -squarings));
}

} // namespace


double wallRowsRate
(
    const particleSchemes& schemes,
    int dimensions,
    double gap
)
{
    stencils all;
    for (int r = 0; r < nRows; ++r)
    {
        all[r] = neighboursOf(r, schemes, dimensions, gap);
    }
    const double a = schemes.faces == particleSchemes::face::hermite
      ? schemes.laplacianFactor : 1;
    constexpr int waves = 4;
    const int deep = dimensions == 3 ? waves : 0;
    double most = 0;
    for (int i = 0; i <= waves; ++i)
    for (int l = 0; l <= std::min(i, deep); ++l)
    {
        const vector k{i*M_PI/waves, 0, l*M_PI/waves};
        most = std::max(most, spectralRadius(laplacian(all, k, a)));
    }
    return most;
}

} // namespace gpuFsi
