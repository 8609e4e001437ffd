// The lists as a GPU packs and reads them, its warps played by threads of the
// CPU: what testPagedList.cu runs on a GPU.

#include "common/warpOnCpu.H"

#include "device/neighbourView.H"
#include "neighbours/packGroups.H"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace gpuFsi;

namespace
{

struct scene
{
    int size;
    int begin;               // particles before it have no list
    int loopBegin, loopEnd;  // of the loop that reads
    int range;               // packed at a time
    int reach;               // neighbours are so far away in storage
};

template<int D>
struct lists
{
    static constexpr int n = D == 3 ? 26 : 8;

    scene s;
    int own;               // columns, one a group
    int room = 0;          // for further ones
    int nMore;
    std::size_t stride;
    std::vector<int> list, page;
    std::vector<unsigned> words;

    explicit lists(const scene& made)
    :
        s(made),
        own((made.size + 31)/32),
        list(std::size_t(made.size)*n)
    {
        std::mt19937 random(1);
        for (std::size_t m = 0; m < list.size(); ++m)
        {
            const int i = int(m % s.size);
            const int away = int(random() % (2*s.reach + 1)) - s.reach;
            list[m] = std::min(std::max(i + away, 0), s.size - 1);
        }
        packAll();
        if (nMore > room)
        {
            room = nMore;
            packAll();
        }
    }

    void packAll()
    {
        nMore = 0;
        stride = 32*std::size_t(own + room);
        page.assign(stride, -12345678);
        words.assign(stride*n/2, 0xdeadbeef);
        for (int first = 0; first < s.size; first += s.range)
        {
            const packing from
            {
                list.data() + first, std::size_t(s.size), first,
                std::max(first, s.begin), std::min(first + s.range, s.size)
            };
            if (from.begin < from.end)
            {
                pack(from);
            }
        }
    }

    void pack(const packing& from)
    {
        const packedLists to
        {
            words.data(), page.data(), stride, own, &nMore, room
        };
        const int first = from.begin/32, end = (from.end + 31)/32;
        warpOnCpu::launch((end - first)*32, [&]
        {
            packGroups<n>(from, to, first, end);
        });
    }

    neighbourView view() const
    {
        neighbourView v;
        v.stride = stride;
        v.words = words.data();
        v.page = page.data();
        v.n = n;
        return v;
    }
};

//- What a particle read, n entries a column: its neighbours in one of them,
//  itself in the others
std::vector<int> joined(const std::vector<int>& found, int n, int self)
{
    std::vector<int> neighbours(n, self);
    int columns = 0;
    for (std::size_t first = 0; first < found.size(); first += n)
    {
        bool others = false;
        for (int k = 0; k < n; ++k)
        {
            const int j = found[first + k];
            others = others || j != self;
            neighbours[k] = j != self ? j : neighbours[k];
        }
        columns += others;
    }
    EXPECT_LE(columns, 1) << "particle " << self;
    return neighbours;
}

//- As forEachLaneKernel, and a pass in it
template<int D, int atOnce>
std::vector<int> looped(const lists<D>& packed)
{
    using Lane = warpLane<float>;
    constexpr int n = lists<D>::n;
    const scene& s = packed.s;
    const neighbourView view = packed.view();
    std::vector<int> got(packed.list.size(), -1);
    const int aligned = s.loopBegin/32*32;
    warpOnCpu::launch(s.loopEnd - aligned, [&]
    {
        const int i = aligned + blockIdx.x*blockDim.x + threadIdx.x;
        const int within = std::min(std::max(i, s.loopBegin), s.loopEnd - 1);
        const Lane::index own(within, i);
        std::vector<int> found;
        forNeighbours<Lane, D, atOnce>(view, own, [&](int j)
        {
            EXPECT_GE(j, 0);
            EXPECT_LT(j, s.size);
            found.push_back(j);
        });
        Lane::forLanes(own, [&](int p, int)
        {
            const std::vector<int> j = joined(found, n, p);
            for (int k = 0; k < n; ++k)
            {
                got[std::size_t(k)*s.size + p] = j[k];
            }
        });
    });
    return got;
}

template<int D, int atOnce>
void comesBack(const scene& s, bool more)
{
    const lists<D> packed(s);
    const std::vector<int> got = looped<D, atOnce>(packed);
    EXPECT_EQ(packed.nMore > 0, more);
    for (std::size_t m = 0; m < got.size(); ++m)
    {
        const int i = int(m % s.size);
        const bool read = i >= s.loopBegin && i < s.loopEnd;
        ASSERT_EQ(got[m], read ? packed.list[m] : -1) << "entry " << m;
        if (read)
        {
            ASSERT_EQ(packed.view().at(int(m/s.size), i), packed.list[m]);
        }
    }
    for (int i = s.loopBegin; i < s.loopEnd; ++i)
    {
        int count = 0;
        for (int k = 0; k < lists<D>::n; ++k)
        {
            count += packed.list[std::size_t(k)*s.size + i] != i;
        }
        ASSERT_EQ(packed.view().count(i), count) << "particle " << i;
    }
}

void comesBack(const scene& s, bool more = false)
{
    comesBack<3, 2>(s, more);
    comesBack<3, 4>(s, more);
    comesBack<2, 2>(s, more);
    comesBack<2, 4>(s, more);
}

} // namespace

TEST(warp, readsListsOfOnePage) { comesBack({700, 0, 0, 700, 1 << 20, 100}); }

//- A loop that begins and ends within groups
TEST(warp, readsFewPagesPackedInRanges)
{
    comesBack({30003, 29100, 29205, 29990, 1 << 12, 20000});
}

TEST(warp, readsPartsOfAGroupForTwoLoops)
{
    comesBack({1003, 77, 77, 500, 1 << 16, 900});
    comesBack({1003, 77, 500, 1003, 1 << 16, 900});
}

TEST(warp, readsFurtherColumns)
{
    comesBack({120003, 119930, 119941, 120003, 1 << 17, 110000}, true);
}
