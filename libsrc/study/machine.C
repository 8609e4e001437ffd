#include "study/machine.H"

#include <fmt/format.h>
#include <fstream>
#include <thread>

namespace gpuFsi
{

std::string machineName()
{
    std::ifstream file("/proc/cpuinfo");
    std::string line;
    while (std::getline(file, line))
    {
        const std::size_t colon = line.find(": ");
        if (line.compare(0, 10, "model name") == 0 && colon != line.npos)
        {
            return fmt::format
            (
                "{}, {} threads", line.substr(colon + 2),
                std::thread::hardware_concurrency()
            );
        }
    }
    return fmt::format
    (
        "unknown processor, {} threads", std::thread::hardware_concurrency()
    );
}

} // namespace gpuFsi
