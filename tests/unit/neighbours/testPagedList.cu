// Lists as a GPU reads them beside the whole numbers they were packed from.

#include "base/error.H"
#include "device/forEach.H"
#include "neighbours/pagedList.H"

#include <gtest/gtest.h>
#include <random>

using namespace gpuFsi;

namespace
{

//- Every neighbour by the passes' own loop, and one by one
template<int D, int atOnce, int n>
struct readBack
{
    neighbourView neighbours;
    int* looped;       // [k*size + i]
    int* single;
    int size;

    template<class Lane>
    FSI_HD void operator()(const typename Lane::index& i) const
    {
        // Particles whose neighbours are in another column read themselves
        int found[n];
        for (int m = 0; m < n; ++m)
        {
            found[m] = i;
        }
        int k = 0;
        forNeighbours<Lane, D, atOnce>(neighbours, i, [&](int j)
        {
            found[k] = j != i ? j : found[k];
            k = k + 1 < n ? k + 1 : 0;
        });
        Lane::forLanes(i, [&](int p, int)
        {
            for (int m = 0; m < n; ++m)
            {
                looped[m*size + p] = found[m];
                single[m*size + p] = neighbours.at(m, p);
            }
        });
    }
};

struct scene
{
    int size;
    int begin;         // particles before it have no list
    int range;         // packed at a time
    int reach;         // neighbours are so far away in storage
};

template<int D, int atOnce>
void comesBack(const scene& s)
{
    constexpr int n = D == 3 ? 26 : 8;
    std::mt19937 random(1);
    std::vector<int> list(std::size_t(s.size)*n);
    for (std::size_t m = 0; m < list.size(); ++m)
    {
        const int i = int(m % s.size);
        const int away = int(random() % (2*s.reach + 1)) - s.reach;
        list[m] = std::min(std::max(i + away, 0), s.size - 1);
    }
    const Buffer<int, cudaBackend> whole(list);
    Buffer<int, cudaBackend> looped(list.size()), single(list.size());
    pagedList<cudaBackend, n> packed;
    do
    {
        packed.start(s.size);
        for (int first = 0; first < s.size; first += s.range)
        {
            packed.pack
            ({
                whole.data() + first, std::size_t(s.size), first,
                std::max(first, s.begin), std::min(first + s.range, s.size)
            });
        }
    }
    while (!packed.finish());
    forEachLane<cudaBackend, float>
    (
        s.begin, s.size,
        readBack<D, atOnce, n>
        {
            packed.view(), looped.data(), single.data(), s.size
        }
    );
    const std::vector<int> a = looped.download(), b = single.download();
    for (std::size_t m = 0; m < list.size(); ++m)
    {
        if (int(m % s.size) >= s.begin)
        {
            ASSERT_EQ(a[m], list[m]) << "looped, entry " << m;
            ASSERT_EQ(b[m], list[m]) << "single, entry " << m;
        }
    }
}

void comesBack(const scene& s)
{
    if (!cudaBackend::available())
    {
        GTEST_SKIP() << "no GPU";
    }
    comesBack<3, 2>(s);
    comesBack<3, 4>(s);
    comesBack<2, 2>(s);
    comesBack<2, 4>(s);
}

} // namespace

TEST(cudaPagedList, onePage) { comesBack({2000, 0, 1 << 20, 100}); }

TEST(cudaPagedList, fewPagesInRanges) { comesBack({50000, 0, 4096, 20000}); }

TEST(cudaPagedList, pagesBeyondTheTable)
{
    comesBack({200003, 77, 1 << 16, 150000});
}

TEST(cudaPagedList, someGroupsBeyondTheTable)
{
    comesBack({150000, 5, 1 << 16, 33000});
}
