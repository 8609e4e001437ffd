#include "base/largeBlocks.H"

#include <cstdlib>
#include <new>
#include <sys/mman.h>

namespace gpuFsi
{

static constexpr std::size_t line = 64;
static constexpr std::size_t largePage = std::size_t(2) << 20;
static constexpr std::size_t largeBlock = std::size_t(8) << 20;

static std::size_t roundedUp(std::size_t bytes, std::size_t unit)
{
    return (bytes + unit - 1)/unit*unit;
}


void* allocateBlock(std::size_t bytes)
{
    const bool large = bytes >= largeBlock;
    const std::size_t unit = large ? largePage : line;
    const std::size_t size = roundedUp(bytes, unit);
    void* p = size >= bytes ? std::aligned_alloc(unit, size) : nullptr;
    if (p && large)
    {
        // Advice: where it is not taken, pages are small
        madvise(p, size, MADV_HUGEPAGE);
    }
    return p;
}


static void* allocateOnce(std::size_t bytes)
{
    return bytes >= largeBlock
      ? allocateBlock(bytes) : std::malloc(bytes > 0 ? bytes : 1);
}

} // namespace gpuFsi


void* operator new(std::size_t bytes)
{
    for (;;)
    {
        if (void* p = gpuFsi::allocateOnce(bytes))
        {
            return p;
        }
        const std::new_handler handler = std::get_new_handler();
        if (!handler)
        {
            throw std::bad_alloc();
        }
        handler();
    }
}


void operator delete(void* p) noexcept
{
    std::free(p);
}


void operator delete(void* p, std::size_t) noexcept
{
    std::free(p);
}
