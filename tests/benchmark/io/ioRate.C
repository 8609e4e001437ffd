// Binary time folders, written and read as the solver does, beside dd with as
// many bytes in the same run: neither waits until a disk has them. Reading from
// the page cache, and with -cold from the disk. dd reads into one buffer of 8 MB
// that stays in a cache; what keeps the bytes must put them into new memory, so
// there is such a reader to compare with, too.
// Usage: ioRate -help

#include "base/error.H"
#include "base/largeBlocks.H"
#include "base/log.H"
#include "benchmark/step/seconds.H"
#include "case/argList.H"
#include "common/lattice.H"
#include "particles/stateIO.H"

#include <algorithm>
#include <cstdlib>
#include <fcntl.h>
#include <memory>
#include <unistd.h>

using namespace gpuFsi;
namespace fs = std::filesystem;

namespace
{

//- What DIRECTORY holds, and what dd has written beside it
struct places
{
    fs::path time, plain;
};

void dd(const std::string& arguments)
{
    if (std::system(("dd bs=8M status=none " + arguments).c_str()) != 0)
    {
        throw userError
        (
            "dd " + arguments + " failed", {}, "Is there space on the disk?"
        );
    }
}

//- All of a file into new memory
void keep(const fs::path& file)
{
    const std::size_t size = fs::file_size(file);
    const std::unique_ptr<void, void (*)(void*)> block
    (
        allocateBlock(size), std::free
    );
    const int in = open(file.c_str(), O_RDONLY);
    char* to = static_cast<char*>(block.get());
    ssize_t got = 1;
    for (std::size_t at = 0; at < size && got > 0; at += got)
    {
        got = read(in, to + at, std::min(size - at, std::size_t(8) << 20));
    }
    close(in);
    if (got <= 0)
    {
        throw userError("Cannot read " + file.string(), {}, "");
    }
}

//- Onto the disk and out of the page cache
void forget(const fs::path& file)
{
    const int in = open(file.c_str(), O_RDONLY);
    fsync(in);
    posix_fadvise(in, 0, 0, POSIX_FADV_DONTNEED);
    close(in);
}

void forget(const places& p)
{
    for (const auto& entry : fs::recursive_directory_iterator(p.time))
    {
        if (entry.is_regular_file())
        {
            forget(entry.path());
        }
    }
    forget(p.plain);
}

struct comparison
{
    std::vector<double> own, other;    // s, by round

    void print(const char* what, double bytes) const
    {
        std::vector<double> share;
        for (std::size_t r = 0; r < own.size(); ++r)
        {
            share.push_back(other[r]/own[r]);
        }
        std::sort(share.begin(), share.end());
        info
        (
            "| {} | {:.0f} | {:.0f} | {:.0f}% ({:.0f} to {:.0f}) |", what,
            1e-6*bytes/middle(own), 1e-6*bytes/middle(other),
            100*middle(share), 100*share.front(), 100*share.back()
        );
    }

private:

    static double middle(std::vector<double> v)
    {
        std::sort(v.begin(), v.end());
        return v[v.size()/2];
    }
};

int ioRate(int argc, char** argv)
{
    const argList args
    (
        argc, argv, "Measure the writing and reading of binary time folders.",
        {
            {"n", "N", "particles along a side, default 128"},
            {"directory", "DIR", "to write in, default: this one"},
            {"rounds", "R", "of which the medians are told, default 5"},
            {"cold", "", "also read what is not in the page cache"}
        },
        false
    );
    const int n = std::stoi(args.getOrDefault("n", "128"));
    const int rounds = std::stoi(args.getOrDefault("rounds", "5"));
    const fs::path base =
        fs::path(args.getOrDefault("directory", "."))/"ioRate.partial";
    const places p{base/"1", base/"plain"};
    const domain space = periodicBox(n, 3, 15);
    const hostState state = latticeState(space, 0.01, 5, 0.2);
    const auto pressure = [](double rho) { return rho/3; };

    std::size_t bytes = 0, found = 0;
    const auto write = [&]
    {
        bytes = writeState(p.time, state, pressure, writeOptions{});
    };
    const auto read = [&]
    {
        found += readState(p.time, space, state.rho0, true).fluid.size();
    };
    const auto ddRead = [&]
    {
        dd("of=/dev/null if='" + p.plain.string() + "'");
    };
    comparison writing, reading, keeping, cold;
    for (int r = 0; r < rounds; ++r)
    {
        fs::remove_all(base);
        fs::create_directories(base);
        writing.own.push_back(seconds(write));
        writing.other.push_back(seconds([&]
        {
            dd("if=/dev/zero iflag=count_bytes count=" + std::to_string(bytes)
              + " of='" + p.plain.string() + "'");
        }));
        reading.own.push_back(seconds(read));
        reading.other.push_back(seconds(ddRead));
        keeping.own.push_back(reading.own.back());
        keeping.other.push_back(seconds([&] { keep(p.plain); }));
        if (args.found("cold"))
        {
            forget(p);
            cold.own.push_back(seconds(read));
            cold.other.push_back(seconds(ddRead));
        }
    }
    fs::remove_all(base);

    info("{} particles, {:.1f} MB, medians of {}\n", state.fluid.size(),
        1e-6*bytes, rounds);
    info("| | MB/s | beside, MB/s | share (range) |\n|---|---|---|---|");
    writing.print("written, beside dd", double(bytes));
    reading.print("read from the page cache, beside dd", double(bytes));
    keeping.print("the same beside read(2) into new memory", double(bytes));
    if (args.found("cold"))
    {
        cold.print("read from the disk, beside dd", double(bytes));
    }
    return found == state.fluid.size()*rounds*(args.found("cold") ? 2 : 1)
      ? 0 : 1;
}

} // namespace

int main(int argc, char** argv)
{
    return runMain("ioRate", [&] { return ioRate(argc, argv); });
}
