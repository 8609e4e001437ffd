// Weights of neighbours on the host.

#include "common/fluids.H"
#include "common/lattice.H"
#include "limits/stencil.H"

#include <gtest/gtest.h>

using namespace gpuFsi;

namespace
{

particleSchemes withWeights(int dimensions, int exponent)
{
    particleSchemes s = defaultSchemes(periodicBox(8, dimensions, 8));
    s.areaWeights = exponent > 0
      ? particleSchemes::weight::moment : particleSchemes::weight::radial;
    s.weightExponent = std::max(1, exponent);
    return s;
}

//- sum weight e_x e_x, which is 2 where the operators are exact
template<class Weight>
double second(const stencil& all, const Weight& weight)
{
    double sum = 0;
    for (const stencilNeighbour& n : all)
    {
        sum += weight(n)*n.e.x*n.e.x;
    }
    return sum;
}

} // namespace


TEST(stencil, exactOnALattice)
{
    for (const int D : {2, 3})
    {
        for (const int exponent : {0, 1, 3})
        {
            const stencil all = latticeStencil(withWeights(D, exponent), D);
            EXPECT_EQ(all.size(), D == 3 ? 26u : 8u);
            const auto check = [&](auto weight)
            {
                EXPECT_NEAR(second(all, weight), 2, 1e-12);
            };
            check([](const stencilNeighbour& n) { return n.gradient; });
            check([](const stencilNeighbour& n) { return n.divergence; });
            check([](const stencilNeighbour& n) { return n.laplacian; });
        }
    }
}


//- Moment weights stay exact, and first moments vanish
TEST(stencil, exactOffTheLattice)
{
    const particleSchemes schemes = withWeights(3, 3);
    stencil all = latticeStencil(schemes, 3);
    std::uint64_t k = 0;
    for (stencilNeighbour& n : all)
    {
        n.e += 0.2*vector{hashed(k), hashed(k + 1), hashed(k + 2)};
        n.u = std::sqrt(dot(n.e, n.e));
        k += 3;
    }
    EXPECT_TRUE(weigh(all, schemes, 3));
    double first = 0;
    for (const stencilNeighbour& n : all)
    {
        first += n.gradient*n.e.y;
    }
    EXPECT_NEAR(first, 0, 1e-12);
    EXPECT_NEAR
    (
        second(all, [](const stencilNeighbour& n) { return n.laplacian; }), 2,
        1e-12
    );
}


TEST(stencil, tooFewDirectionsFallBack)
{
    stencil line{{{1, 0, 0}, 1}, {{-1, 0, 0}, 1}, {{2, 0, 0}, 2}};
    EXPECT_FALSE(weigh(line, withWeights(2, 1), 2));
}


//- Neighbours half as far: sound twice, diffusion four times as fast
TEST(stencil, sumsGrowAsNeighboursComeNear)
{
    for (const int exponent : {0, 1, 3})
    {
        const particleSchemes schemes = withWeights(2, exponent);
        stencil all = latticeStencil(schemes, 2);
        const stencilSums before = stencilSums::of(all);
        for (stencilNeighbour& n : all)
        {
            n.e = 0.5*n.e;
            n.u *= 0.5;
        }
        weigh(all, schemes, 2);
        const stencilSums after = stencilSums::of(all);
        EXPECT_NEAR(after.sound/before.sound, 2, 1e-12);
        EXPECT_NEAR(after.diffusion/before.diffusion, 4, 1e-12);
    }
}
