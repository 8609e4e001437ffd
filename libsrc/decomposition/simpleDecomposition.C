#include "decomposition/decomposition.H"
#include "decomposition/equalPieces.H"

#include <fmt/format.h>

#include <algorithm>

namespace gpuFsi
{

namespace
{

//- Some of the blocks, from lo to below hi in each direction
struct blockBox
{
    int lo[3], hi[3];

    template<class Visit>
    void each(const Visit& visit) const
    {
        for (int z = lo[2]; z < hi[2]; ++z)
        for (int y = lo[1]; y < hi[1]; ++y)
        for (int x = lo[0]; x < hi[0]; ++x)
        {
            const int at[3] = {x, y, z};
            visit(at);
        }
    }
};

//- Slabs of equal weight in one direction, each cut in the next, each of these
//  in the third. Rank x + nx (y + ny z), as OpenFOAM counts.
class simpleDecomposition
:
    public decomposition
{
public:

    explicit simpleDecomposition(const decompositionInput& input)
    {
        const dictionary& coeffs = input.coeffs("simple");
        where_ = coeffs.where("n");
        n_ = coeffs.get<std::vector<int>>("n");
        if
        (
            n_.size() != 3
         || *std::min_element(n_.begin(), n_.end()) < 1
        )
        {
            throw userError
            (
                "n must hold three positive whole numbers",
                where_,
                "As 'n (2 2 1);': ranks along x, y and z."
            );
        }
        const std::string order = coeffs.getChoiceOrDefault
        (
            "order", "xyz", {"xyz", "xzy", "yxz", "yzx", "zxy", "zyx"}
        );
        for (int i = 0; i < 3; ++i)
        {
            order_[i] = order[i] - 'x';
        }
    }

    std::vector<int> assign
    (
        const blockGrid& g,
        const std::vector<double>& weightOfBlock,
        int nRanks
    ) const override
    {
        checkRanks(nRanks);
        std::vector<int> ranks(g.count());
        const blockBox all{{0, 0, 0}, {g.n[0], g.n[1], g.n[2]}};
        cut(g, weightOfBlock, all, 0, 0, ranks);
        return ranks;
    }

private:

    void checkRanks(int nRanks) const
    {
        const long product = long(n_[0])*n_[1]*n_[2];
        if (product != nRanks)
        {
            throw userError
            (
                fmt::format
                (
                    "n ({} {} {}) makes {} ranks, but there are {}",
                    n_[0], n_[1], n_[2], product, nRanks
                ),
                where_,
                "The product of n must be numberOfSubdomains."
            );
        }
    }

    void cut
    (
        const blockGrid& g,
        const std::vector<double>& weightOfBlock,
        const blockBox& box,
        int level,
        int rank,
        std::vector<int>& ranks
    ) const
    {
        if (level == 3)
        {
            box.each([&](const int (&at)[3])
            {
                ranks[g.index(at[0], at[1], at[2])] = rank;
            });
            return;
        }
        const int d = order_[level];
        const int stride[3] = {1, n_[0], n_[0]*n_[1]};
        std::vector<double> layers(box.hi[d] - box.lo[d], 0);
        box.each([&](const int (&at)[3])
        {
            layers[at[d] - box.lo[d]] +=
                weightOfBlock[g.index(at[0], at[1], at[2])];
        });
        const auto bounds = equalPieces(layers, n_[d]);
        for (int p = 0; p < n_[d]; ++p)
        {
            blockBox slab = box;
            slab.lo[d] = box.lo[d] + int(bounds[p]);
            slab.hi[d] = box.lo[d] + int(bounds[p + 1]);
            cut(g, weightOfBlock, slab, level + 1, rank + p*stride[d], ranks);
        }
    }

    std::vector<int> n_;
    int order_[3];
    sourceSpan where_;    // of n
};

const decomposition::selection::add<simpleDecomposition> add("simple");

} // namespace

} // namespace gpuFsi
