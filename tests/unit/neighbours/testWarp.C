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
    std::size_t stride;
    std::vector<int> list, page, whole;
    std::vector<unsigned> words;
    int nWhole = 0;

    explicit lists(const scene& made)
    :
        s(made),
        stride((made.size + 31)/32*32),
        list(std::size_t(made.size)*n),
        page(stride/2, -12345678),
        whole(stride*n, -1),
        words(stride*n/2, 0xdeadbeef)
    {
        std::mt19937 random(1);
        for (std::size_t m = 0; m < list.size(); ++m)
        {
            const int i = int(m % s.size);
            const int away = int(random() % (2*s.reach + 1)) - s.reach;
            list[m] = std::min(std::max(i + away, 0), s.size - 1);
        }
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
            words.data(), page.data(), whole.data(), stride, &nWhole,
            int(stride/32)
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
        v.whole = whole.data();
        v.n = n;
        return v;
    }
};

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
            found.push_back(j);
        });
        Lane::forLanes(own, [&](int p, int)
        {
            for (int k = 0; k < n; ++k)
            {
                got[std::size_t(k)*s.size + p] = found[k];
            }
        });
    });
    return got;
}

template<int D, int atOnce>
void comesBack(const scene& s, bool whole)
{
    const lists<D> packed(s);
    const std::vector<int> got = looped<D, atOnce>(packed);
    EXPECT_EQ(packed.nWhole > 0, whole);
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
}

void comesBack(const scene& s, bool whole = false)
{
    comesBack<3, 2>(s, whole);
    comesBack<3, 4>(s, whole);
    comesBack<2, 2>(s, whole);
    comesBack<2, 4>(s, whole);
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

TEST(warp, readsWholeNumbersBeyondTheTable)
{
    comesBack({120003, 119500, 119511, 120003, 1 << 17, 110000}, true);
}
