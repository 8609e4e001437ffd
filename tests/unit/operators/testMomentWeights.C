#include "common/lattice.H"
#include "operators/momentWeights.H"

#include <gtest/gtest.h>

using namespace gpuFsi;

namespace
{

//- Neighbours of one particle on a displaced lattice
template<class Real, int D>
struct ring
{
    std::vector<std::array<Real, D>> n;
    std::vector<Real> u;

    ring(double displace, int seed)
    {
        for (int z = D == 3 ? -1 : 0; z <= (D == 3 ? 1 : 0); ++z)
        for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x)
        {
            if (x || y || z)
            {
                const std::uint64_t k = 1000*seed + 3*u.size();
                const double p[3] =
                {
                    x + displace*hashed(k), y + displace*hashed(k + 1),
                    D == 3 ? z + displace*hashed(k + 2) : 0
                };
                const double d =
                    std::sqrt(p[0]*p[0] + p[1]*p[1] + p[2]*p[2]);
                u.push_back(Real(d));
                n.emplace_back();
                for (int i = 0; i < D; ++i)
                {
                    n.back()[i] = Real(p[i]/d);
                }
            }
        }
    }
};

template<class Real, int D>
momentWeights<Real, D> solve(const ring<Real, D>& r, int q, Real& singular)
{
    momentSums<Real, D> sums;
    for (std::size_t j = 0; j < r.u.size(); ++j)
    {
        Real e[D];
        for (int i = 0; i < D; ++i)
        {
            e[i] = r.u[j]*r.n[j][i];
        }
        sums.add(e, r.u[j], baseWeight(1/r.u[j], q == 3));
    }
    return sums.solve(singular);
}

//- Largest violation of sum A n = 0 and sum A d n n^T = 2 I
template<class Real, int D>
double violation(const ring<Real, D>& r, int q)
{
    Real singular;
    const auto weight = solve(r, q, singular);
    EXPECT_EQ(singular, 0);
    double first[D]{}, second[D][D]{};
    for (std::size_t k = 0; k < r.u.size(); ++k)
    {
        Real e[D];
        for (int i = 0; i < D; ++i)
        {
            e[i] = r.u[k]*r.n[k][i];
        }
        const double B = weight(e, r.u[k], baseWeight(1/r.u[k], q == 3));
        for (int i = 0; i < D; ++i)
        {
            // A n = B e, A d n n = B e e
            first[i] += B*e[i];
            for (int j = 0; j < D; ++j)
            {
                second[i][j] += B*e[i]*e[j];
            }
        }
    }
    double worst = 0;
    for (int i = 0; i < D; ++i)
    {
        worst = std::max(worst, std::abs(first[i]));
        for (int j = 0; j < D; ++j)
        {
            worst = std::max(worst, std::abs(second[i][j] - 2.0*(i == j)));
        }
    }
    return worst;
}

} // namespace

TEST(momentWeights, meetTheMomentConditions)
{
    for (int seed = 0; seed < 200; ++seed)
    {
        for (int q : {1, 3})
        {
            for (double displace : {0.0, 0.2, 0.35})
            {
                EXPECT_LT((violation(ring<double, 3>(displace, seed), q)),
                    1e-13);
                EXPECT_LT((violation(ring<double, 2>(displace, seed), q)),
                    1e-13);
                EXPECT_LT((violation(ring<float, 3>(displace, seed), q)),
                    2e-5);
                EXPECT_LT((violation(ring<float, 2>(displace, seed), q)),
                    2e-5);
            }
        }
    }
}

TEST(momentWeights, correctionIsZeroOnALattice)
{
    for (int q : {1, 3})
    {
        double singular;
        const auto w = solve(ring<double, 3>(0, 0), q, singular);
        for (double l : w.lambda)
        {
            EXPECT_NEAR(l, 0, 1e-14);
        }
    }
    // q = 1: the published gradient, A = 2D/(N d)
    double singular;
    const auto w = solve(ring<double, 3>(0, 0), 1, singular);
    const double e[3] = {1, 0, 0};
    EXPECT_NEAR(w(e, 1, 1), 6.0/26, 1e-14);
}

TEST(momentWeights, arePositiveAtModerateDisplacement)
{
    int negative = 0;
    for (int seed = 0; seed < 2000; ++seed)
    {
        const ring<double, 3> r(0.2, seed);
        double singular;
        const auto w = solve(r, 1, singular);
        for (std::size_t j = 0; j < r.u.size(); ++j)
        {
            const double u = r.u[j];
            const double e[3] = {u*r.n[j][0], u*r.n[j][1], u*r.n[j][2]};
            negative += w(e, u, baseWeight(1/u, false)) < 0;
        }
    }
    EXPECT_EQ(negative, 0);
}

TEST(momentWeights, tooFewDirectionsFallBack)
{
    // All neighbours in one plane: no second moment along z
    ring<double, 3> r(0, 0);
    for (std::size_t j = 0; j < r.u.size();)
    {
        if (r.n[j][2] != 0)
        {
            r.n.erase(r.n.begin() + j);
            r.u.erase(r.u.begin() + j);
        }
        else
        {
            ++j;
        }
    }
    double singular;
    const auto w = solve(r, 1, singular);
    EXPECT_EQ(singular, 1);
    for (double l : w.lambda)
    {
        EXPECT_EQ(l, 0);
    }
}
