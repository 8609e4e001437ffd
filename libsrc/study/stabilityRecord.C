#include "study/stabilityRecord.H"

#include "base/error.H"
#include "case/caseFileIO.H"
#include "study/textTable.H"

#include <cmath>
#include <fmt/format.h>

namespace gpuFsi
{

void writeRecord(const std::filesystem::path& file, const stabilityRecord& r)
{
    // Whole or not at all: a later run of the program builds on it
    const std::filesystem::path unfinished = file.string() + ".new";
    writeTextFile
    (
        unfinished,
        fmt::format
        (
            "# class\terror\tseconds\tword\n{}\t{}\t{:.9g}\t{} \n",
            nameOf(r.kind),
            std::isfinite(r.error) ? fmt::format("{:.17g}", r.error) : "none",
            r.seconds, r.word
        )
    );
    std::filesystem::rename(unfinished, file);
}


stabilityRecord readStabilityRecord(const std::filesystem::path& file)
{
    const textTable table = textTable::fromTabs(file);
    if (table.size() != 1)
    {
        throw userError("It does not hold one row", {file.string()});
    }
    stabilityRecord r;
    r.kind = outcomeNamed(table.text(0, "class"));
    if (table.text(0, "error") != "none")
    {
        r.error = table.number(0, "error");
    }
    r.seconds = table.number(0, "seconds");
    // Written with a blank behind, as a column must not be empty
    r.word = table.text(0, "word");
    r.word.pop_back();
    return r;
}

} // namespace gpuFsi
