#include "common/lattice.H"
#include "neighbours/neighbourList.H"

#include <gtest/gtest.h>

#include <limits>

using namespace gpuFsi;

namespace
{

template<class Real>
particleStore<cpuBackend, Real> storeOf
(
    const hostState& s,
    const frame& space,
    int nWalls = 0
)
{
    particleStore<cpuBackend, Real> p;
    p.allocate(nWalls, int(s.fluid.size()) - nWalls);
    for (std::size_t i = 0; i < s.fluid.size(); ++i)
    {
        p.place[0].data()[i] = space.place<Real>(s.fluid.positions[i], Real(0));
        p.id.data()[i] = int(i);
    }
    return p;
}

//- All particles as candidates, for every particle
template<class Real, int D>
std::vector<int> bruteForce
(
    const particleStore<cpuBackend, Real>& p,
    const frame& space,
    double radius
)
{
    const vector q = space.quantum<Real>();
    const double unit = finder<Real, D>::unit/radius;
    std::vector<int> list(std::size_t(p.size)*nDirections<D>);
    const auto far = [&](double quantum)
    {
        const double most =
            0.99*double(std::numeric_limits<coordinateOf<Real>>::max());
        return coordinateOf<Real>(std::min(most, 1.01*radius/quantum));
    };
    const finder<Real, D> f
    {
        p.place[0].data(), p.id.data(), p.nWalls,
        {q.x*unit, q.y*unit, q.z*unit}, {far(q.x), far(q.y), far(q.z)},
        list.data(), std::size_t(p.size), 0
    };
    for (int i = 0; i < p.size; ++i)
    {
        f.select(i, [&](const auto& offer)
        {
            for (int j = 0; j < p.size; ++j)
            {
                offer(j);
            }
        });
    }
    return list;
}

//- Of n particles' lists one after the other by direction, as bruteForce has them
template<class List>
int entry(const List& list, int n, int m)
{
    return list.view().at(m/n, m % n);
}

template<class Real, int D>
void compareWithBruteForce(int n, double displace, bool periodic, int nWalls)
{
    domain d = periodicBox(n, D, 1);
    if (!periodic)
    {
        d.periodic = {false, false, false};
    }
    const frame space = frame::of(d);
    const auto p =
        storeOf<Real>(latticeState(d, 0, 1, displace), space, nWalls);
    const double radius = d.spacing*(D == 3 ? 2.43 : 2.77);
    neighbourList<cpuBackend, Real, D> list(d, space, radius, false);
    list.searchCells(p);
    const std::vector<int> expected = bruteForce<Real, D>(p, space, radius);
    for (int m = 0; m < p.size*nDirections<D>; ++m)
    {
        ASSERT_EQ(entry(list, p.size, m), expected[m]) << "entry " << m;
    }
}

} // namespace

TEST(neighbourList, cellSearchIsBruteForce3D)
{
    for (double displace : {0.0, 0.2, 0.5})
    {
        for (bool periodic : {true, false})
        {
            compareWithBruteForce<float, 3>(9, displace, periodic, 0);
            compareWithBruteForce<double, 3>(7, displace, periodic, 100);
        }
    }
}

TEST(neighbourList, cellSearchIsBruteForceInNarrowPeriods)
{
    for (int n : {3, 4, 5, 6})
    {
        compareWithBruteForce<double, 3>(n, 0.1, true, 0);
        compareWithBruteForce<float, 2>(n, 0.1, true, 0);
    }
}

TEST(neighbourList, cellSearchIsBruteForce2D)
{
    for (double displace : {0.0, 0.2, 0.5})
    {
        compareWithBruteForce<float, 2>(20, displace, true, 0);
        compareWithBruteForce<double, 2>(20, displace, false, 60);
    }
}

TEST(neighbourList, singleAndDoubleFindTheSameNeighbours)
{
    const domain d = periodicBox(12, 3, 15);
    const frame space = frame::of(d);
    const hostState s = latticeState(d, 0, 1, 0.2);
    neighbourList<cpuBackend, float, 3> a(d, space, 2.43*d.spacing, false);
    neighbourList<cpuBackend, double, 3> b(d, space, 2.43*d.spacing, false);
    const auto pa = storeOf<float>(s, space);
    const auto pb = storeOf<double>(s, space);
    a.searchCells(pa);
    b.searchCells(pb);
    int different = 0;
    for (int m = 0; m < pa.size*26; ++m)
    {
        different += entry(a, pa.size, m) != entry(b, pb.size, m);
    }
    EXPECT_LE(different, pa.size*26/10000);
}

TEST(neighbourList, localUpdateFollowsADeformingLattice)
{
    const domain d = periodicBox(16, 3, 1);
    const frame space = frame::of(d);
    hostState s = latticeState(d, 0, 1, 0.1);
    const double radius = 2.43*d.spacing;
    neighbourList<cpuBackend, double, 3> local(d, space, radius, true);
    local.searchCells(storeOf<double>(s, space));

    // Shear by 0.05 h a stage, to 0.5 h
    long same = 0, all = 0;
    for (int stage = 0; stage < 10; ++stage)
    {
        for (vector& x : s.fluid.positions)
        {
            x.x += 0.05*d.spacing*std::sin(2*M_PI*x.y);
        }
        const auto p = storeOf<double>(s, space);
        local.updateLocally(p);
        neighbourList<cpuBackend, double, 3> fresh(d, space, radius, false);
        fresh.searchCells(p);
        for (int m = 0; m < p.size*26; ++m, ++all)
        {
            same += entry(local, p.size, m) == entry(fresh, p.size, m);
        }
    }
    EXPECT_GT(double(same)/all, 0.999);
}

TEST(frame, fileRoundTripIsExact)
{
    const domain box = periodicBox(30, 3, 15);
    domain closed = box;
    closed.periodic = {false, true, false};
    for (const domain& d : {box, closed})
    {
        const frame f = frame::of(d);
        for (int i = 0; i < 100000; ++i)
        {
            const vector x{7.5*hashed(3*i), 7.5*hashed(3*i + 1),
                7.5*hashed(3*i + 2)};
            const auto p = f.place<double>(x, 0.0);
            const auto again = f.place<double>(f.position(p), 0.0);
            ASSERT_EQ(p.x, again.x);
            ASSERT_EQ(p.y, again.y);
            ASSERT_EQ(p.z, again.z);
            const auto s = f.place<float>(x, 0.0f);
            const auto t = f.place<float>(f.position(s), 0.0f);
            ASSERT_EQ(s.x, t.x);
            ASSERT_NEAR(f.position(p).x, x.x, 15*4/std::ldexp(1.0, 48));
        }
    }
}

TEST(frame, latticeDifferencesAreExact)
{
    domain d = periodicBox(30, 3, 15);
    d.periodic = {false, false, false};
    const frame f = frame::of(d);
    const auto a = f.place<float>({-7.5 + 3.5*0.5, 0.25, 0.25}, 0.0f);
    const auto b = f.place<float>({-7.5 + 4.5*0.5, 0.25, 0.25}, 0.0f);
    EXPECT_EQ((b.x - a.x)*f.quantum<float>().x, 0.5);
}
