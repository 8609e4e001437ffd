// The communicator over MPI.

#include "parallel/communicator.H"

#include "base/error.H"

#include <mpi.h>
#if __has_include(<mpi-ext.h>)
#include <mpi-ext.h>
#endif

#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace gpuFsi
{

namespace
{

//- MPI counts are ints
constexpr std::size_t most = std::size_t(1) << 30;

constexpr int transferTag = 1;

//- f(offset, length) over pieces of at most `most` bytes
template<class F>
void inPieces(std::size_t bytes, const F& f)
{
    for (std::size_t at = 0; at < bytes; at += most)
    {
        f(at, int(std::min(most, bytes - at)));
    }
}

} // namespace


communicator::communicator(int& argc, char**& argv, bool parallel)
:
    parallel_(parallel)
{
    if (!parallel)
    {
        return;
    }
    int provided;
    MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &provided);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &size_);
}


communicator::~communicator()
{
    if (parallel_)
    {
        MPI_Finalize();
    }
}


std::vector<int> communicator::ranksOnNode() const
{
    if (!parallel_)
    {
        return {0};
    }
    MPI_Comm node;
    MPI_Comm_split_type
    (
        MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, rank_, MPI_INFO_NULL, &node
    );
    int n;
    MPI_Comm_size(node, &n);
    std::vector<int> ranks(n);
    MPI_Allgather(&rank_, 1, MPI_INT, ranks.data(), 1, MPI_INT, node);
    MPI_Comm_free(&node);
    return ranks;
}


int communicator::rankOnNode() const
{
    const std::vector<int> all = ranksOnNode();
    return int(std::find(all.begin(), all.end(), rank_) - all.begin());
}


bool communicator::takesDeviceMemory() const
{
#if defined(MPIX_CUDA_AWARE_SUPPORT)
    return parallel_ && MPIX_Query_cuda_support() == 1;
#else
    return false;
#endif
}


void communicator::barrier() const
{
    if (parallel_)
    {
        MPI_Barrier(MPI_COMM_WORLD);
    }
}


void communicator::sum(std::int64_t* values, std::size_t n) const
{
    if (parallel_)
    {
        MPI_Allreduce
        (
            MPI_IN_PLACE, values, int(n), MPI_INT64_T, MPI_SUM, MPI_COMM_WORLD
        );
    }
}


void communicator::max(double* values, std::size_t n) const
{
    if (parallel_)
    {
        MPI_Allreduce
        (
            MPI_IN_PLACE, values, int(n), MPI_DOUBLE, MPI_MAX, MPI_COMM_WORLD
        );
    }
}


void communicator::bitOr(std::uint64_t* values, std::size_t n) const
{
    if (parallel_)
    {
        MPI_Allreduce
        (
            MPI_IN_PLACE, values, int(n), MPI_UINT64_T, MPI_BOR, MPI_COMM_WORLD
        );
    }
}


void communicator::broadcast(std::vector<char>& bytes) const
{
    if (!parallel_)
    {
        return;
    }
    std::uint64_t n = bytes.size();
    MPI_Bcast(&n, 1, MPI_UINT64_T, 0, MPI_COMM_WORLD);
    bytes.resize(n);
    inPieces(n, [&](std::size_t at, int length)
    {
        MPI_Bcast(bytes.data() + at, length, MPI_BYTE, 0, MPI_COMM_WORLD);
    });
}


std::vector<std::vector<char>> communicator::gather
(
    const std::vector<char>& mine
) const
{
    std::vector<std::vector<char>> toEach(size_);
    toEach[0] = mine;
    auto all = exchange(toEach);
    if (!master())
    {
        all.clear();
    }
    return all;
}


std::vector<std::vector<char>> communicator::gatherAll
(
    const std::vector<char>& mine
) const
{
    auto all = gather(mine);
    all.resize(size_);
    for (int r = 0; r < size_; ++r)
    {
        broadcast(all[r]);
    }
    return all;
}


std::vector<std::vector<char>> communicator::exchange
(
    const std::vector<std::vector<char>>& toEach
) const
{
    if (!parallel_)
    {
        return toEach;
    }
    std::vector<std::uint64_t> out(size_), in(size_);
    for (int r = 0; r < size_; ++r)
    {
        out[r] = toEach[r].size();
    }
    MPI_Alltoall
    (
        out.data(), 1, MPI_UINT64_T, in.data(), 1, MPI_UINT64_T, MPI_COMM_WORLD
    );
    std::vector<std::vector<char>> fromEach(size_);
    transfer messages(*this);
    for (int r = 0; r < size_; ++r)
    {
        fromEach[r].resize(in[r]);
        if (r == rank_)
        {
            fromEach[r] = toEach[r];
            continue;
        }
        messages.receive(r, fromEach[r].data(), in[r]);
    }
    for (int r = 0; r < size_; ++r)
    {
        if (r != rank_)
        {
            messages.send(r, toEach[r].data(), out[r]);
        }
    }
    messages.wait();
    return fromEach;
}


struct communicator::transfer::requests
{
    std::vector<MPI_Request> all;
};


communicator::transfer::transfer(const communicator&)
:
    requests_(std::make_unique<requests>())
{}


communicator::transfer::~transfer()
{
    wait();
}


void communicator::transfer::receive(int from, void* to, std::size_t bytes)
{
    inPieces(bytes, [&](std::size_t at, int length)
    {
        requests_->all.emplace_back();
        MPI_Irecv
        (
            static_cast<char*>(to) + at, length, MPI_BYTE, from, transferTag,
            MPI_COMM_WORLD, &requests_->all.back()
        );
    });
}


void communicator::transfer::send(int to, const void* from, std::size_t bytes)
{
    inPieces(bytes, [&](std::size_t at, int length)
    {
        requests_->all.emplace_back();
        MPI_Isend
        (
            static_cast<const char*>(from) + at, length, MPI_BYTE, to,
            transferTag, MPI_COMM_WORLD, &requests_->all.back()
        );
    });
}


void communicator::transfer::wait()
{
    auto& all = requests_->all;
    if (!all.empty())
    {
        MPI_Waitall(int(all.size()), all.data(), MPI_STATUSES_IGNORE);
        all.clear();
    }
}


void communicator::abort() const
{
    std::fflush(nullptr);
    if (parallel_)
    {
        MPI_Abort(MPI_COMM_WORLD, 1);
    }
    std::exit(1);
}

} // namespace gpuFsi
