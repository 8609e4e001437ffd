#include "parallel/rankCheck.H"

#include "parallel/agreedError.H"

#include <fmt/format.h>

#include <limits>

namespace gpuFsi
{

static rankContents overAll(const communicator& ranks, const rankContents& own)
{
    std::int64_t sums[4] = {own.walls, own.fluid, own.ids, own.mixed};
    ranks.sum(sums, 4);
    return {sums[0], sums[1], sums[2], sums[3]};
}


rankCheck::rankCheck(const communicator& ranks, const rankContents& own)
:
    expected_(overAll(ranks, own))
{
    const std::int64_t n = expected_.walls + expected_.fluid;
    if (n > std::numeric_limits<int>::max())
    {
        throw agreedError
        (
            fmt::format
            (
                "{} particles are more than the {} that there may be\n    Use a "
                "coarser spacing.", n, std::numeric_limits<int>::max()
            ),
            false
        );
    }
    // Ids count from 0
    if (std::uint64_t(expected_.ids) != std::uint64_t(n)*std::uint64_t(n + 1)/2)
    {
        throw agreedError
        (
            fmt::format
            (
                "The processor directories are not of one decomposition: among "
                "the ids of their {} particles some are missing or double\n"
                "    Decompose the case again.", n
            ),
            false
        );
    }
}


void rankCheck::compare(const communicator& ranks, const rankContents& own) const
{
    const rankContents now = overAll(ranks, own);
    if (now.walls != expected_.walls || now.fluid != expected_.fluid)
    {
        throw agreedError
        (
            fmt::format
            (
                "Particles were lost between the ranks: {} fluid and {} wall "
                "particles were {} and {} at the start\n    The last time "
                "written is intact. Please report this.",
                now.fluid, now.walls, expected_.fluid, expected_.walls
            ),
            false
        );
    }
    if (now.ids != expected_.ids || now.mixed != expected_.mixed)
    {
        throw agreedError
        (
            "The ranks' particles are as many as at the start, but their ids "
            "are others: some are held twice\n    The last time written is "
            "intact. Please report this.",
            false
        );
    }
}

} // namespace gpuFsi
