#include "parallel/rankCheck.H"

#include "parallel/agreedError.H"

#include <fmt/format.h>

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
{}


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
