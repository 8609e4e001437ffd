// The communicator of a build without MPI.

#include "parallel/communicator.H"

#include "base/error.H"

#include <cstdlib>

namespace gpuFsi
{

communicator::communicator(int&, char**&, bool parallel)
{
    if (parallel)
    {
        throw userError
        (
            "This build has no MPI, so -parallel cannot be",
            {},
            "Install Open MPI (libopenmpi-dev) and run ./Allwmake again, or "
            "leave out -parallel."
        );
    }
}

communicator::~communicator() = default;

std::vector<int> communicator::ranksOnNode() const { return {0}; }
int communicator::rankOnNode() const { return 0; }
bool communicator::takesDeviceMemory() const { return false; }
void communicator::barrier() const {}
void communicator::sum(std::int64_t*, std::size_t) const {}
void communicator::max(double*, std::size_t) const {}
void communicator::bitOr(std::uint64_t*, std::size_t) const {}
void communicator::broadcast(std::vector<char>&) const {}

std::vector<std::vector<char>> communicator::gather
(
    const std::vector<char>& mine
) const
{
    return {mine};
}

std::vector<std::vector<char>> communicator::gatherAll
(
    const std::vector<char>& mine
) const
{
    return {mine};
}

std::vector<std::vector<char>> communicator::exchange
(
    const std::vector<std::vector<char>>& toEach
) const
{
    return toEach;
}

struct communicator::transfer::requests {};

communicator::transfer::transfer(const communicator&) {}
communicator::transfer::~transfer() = default;
void communicator::transfer::receive(int, void*, std::size_t) {}
void communicator::transfer::send(int, const void*, std::size_t) {}
void communicator::transfer::wait() {}

void communicator::abort() const
{
    std::exit(1);
}

} // namespace gpuFsi
