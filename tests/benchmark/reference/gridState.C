#include "gridState.H"

#include <algorithm>
#include <cmath>

namespace gpuFsi
{

gridState::gridState(int n, double length)
:
    n_(n),
    stride_(n + 2*ghosts),
    h_(length/n)
{
    for (auto& f : fields_)
    {
        f.assign(stride_*stride_*stride_, 0);
    }
}


void gridState::wrapRow(double* field, int j, int k) const
{
    const auto inside = [this](int i) { return (i + n_) % n_; };
    const long row = index(0, j, k);
    const long from = index(0, inside(j), inside(k));
    if (row != from)
    {
        std::copy_n(field + from, n_, field + row);
    }
    for (int g = 1; g <= ghosts; ++g)
    {
        field[row - g] = field[row + n_ - g];
        field[row + n_ - 1 + g] = field[row - 1 + g];
    }
}


void gridState::wrap()
{
    // Rows of other rows' copies read points alone, so any order will do
    const int m = n_ + ghosts;
    #pragma omp parallel for schedule(static) collapse(2)
    for (int k = -ghosts; k < m; ++k)
    {
        for (int j = -ghosts; j < m; ++j)
        {
            for (int f = 0; f < nFields; ++f)
            {
                wrapRow(field(f), j, k);
            }
        }
    }
}


bool gridState::finite() const
{
    return std::all_of(fields_.begin(), fields_.end(), [](const auto& f)
    {
        return std::all_of
        (
            f.begin(), f.end(), [](double x) { return std::isfinite(x); }
        );
    });
}

} // namespace gpuFsi
