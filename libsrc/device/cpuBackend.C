#include "device/backend.H"

#include "base/largeBlocks.H"

#include <cstdlib>
#include <cstring>
#include <fstream>
#include <new>
#include <omp.h>

namespace gpuFsi
{

void* cpuBackend::allocate(std::size_t bytes)
{
    void* p = allocateBlock(bytes);
    if (!p)
    {
        throw std::bad_alloc();
    }
    return p;
}


void cpuBackend::release(void* p)
{
    std::free(p);
}


void* cpuBackend::allocatePinned(std::size_t bytes)
{
    return allocate(bytes);
}


void cpuBackend::releasePinned(void* p)
{
    release(p);
}


void cpuBackend::copyIn(void* to, const void* from, std::size_t bytes)
{
    std::memcpy(to, from, bytes);
}


void cpuBackend::copyOut(void* to, const void* from, std::size_t bytes)
{
    std::memcpy(to, from, bytes);
}


void cpuBackend::copy(void* to, const void* from, std::size_t bytes)
{
    std::memcpy(to, from, bytes);
}


void cpuBackend::fillBytes(void* to, int byte, std::size_t bytes)
{
    std::memset(to, byte, bytes);
}


std::string cpuBackend::describe()
{
    std::string model = "CPU";
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);)
    {
        if (line.rfind("model name", 0) == 0)
        {
            model = line.substr(line.find(':') + 2);
            break;
        }
    }
    const int threads = omp_get_max_threads();
    return model + ", " + std::to_string(threads)
        + (threads == 1 ? " thread" : " threads");
}

} // namespace gpuFsi
