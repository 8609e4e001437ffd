#include "decomposition/blockDecomposition.H"

#include "base/error.H"
#include "case/caseFileIO.H"
#include "case/foamFile.H"
#include "case/foamScanner.H"

#include <fmt/format.h>

#include <cmath>

namespace gpuFsi
{

namespace fs = std::filesystem;

void writeBlockDecomposition
(
    const fs::path& file,
    const blockGrid& g,
    const std::vector<int>& rankOfBlock
)
{
    foamFile header;
    header.cls = "labelList";
    header.location = file.parent_path().filename().string();
    header.object = file.filename().string();
    std::string text = header.text() + fmt::format
    (
        "// Rank of each of the {} x {} x {} blocks: a line along x, a group"
        " of lines along y\n\n{}\n(\n",
        g.n[0], g.n[1], g.n[2], g.count()
    );
    for (int z = 0; z < g.n[2]; ++z)
    {
        for (int y = 0; y < g.n[1]; ++y)
        {
            for (int x = 0; x < g.n[0]; ++x)
            {
                text += std::to_string(rankOfBlock[g.index(x, y, z)]);
                text += x + 1 < g.n[0] ? ' ' : '\n';
            }
        }
        text += z + 1 < g.n[2] ? "\n" : "";
    }
    writeTextFile(file, text + ")\n");
}


std::vector<int> readBlockDecomposition(const fs::path& file)
{
    if (!fs::exists(file))
    {
        throw userError
        (
            "There is no file " + file.string(),
            {file.string()},
            "Write it with decomposeParticles -blockDist and another method,"
            " then edit it."
        );
    }
    const std::string bytes = readCaseFile(file);
    std::size_t begin = 0;
    const foamFile header = foamFile::parse(bytes, file, begin);
    foamScanner scan(bytes, file, begin);
    if (header.cls != "labelList" || header.binary())
    {
        scan.fail
        (
            "The ranks of blocks are a labelList in ascii, found "
          + header.cls + " in " + header.format,
            "See what decomposeParticles -blockDist writes."
        );
    }
    std::vector<int> ranks;
    const long size = scan.nextIsNumber() ? scan.count() : -1;
    scan.expect('(', "before the ranks");
    while (!scan.accept(')'))
    {
        const double rank =
            scan.number("rank of block " + std::to_string(ranks.size()));
        if (!(rank >= 0 && rank < 2147483648.) || rank != std::floor(rank))
        {
            scan.fail
            (
                fmt::format("Block {} is of rank {}", ranks.size(), rank),
                "Ranks are whole numbers from 0."
            );
        }
        ranks.push_back(int(rank));
    }
    if (size >= 0 && size != long(ranks.size()))
    {
        scan.fail
        (
            fmt::format
            (
                "The list says {} blocks, but holds {}", size, ranks.size()
            ),
            "Each block has one rank."
        );
    }
    return ranks;
}

} // namespace gpuFsi
