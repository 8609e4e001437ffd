#include "study/stabilityDirectory.H"

#include "study/logWords.H"
#include "study/runRecord.H"

#include <cmath>
#include <fmt/format.h>

namespace gpuFsi
{

namespace
{

//- One line: blanks for what would end it or a column
std::string oneLine(const std::string& text)
{
    std::string line;
    for (const char c : text)
    {
        const bool blank = c == '\n' || c == '\t' || c == ' ';
        if (!blank || (!line.empty() && line.back() != ' '))
        {
            line += blank ? ' ' : c;
        }
    }
    return line;
}

} // namespace


stabilityDirectory::stabilityDirectory
(
    const stabilityDict& map,
    const std::filesystem::path& casePath,
    const std::string& caseBytes,
    const variant& v
)
:
    variantFolder
    (
        map, casePath, caseBytes, v,
        map.error.settings() + fmt::format("limit {:.17g}\n", map.errorLimit)
    ),
    map_(map)
{}


std::optional<stabilityRecord> stabilityDirectory::earlier() const
{
    if (!holds(recordFile()))
    {
        return {};
    }
    const stabilityRecord r = readStabilityRecord(recordFile());
    return allowed(r.kind) ? std::optional(r) : std::nullopt;
}


double stabilityDirectory::readError() const
{
    const errorSource& e = map_.error;
    if (e.command.empty())
    {
        return recordOfCost(costFileOf(path(), e.functionObject), e.norm).error;
    }
    return e.errorOf
    (
        printedNumber
        (
            path(), e.command, what().environment(map_), map_.timeLimit
        )
    );
}


//- A run that ended well
void stabilityDirectory::judge(stabilityRecord& r) const
{
    const std::filesystem::path bad = notFinite(path());
    if (!bad.empty())
    {
        r.kind = outcome::diverged;
        r.word = "Not finite: " + bad.lexically_relative(path()).string();
        return;
    }
    try
    {
        r.error = readError();
    }
    catch (const std::exception& e)
    {
        r.kind = outcome::failed;
        r.word = oneLine(e.what());
        return;
    }
    r.kind = r.error <= map_.errorLimit
      ? outcome::accurate : outcome::inaccurate;
}


stabilityRecord stabilityDirectory::run() const
{
    const commandOutcome ran = execute();
    stabilityRecord r;
    r.kind = outcomeOf(ran, bytesOf(log()));
    r.seconds = ran.seconds;
    if (r.kind == outcome::accurate)
    {
        judge(r);
        return r;
    }
    r.word = oneLine(lastWords(log()));
    if (r.kind == outcome::hung)
    {
        r.word = fmt::format
        (
            "took longer than timeLimit, {:g} s: {}", map_.timeLimit, r.word
        );
    }
    else if (!allowed(r.kind))
    {
        r.word = fmt::format("ended with code {}: {}", ran.code, r.word);
    }
    return r;
}


void stabilityDirectory::keep(const stabilityRecord& r) const
{
    writeRecord(recordFile(), r);
}

} // namespace gpuFsi
