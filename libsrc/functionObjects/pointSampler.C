#include "functionObjects/pointSampler.H"

#include "functionObjects/localFit.H"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gpuFsi
{

namespace
{

pointSampler::scheme schemeOf(const dictionary& dict)
{
    const std::string word = dict.getChoiceOrDefault
    (
        "interpolationScheme",
        "movingLeastSquares",
        {"nearest", "Shepard", "movingLeastSquares"}
    );
    return word == "nearest" ? pointSampler::scheme::nearest
        : word == "Shepard" ? pointSampler::scheme::Shepard
        : pointSampler::scheme::movingLeastSquares;
}

//- Wendland's kernel of q = distance/(reach h)
double kernel(double q)
{
    const double s = (1 - q)*(1 - q);
    return s*s*(4*q + 1);
}

} // namespace


pointSampler::pointSampler
(
    const dictionary& dict,
    std::vector<vector> points
)
:
    scheme_(schemeOf(dict)),
    walls_(dict.getOrDefault<bool>("includeWalls", true)),
    points_(std::move(points)),
    stencils_(points_.size())
{}


std::int64_t pointSampler::cellOf(const vector& p, const vector& shift) const
{
    const auto cell = [&](double x, double s)
    {
        return std::int64_t(std::floor(x/radius_) + s) & 0x1fffff;
    };
    const std::int64_t z = dimensions_ == 3 ? cell(p.z, shift.z) : 0;
    return cell(p.x, shift.x) | cell(p.y, shift.y) << 21 | z << 42;
}


void pointSampler::offer(std::size_t particle, const vector& p)
{
    const auto found = cells_.find(cellOf(p, {0, 0, 0}));
    if (found == cells_.end())
    {
        return;
    }
    for (std::size_t i : found->second)
    {
        vector d = (1/radius_)*(p - points_[i]);
        d.z = dimensions_ == 3 ? d.z : 0;
        const double q2 = dot(d, d);
        if (q2 < 1)
        {
            stencils_[i].push_back({particle, d, kernel(std::sqrt(q2))});
        }
    }
}


void pointSampler::update(const hostState& state)
{
    dimensions_ = state.dimensions;
    nFluid_ = state.fluid.size();
    if (radius_ != reach*state.h)
    {
        radius_ = reach*state.h;
        cells_.clear();
        const int deep = dimensions_ == 3 ? 1 : 0;
        for (std::size_t i = 0; i < points_.size(); ++i)
        {
            for (int cell = 0; cell < (deep ? 27 : 9); ++cell)
            {
                const vector shift
                {
                    cell%3 - 1.0, cell/3%3 - 1.0, deep*(cell/9 - 1.0)
                };
                cells_[cellOf(points_[i], shift)].push_back(i);
            }
        }
    }
    for (auto& stencil : stencils_)
    {
        stencil.clear();
    }
    for (std::size_t i = 0; i < nFluid_; ++i)
    {
        offer(i, state.fluid.positions[i]);
    }
    if (walls_)
    {
        for (std::size_t i = 0; i < state.walls.size(); ++i)
        {
            offer(nFluid_ + i, state.walls.positions[i]);
        }
    }
    for (auto& stencil : stencils_)
    {
        if (!stencil.empty())
        {
            weigh(stencil);
        }
    }
}


void pointSampler::weigh(std::vector<link>& stencil) const
{
    if (scheme_ == scheme::nearest)
    {
        const auto nearest = std::max_element
        (
            stencil.begin(),
            stencil.end(),
            [](const link& a, const link& b) { return a.weight < b.weight; }
        );
        stencil = {{nearest->particle, nearest->offset, 1}};
        return;
    }
    if
    (
        scheme_ == scheme::movingLeastSquares
     && (leastSquares(stencil, 2) || leastSquares(stencil, 1))
    )
    {
        return;
    }
    double total = 0;
    for (const link& l : stencil)
    {
        total += l.weight;
    }
    for (link& l : stencil)
    {
        l.weight /= total;
    }
}


bool pointSampler::leastSquares(std::vector<link>& stencil, int order) const
{
    // Solve M lambda = e_0, M = sum w q q^T with the polynomials q of the
    // offset: the weights w lambda.q then reproduce them at offset 0
    const int n = nPolynomials(dimensions_, order);
    spdSystem m;
    for (const link& l : stencil)
    {
        const polynomials q = polynomialsOf(l.offset, dimensions_);
        for (int a = 0; a < n; ++a)
        {
            for (int b = 0; b <= a; ++b)
            {
                m.at[a][b] += l.weight*q[a]*q[b];
            }
        }
    }
    polynomials lambda;
    if (!m.solveFirst(n, lambda))
    {
        return false;
    }
    std::vector<double> weights;
    double magnitude = 0;
    for (const link& l : stencil)
    {
        const polynomials q = polynomialsOf(l.offset, dimensions_);
        double w = 0;
        for (int a = 0; a < n; ++a)
        {
            w += lambda[a]*q[a];
        }
        weights.push_back(w*l.weight);
        magnitude += std::abs(weights.back());
    }
    if (!(magnitude < 4))
    {
        return false;
    }
    for (std::size_t i = 0; i < stencil.size(); ++i)
    {
        stencil[i].weight = weights[i];
    }
    return true;
}


std::vector<double> pointSampler::values
(
    const std::vector<double>& fluid,
    const std::vector<double>& walls,
    int nComponents
) const
{
    std::vector<double> result(nComponents*points_.size(), 0);
    for (std::size_t i = 0; i < points_.size(); ++i)
    {
        for (int k = 0; k < nComponents; ++k)
        {
            double& value = result[nComponents*i + k];
            if (stencils_[i].empty())
            {
                value = std::numeric_limits<double>::quiet_NaN();
            }
            for (const link& l : stencils_[i])
            {
                const bool wall = l.particle >= nFluid_;
                const std::size_t j = wall ? l.particle - nFluid_ : l.particle;
                value += l.weight*(wall ? walls : fluid)[nComponents*j + k];
            }
        }
    }
    return result;
}

} // namespace gpuFsi
