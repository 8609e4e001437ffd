#include "decomposition/decomposition.H"
#include "decomposition/equalPieces.H"
#include "decomposition/hilbertCurve.H"

namespace gpuFsi
{

namespace
{

//- Pieces of a curve through all blocks: compact, and balanced to a block
class hilbertDecomposition
:
    public decomposition
{
public:

    explicit hilbertDecomposition(const decompositionInput&) {}

    std::vector<int> assign
    (
        const blockGrid& g,
        const std::vector<double>& weightOfBlock,
        int nRanks
    ) const override
    {
        const std::vector<int> curve = hilbertCurve(g.n);
        std::vector<double> weights(curve.size());
        for (std::size_t i = 0; i < curve.size(); ++i)
        {
            weights[i] = weightOfBlock[curve[i]];
        }
        const auto bounds = equalPieces(weights, nRanks);
        std::vector<int> ranks(curve.size());
        for (int r = 0; r < nRanks; ++r)
        {
            for (std::size_t i = bounds[r]; i < bounds[r + 1]; ++i)
            {
                ranks[curve[i]] = r;
            }
        }
        return ranks;
    }
};

const decomposition::selection::add<hilbertDecomposition> add("hilbert");

} // namespace

} // namespace gpuFsi
