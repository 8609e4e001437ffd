#include "limits/latticeModes.H"

#include "limits/stencil.H"
#include "limits/smallMatrix.H"

#include "stepping/latticeViscosity.H"
#include "stepping/rkl2.H"

#include <cmath>

namespace gpuFsi
{

namespace
{

//- Per spacing (squared for laplacian); beta and c are not in the damping
struct symbols
{
    vector gradient{};      // of faces, from the densities themselves
    vector fromRows{};      // of faces, from gradients of the density
    vector divergence{};
    double laplacian = 0;
    double dampRho = 0;
    double dampU[3][3] = {};
};

vector plainGradient(const stencil& all, const vector& k)
{
    vector g{};
    for (const stencilNeighbour& n : all)
    {
        g += 0.5*n.gradient*std::sin(dot(k, n.e))*n.e;
    }
    return g;
}

symbols symbolsOf
(
    const stencil& all,
    const particleSchemes& schemes,
    const vector& k
)
{
    symbols s;
    const bool hermite = schemes.faces == particleSchemes::face::hermite;
    const double a = schemes.laplacianFactor;
    const vector rows = plainGradient(all, k);
    for (const stencilNeighbour& n : all)
    {
        const double sine = std::sin(dot(k, n.e));
        const double drop = 1 - std::cos(dot(k, n.e));
        const double along = dot(rows, n.e);
        const double ends = hermite ? along*drop/6 : 0;
        s.gradient += 0.5*n.gradient*sine*n.e;
        s.fromRows += n.gradient*ends*n.e;
        s.divergence += n.divergence*(0.5*sine + ends)*n.e;
        s.laplacian += n.laplacian
           *(hermite ? a*drop + 0.5*(1 - a)*along*sine : drop);

        const double jump = n.damping*(drop - 0.5*along*sine);
        s.dampRho += 0.5*jump*n.u;
        const double e[3] = {n.e.x, n.e.y, n.e.z};
        for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
        {
            s.dampU[i][j] += 0.5*jump*e[i]*e[j]/n.u;
        }
    }
    return s;
}

//- Changes of (r, v/h dt) in a step: by density and velocity as they stand,
//  and by gradients of the density, which are those of the step's begin
struct changes
{
    smallMatrix density;
    smallMatrix momentum;
    smallMatrix momentumByRows;
};

changes changesOf
(
    const symbols& s,
    int D,
    double beta,
    const stepNumbers& step
)
{
    changes m{{D + 1, {}}, {D + 1, {}}, {D + 1, {}}};
    const double gradient[3] = {s.gradient.x, s.gradient.y, s.gradient.z};
    const double rows[3] = {s.fromRows.x, s.fromRows.y, s.fromRows.z};
    const double divergence[3] =
        {s.divergence.x, s.divergence.y, s.divergence.z};
    const double damping = beta*step.acoustic;
    const double square = step.acoustic*step.acoustic;
    m.density.a[0][0] = -damping*s.dampRho;
    for (int i = 0; i < D; ++i)
    {
        m.density.a[0][i + 1] = -divergence[i];
        m.momentum.a[i + 1][0] = square*gradient[i];
        m.momentumByRows.a[i + 1][0] = square*rows[i];
        m.momentum.a[i + 1][i + 1] = -step.diffusion*s.laplacian;
        for (int j = 0; j < D; ++j)
        {
            m.momentum.a[i + 1][j + 1] -= damping*s.dampU[i][j];
        }
    }
    return m;
}

smallMatrix amplification
(
    const changes& m,
    particleSchemes::timeScheme scheme
)
{
    const smallMatrix one = smallMatrix::identity(m.density.n);
    if (scheme == particleSchemes::timeScheme::symplecticEuler)
    {
        // The density first (its gradients are kept), then velocity
        return one.plus(1, m.density).plus
        (
            1, m.momentum*one.plus(1, m.density)
        ).plus(1, m.momentumByRows);
    }
    const smallMatrix all =
        m.density.plus(1, m.momentum).plus(1, m.momentumByRows);
    const smallMatrix euler = one.plus(1, all);
    return scheme == particleSchemes::timeScheme::Euler
      ? euler : euler.plus(0.5, all*all);
}

//- In half a step
int stagesOf(const particleSchemes& schemes, int D, double diffusion)
{
    const auto even = latticeViscosity::of(D, schemes.weightExponent);
    return rkl2::stagesFor(diffusion/even.limit());
}

smallMatrix viscosityAlone(int D, double factor)
{
    smallMatrix m = smallMatrix::identity(D + 1);
    for (int i = 1; i <= D; ++i)
    {
        m.a[i][i] = factor;
    }
    return m;
}

} // namespace


double logAmplification
(
    const particleSchemes& schemes,
    int dimensions,
    const stepNumbers& step,
    int waves
)
{
    const stencil all = latticeStencil(schemes, dimensions);
    const int deep = dimensions == 3 ? waves : 0;
    const double half = 0.5*step.diffusion;
    const bool split = schemes.superSteps && half > 0;
    const int stages = split ? stagesOf(schemes, dimensions, half) : 0;
    const stepNumbers own{step.acoustic, split ? 0 : step.diffusion};
    double most = 0;
    for (int i = 0; i <= waves; ++i)
    for (int j = 0; j <= i; ++j)
    for (int l = 0; l <= std::min(j, deep); ++l)
    {
        const vector k = (M_PI/waves)*vector
        {
            double(i), double(j), double(l)
        };
        const symbols s = symbolsOf(all, schemes, k);
        const changes m =
            changesOf(s, dimensions, schemes.dissipation, own);
        smallMatrix all = amplification(m, schemes.time);
        if (split)
        {
            const smallMatrix v = viscosityAlone
            (
                dimensions, rkl2::factor(stages, -half*s.laplacian)
            );
            all = v*all*v;
        }
        most = std::max(most, all.logSpectralRadius());
    }
    return most;
}

} // namespace gpuFsi
