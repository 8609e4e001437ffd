#include "decomposition/blockDecomposition.H"
#include "decomposition/decomposition.H"

#include <fmt/format.h>

namespace gpuFsi
{

namespace
{

//- The rank of every block from a file in constant
class manualDecomposition
:
    public decomposition
{
public:

    explicit manualDecomposition(const decompositionInput& input)
    :
        file_
        (
            input.casePath/"constant"
           /input.coeffs("manual").get<std::string>("dataFile")
        ),
        ranks_(readBlockDecomposition(file_))
    {}

    std::vector<int> assign
    (
        const blockGrid& g,
        const std::vector<double>&,
        int nRanks
    ) const override
    {
        if (int(ranks_.size()) != g.count())
        {
            reject
            (
                fmt::format
                (
                    "There are ranks for {} blocks, but {} x {} x {} blocks",
                    ranks_.size(), g.n[0], g.n[1], g.n[2]
                )
            );
        }
        for (std::size_t b = 0; b < ranks_.size(); ++b)
        {
            if (ranks_[b] >= nRanks)
            {
                reject
                (
                    fmt::format
                    (
                        "Block {} is of rank {}, but there are {} ranks",
                        b, ranks_[b], nRanks
                    )
                );
            }
        }
        return ranks_;
    }

private:

    [[noreturn]] void reject(const std::string& message) const
    {
        throw userError
        (
            message,
            {file_.string()},
            "decomposeParticles -blockDist writes such a file with another"
            " method: edit that one."
        );
    }

    std::filesystem::path file_;
    std::vector<int> ranks_;
};

const decomposition::selection::add<manualDecomposition> add("manual");

} // namespace

} // namespace gpuFsi
