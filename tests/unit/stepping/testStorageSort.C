// The bulk stored anew while particles move: the same bytes, in an order along
// the curve.

#include "common/column.H"
#include "common/fluids.H"
#include "common/vortex.H"
#include "neighbours/neighbourList.H"
#include "stepping/hostParticles.H"
#include "stepping/storageSort.H"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <set>

using namespace gpuFsi;

namespace
{

constexpr double never = std::numeric_limits<double>::infinity();

struct scene
{
    domain space;
    fluidProperties fluid;
    particleSchemes schemes;
    hostState state;
    double dt;
    int steps;
    bool ledger = false;
};

scene vortices(int dimensions, int steps)
{
    scene s{};
    s.space = periodicBox(dimensions == 3 ? 12 : 40, dimensions, 1);
    s.fluid = publishedFluid(0.05);
    s.fluid.c = 10;
    s.schemes = defaultSchemes(s.space);
    s.state = vortexState(s.space, 1, 0.2);
    s.dt = 0.1*s.space.spacing/s.fluid.c;
    s.steps = steps;
    return s;
}

void useAllTerms(particleSchemes& s)
{
    s.areaWeights = particleSchemes::weight::moment;
    s.faces = particleSchemes::face::hermite;
    s.time = particleSchemes::timeScheme::symplecticEuler;
    s.dissipation = 0.2;
    s.shifting = 0.5;
}

//- A wall that goes to and fro, and fluid that flows along it
scene channel()
{
    scene s{};
    s.space = columnDomain(24, 12, 1);
    s.fluid = publishedFluid(0.01);
    s.fluid.c = 10;
    s.fluid.g = vector{0.1, 0, 0};
    s.fluid.motions.resize(2);
    s.fluid.motions[0] = wallMotion::make(dictionary::fromString
    (
        "type oscillation; amplitude (0.02 0 0); omega 3; phase 0;", "wall"
    ));
    s.schemes = defaultSchemes(s.space);
    useAllTerms(s.schemes);
    s.state = columnState(s.space);
    for (std::size_t i = 0; i < s.state.fluid.size(); ++i)
    {
        const double x = s.state.fluid.positions[i].x;
        s.state.fluid.U[i].y = 4*x*(1 - x);
    }
    s.dt = 0.1*s.space.spacing/s.fluid.c;
    s.steps = 800;
    return s;
}

struct outcome
{
    hostState state;
    long sorts;
};

//- Writes as the solver does: neighbours fresh every so many steps
outcome run
(
    const scene& s,
    double sortDistance,
    const char* precision,
    int writeEvery = 0
)
{
    particleSchemes schemes = s.schemes;
    schemes.sortDistance = sortDistance;
    schemes.sortWear = 0;
    const auto solver = fluidSolver::make
    (
        "cpu", precision, s.space, s.fluid, schemes, s.state
    );
    if (s.ledger)
    {
        solver->keepLedger();
    }
    for (int k = 0; k < s.steps; ++k)
    {
        solver->step(k*s.dt, s.dt);
        if (solver->maintenanceDue())
        {
            solver->maintain();
        }
        if (writeEvery && (k + 1) % writeEvery == 0)
        {
            solver->maintain();
            solver->refreshNeighbours();
        }
    }
    solver->maintain();
    return {solver->download(), solver->nSorts()};
}

bool sameBytes(const particleSet& a, const particleSet& b)
{
    const auto same = [](const auto& u, const auto& v)
    {
        return u.size() == v.size()
          && std::memcmp(u.data(), v.data(), u.size()*sizeof(u[0])) == 0;
    };
    return same(a.positions, b.positions) && same(a.U, b.U)
      && same(a.deltaRho, b.deltaRho);
}

void expectSameBytes(const scene& s, int writeEvery = 0)
{
    for (const char* precision : {"single", "double"})
    {
        const outcome a = run(s, never, precision, writeEvery);
        const outcome b = run(s, 0.4, precision, writeEvery);
        EXPECT_EQ(a.sorts, 0);
        EXPECT_GE(b.sorts, 3) << precision;
        EXPECT_TRUE(sameBytes(a.state.fluid, b.state.fluid)) << precision;
        EXPECT_TRUE(sameBytes(a.state.walls, b.state.walls)) << precision;
    }
}

//- Carried by the vortex for so many spacings of the fastest
hostState carried(const domain& d, double spacings)
{
    hostState s = vortexState(d, 1, 0.2);
    const double k = 2*std::acos(-1.0)/(d.hi.x - d.lo.x);
    const int steps = int(20*spacings);
    for (vector& x : s.fluid.positions)
    {
        for (int step = 0; step < steps; ++step)
        {
            const auto u = [k](const vector& at)
            {
                return vector
                {
                    std::sin(k*at.x)*std::cos(k*at.y),
                    -std::cos(k*at.x)*std::sin(k*at.y), 0
                };
            };
            const vector middle = x + 0.025*d.spacing*u(x);
            x = x + 0.05*d.spacing*u(middle);
        }
    }
    return s;
}

template<int D>
using lists = neighbourList<cpuBackend, double, D>;

template<int D>
lists<D> listsOf
(
    const domain& d,
    const frame& space,
    const particleStore<cpuBackend, double>& p
)
{
    lists<D> list(d, space, defaultSchemes(d).searchRadius, false);
    list.searchCells(p);
    return list;
}

//- Mean distance in storage between the bulk and its neighbours
template<int D>
double meanDistance
(
    const particleStore<cpuBackend, double>& p,
    const lists<D>& list
)
{
    double sum = 0;
    for (int i = p.nWalls; i < p.size; ++i)
    {
        for (int k = 0; k < nDirections<D>; ++k)
        {
            sum += std::abs(list.view().at(k, i) - i);
        }
    }
    return sum/(p.size - p.nWalls)/nDirections<D>;
}

//- As storageSort has it, of the same sample
template<int D>
double linesBySets
(
    const particleStore<cpuBackend, double>& p,
    const lists<D>& list
)
{
    double sum = 0;
    int groups = 0;
    for (int i = p.nWalls; i + 32 <= p.size; i += 16*32)
    {
        ++groups;
        for (int k = 0; k < nDirections<D>; ++k)
        {
            std::set<int> lines;
            for (int lane = 0; lane < 32; ++lane)
            {
                lines.insert(list.view().at(k, i + lane)/8);
            }
            sum += lines.size();
        }
    }
    return sum/groups/nDirections<D>;
}

void upload
(
    const domain& d,
    const frame& space,
    const hostState& state,
    particleStore<cpuBackend, double>& p
)
{
    hostParticles<cpuBackend, double>(space, d, hostState(state), nullptr)
        .upload(p);
}

//- As if the state had been at these places since it was read
hostState movedTo(hostState state, const hostState& places)
{
    state.fluid.positions = places.fluid.positions;
    return state;
}

template<int D>
void expectOrderOfTheCurve(int n)
{
    const domain d = periodicBox(n, D, 1);
    const frame space = frame::of(d);
    const hostState start = carried(d, 0);
    const hostState later = carried(d, 0.5*n);

    // Stored as at the start, at the places of later
    particleStore<cpuBackend, double> p, fresh;
    upload(d, space, start, p);
    const std::vector<int> id = p.id.download();
    std::vector<placeRho<double>> place;
    for (const int i : id)
    {
        place.push_back(space.place<double>(later.fluid.positions[i], i));
    }
    p.place[p.now.place].upload(place);
    upload(d, space, movedTo(start, later), fresh);

    using sorter = storageSort<cpuBackend, double, D>;
    sorter sort(d, space, particleSchemes());
    sort.moved(4.01*d.spacing);
    const lists<D> worn = listsOf<D>(d, space, p);
    const double stale = meanDistance(p, worn);
    EXPECT_DOUBLE_EQ(sorter::lines(p, worn.view()), linesBySets(p, worn));
    sort.sortIfDue(p, worn.view());
    EXPECT_EQ(sort.count(), 1);
    const double sorted = meanDistance(p, listsOf<D>(d, space, p));
    const double ideal = meanDistance(fresh, listsOf<D>(d, space, fresh));
    const std::string name = std::to_string(D) + "D";
    testing::Test::RecordProperty("stale" + name, std::to_string(stale));
    testing::Test::RecordProperty("sorted" + name, std::to_string(sorted));
    EXPECT_LT(sorted, 0.9*stale);
    EXPECT_LT(sorted, 1.01*ideal);

    // Everyone is there, each with what is its own
    std::vector<char> seen(p.size, 0);
    const auto ids = p.id.download();
    const auto places = p.place[p.now.place].download();
    const auto velocities = p.velocity[p.now.velocity].download();
    for (int i = 0; i < p.size; ++i)
    {
        EXPECT_EQ(seen[ids[i]]++, 0);
        EXPECT_EQ(places[i].deltaRho, ids[i]);
        EXPECT_EQ(velocities[i].x, start.fluid.U[ids[i]].x);
    }
}

} // namespace

TEST(storageSort, sameBytesInAVortex)
{
    for (const int D : {2, 3})
    {
        scene s = vortices(D, D == 3 ? 200 : 400);
        expectSameBytes(s);
        useAllTerms(s.schemes);
        expectSameBytes(s);
    }
}


TEST(storageSort, sameBytesBesideMovingWalls)
{
    expectSameBytes(channel());
}


TEST(storageSort, sameBytesByEveryTimeScheme)
{
    for (const auto time : {particleSchemes::timeScheme::Euler,
        particleSchemes::timeScheme::RK2})
    {
        scene s = vortices(2, 400);
        useAllTerms(s.schemes);
        s.schemes.time = time;
        expectSameBytes(s);
    }
}


//- The local update's lists are by storage index: sorted only where a write has
//  all neighbours searched
TEST(storageSort, waitsForAWholeSearch)
{
    scene s = vortices(2, 400);
    s.schemes.method = particleSchemes::search::localUpdate;
    EXPECT_EQ(run(s, 0.4, "double").sorts, 0);
    expectSameBytes(s, 50);
}


TEST(storageSort, doesNotSortWhatALedgerIsKeptOf)
{
    scene s = vortices(2, 400);
    useAllTerms(s.schemes);
    s.ledger = true;
    EXPECT_EQ(run(s, 0.4, "double").sorts, 0);
}


//- Four spacings, counted anew after each sort; not where the order is good
TEST(storageSort, isDueByDistance)
{
    const domain d = periodicBox(32, 2, 1);
    const frame space = frame::of(d);
    particleStore<cpuBackend, double> p;
    upload(d, space, latticeState(d, 0, 1), p);
    const lists<2> list = listsOf<2>(d, space, p);
    particleSchemes schemes;
    storageSort<cpuBackend, double, 2> unworn(d, space, schemes);
    unworn.moved(1000*d.spacing);
    unworn.sortIfDue(p, list.view());
    EXPECT_EQ(unworn.count(), 0);
    schemes.sortWear = 0;
    storageSort<cpuBackend, double, 2> sort(d, space, schemes);
    for (const long sorts : {0, 1, 1, 2, 2, 3})
    {
        sort.moved(2.1*d.spacing);
        sort.sortIfDue(p, list.view());
        EXPECT_EQ(sort.count(), sorts);
    }
}


TEST(storageSort, ordersAlongTheCurve)
{
    expectOrderOfTheCurve<2>(64);
    expectOrderOfTheCurve<3>(24);
}


TEST(storageSort, leavesWallsWhereTheyAre)
{
    const domain d = columnDomain(24, 12, 1);
    const frame space = frame::of(d);
    particleStore<cpuBackend, double> p;
    upload(d, space, columnState(d), p);
    const std::vector<int> id = p.id.download();
    const std::vector<placeRho<double>> place =
        p.place[p.now.place].download();
    particleSchemes schemes;
    schemes.sortWear = 0;
    storageSort<cpuBackend, double, 2> sort(d, space, schemes);
    sort.moved(1);
    sort.sortIfDue(p, listsOf<2>(d, space, p).view());
    EXPECT_EQ(sort.count(), 1);
    const std::vector<int> after = p.id.download();
    for (int i = 0; i < p.nWalls; ++i)
    {
        EXPECT_EQ(after[i], id[i]);
        EXPECT_EQ(p.presentPlace()[i].x, place[i].x);
        EXPECT_EQ(p.presentPlace()[i].y, place[i].y);
    }
}
