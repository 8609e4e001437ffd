#include "device/backend.H"
#include "device/cudaCheck.H"

#include <fmt/format.h>

namespace gpuFsi
{

void* cudaBackend::allocate(std::size_t bytes)
{
    void* p = nullptr;
    const cudaError_t status = cudaMalloc(&p, bytes);
    if (status == cudaErrorMemoryAllocation)
    {
        std::size_t free = 0, total = 0;
        cudaMemGetInfo(&free, &total);
        throw userError
        (
            fmt::format
            (
                "The GPU has {:.2f} GB free of {:.2f} GB; {:.2f} GB more "
                "are needed",
                free/1e9, total/1e9, bytes/1e9
            ),
            {},
            "Use fewer particles, precision single or backend cpu."
        );
    }
    cudaCheck(status);
    return p;
}


void cudaBackend::release(void* p)
{
    cudaFree(p);
}


void* cudaBackend::allocatePinned(std::size_t bytes)
{
    void* p = nullptr;
    cudaCheck(cudaMallocHost(&p, bytes));
    return p;
}


void cudaBackend::releasePinned(void* p)
{
    cudaFreeHost(p);
}


void cudaBackend::copyIn(void* to, const void* from, std::size_t bytes)
{
    cudaCheck(cudaMemcpy(to, from, bytes, cudaMemcpyHostToDevice));
}


void cudaBackend::copyOut(void* to, const void* from, std::size_t bytes)
{
    cudaCheck(cudaMemcpy(to, from, bytes, cudaMemcpyDeviceToHost));
}


void cudaBackend::copy(void* to, const void* from, std::size_t bytes)
{
    cudaCheck(cudaMemcpyAsync(to, from, bytes, cudaMemcpyDeviceToDevice));
}


void cudaBackend::fillBytes(void* to, int byte, std::size_t bytes)
{
    cudaCheck(cudaMemsetAsync(to, byte, bytes));
}


void cudaBackend::synchronize()
{
    cudaCheck(cudaDeviceSynchronize());
}


std::string cudaBackend::describe()
{
    int device = 0;
    cudaCheck(cudaGetDevice(&device));
    cudaDeviceProp card;
    cudaCheck(cudaGetDeviceProperties(&card, device));
    return fmt::format
    (
        "{}, {:.0f} GB", card.name, card.totalGlobalMem/1e9
    );
}


bool cudaBackend::available()
{
    int count = 0;
    return cudaGetDeviceCount(&count) == cudaSuccess && count > 0;
}


void cudaBackend::choose(int number)
{
    int count = 0;
    cudaCheck(cudaGetDeviceCount(&count));
    cudaCheck(cudaSetDevice(number % count));
}

} // namespace gpuFsi
