// Values that go to the copies of particles on other ranks.

#include "theRanks.H"

#include "parallel/haloExchange.H"

#include <gtest/gtest.h>

using namespace gpuFsi;

namespace
{

//- Every rank has 100 particles, sends rank p those whose number divides by
//  p + 2, and holds copies of what the others send behind its own
struct ring
{
    static constexpr int nOwn = 100;

    std::vector<int> neighbours;
    std::vector<std::vector<int>> from;    // numbers, by neighbour
    haloPlan<cpuBackend> plan;

    static std::vector<int> seenBy(int rank)
    {
        std::vector<int> numbers;
        for (int i = 0; i < nOwn; i += rank + 2)
        {
            numbers.push_back(i);
        }
        return numbers;
    }

    ring()
    {
        const communicator& c = *theRanks;
        std::vector<int> sent;
        for (int r = 0; r < c.size(); ++r)
        {
            if (r == c.rank())
            {
                continue;
            }
            neighbours.push_back(r);
            const auto out = seenBy(r);
            sent.insert(sent.end(), out.begin(), out.end());
            plan.sendBegin.push_back(int(sent.size()));
            from.push_back(seenBy(c.rank()));
            plan.receiveBegin.push_back
            (
                plan.receiveBegin.back() + int(from.back().size())
            );
            plan.remoteBegin.push_back(0);
        }
        plan.sent = Buffer<int, cpuBackend>(sent);
        plan.first = nOwn;
    }

    int size() const { return nOwn + plan.nReceived(); }
};

double valueOf(int rank, int i, int field)
{
    return 1000*rank + i + 0.25*field;
}

} // namespace


TEST(haloExchange, copiesGetTheOwnersValues)
{
    const ring r;
    haloExchange<cpuBackend> exchange(*theRanks, true, true);
    exchange.prepare(0, r.neighbours);
    for (int round = 0; round < 5; ++round)
    {
        std::vector<double> a(r.size(), -1), b(r.size(), -1);
        for (int i = 0; i < ring::nOwn; ++i)
        {
            a[i] = valueOf(theRanks->rank(), i, round);
            b[i] = valueOf(theRanks->rank(), i, round + 7);
        }
        double* const fields[2] = {a.data(), b.data()};
        exchange.begin(r.plan, r.neighbours, fields);
        // What is packed may change at once
        std::fill_n(a.begin(), ring::nOwn, 0.0);
        exchange.finish(r.plan, fields);
        int k = ring::nOwn;
        for (std::size_t p = 0; p < r.neighbours.size(); ++p)
        {
            for (int i : r.from[p])
            {
                EXPECT_EQ(a[k], valueOf(r.neighbours[p], i, round));
                EXPECT_EQ(b[k], valueOf(r.neighbours[p], i, round + 7));
                ++k;
            }
        }
        EXPECT_EQ(k, r.size());
    }
    const double once = 16.0*r.plan.nSent();
    EXPECT_EQ(exchange.bytesSent(), 5*once);
}


TEST(haloExchange, withoutNeighboursNothingHappens)
{
    const haloPlan<cpuBackend> nobody;
    haloExchange<cpuBackend> exchange(*theRanks, true, true);
    exchange.prepare(0, {});
    double value = 3;
    double* const field[1] = {&value};
    exchange.begin(nobody, {}, field);
    exchange.finish(nobody, field);
    EXPECT_EQ(value, 3);
    EXPECT_EQ(exchange.bytesSent(), 0);
}
