#include "parallel/rankState.H"

#include "parallel/agreedError.H"

#include <fmt/format.h>

namespace gpuFsi
{

template<class F>
static void forWallFields(hostState& s, const F& f)
{
    f(s.walls.positions);
    f(s.walls.U);
    f(s.walls.deltaRho);
    f(s.walls.mass);
    f(s.normals);
    f(s.area);
    f(s.patch);
    f(s.wallReference);
    f(s.wallNode);
}


template<class F>
static void forFluidFields(hostState& s, const F& f)
{
    f(s.fluid.positions);
    f(s.fluid.U);
    f(s.fluid.deltaRho);
    f(s.fluid.mass);
}


//- Every id from 0 on, once
static void checkIds(const std::vector<int>& ids, const char* cloud)
{
    std::vector<bool> there(ids.size(), false);
    for (int i : ids)
    {
        if (i < 0 || std::size_t(i) >= ids.size() || there[i])
        {
            throw agreedError
            (
                fmt::format
                (
                    "The processor directories hold {} particles of cloud {}, "
                    "but id {} is {}\n    Decompose the case again: they are "
                    "not of one decomposition.",
                    ids.size(), cloud, i,
                    i >= 0 && std::size_t(i) < ids.size()
                  ? "there twice" : "past them"
                ),
                false
            );
        }
        there[i] = true;
    }
}


template<class T>
static void sortById(std::vector<T>& values, const std::vector<int>& ids)
{
    if (values.empty())
    {
        return;
    }
    std::vector<T> sorted(values.size());
    for (std::size_t k = 0; k < ids.size(); ++k)
    {
        sorted[ids[k]] = values[k];
    }
    values = std::move(sorted);
}


void replicateWalls(const communicator& ranks, hostState& s)
{
    const std::vector<int> ids = gatherAll(ranks, s.wallId);
    checkIds(ids, "walls");
    forWallFields(s, [&](auto& values)
    {
        values = gatherAll(ranks, values);
        sortById(values, ids);
    });
}


hostState gatherState(const communicator& ranks, hostState s)
{
    const std::vector<int> walls = gatherOnMaster(ranks, s.wallId);
    const std::vector<int> fluid = gatherOnMaster(ranks, s.fluidId);
    forWallFields(s, [&](auto& values)
    {
        values = gatherOnMaster(ranks, values);
        sortById(values, walls);
    });
    forFluidFields(s, [&](auto& values)
    {
        values = gatherOnMaster(ranks, values);
        sortById(values, fluid);
    });
    s.partial = false;
    s.fluidId.clear();
    s.wallId.clear();
    return s;
}

} // namespace gpuFsi
