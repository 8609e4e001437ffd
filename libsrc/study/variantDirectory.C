#include "study/variantDirectory.H"

#include "case/caseFileIO.H"
#include "study/logWords.H"
#include "study/machine.H"

#include <cmath>
#include <cstdlib>
#include <fmt/format.h>

namespace gpuFsi
{

namespace fs = std::filesystem;

variantDirectory::variantDirectory
(
    const studyDict& s,
    const fs::path& casePath,
    const std::string& caseBytes,
    const variant& v
)
:
    variantFolder(s, casePath, caseBytes, v, s.error.settings()),
    study_(s)
{}


std::vector<runRecord> variantDirectory::earlier() const
{
    return holds(recordFile()) ? readRecords(recordFile())
      : std::vector<runRecord>();
}


bool variantDirectory::knownTooLong() const
{
    return holds(limitFile())
     && std::strtod(readCaseFile(limitFile()).c_str(), nullptr)
     >= study_.timeLimit;
}


runRecord variantDirectory::run() const
{
    const commandOutcome ran = execute();
    if (ran.timedOut)
    {
        writeTextFile(limitFile(), fmt::format("{:.17g}\n", study_.timeLimit));
    }
    if (!ran.good())
    {
        throw userError
        (
            (ran.timedOut
              ? fmt::format("took longer than timeLimit, {:g} s",
                    study_.timeLimit)
              : fmt::format("ended with code {}", ran.code))
          + ":" + lastWords(log()), {log().string()}
        );
    }
    runRecord r;
    if (study_.error.command.empty())
    {
        r = recordOfCost
        (
            costFileOf(path(), study_.error.functionObject),
            study_.error.norm
        );
    }
    else
    {
        r = recordOfLog(log());
        r.error = study_.error.errorOf
        (
            printedNumber
            (
                path(), study_.error.command, what().environment(study_),
                study_.timeLimit
            )
        );
    }
    if (!std::isfinite(r.error))
    {
        throw userError("The error is not finite", {log().string()});
    }
    if (r.error < 0 && !study_.error.finest)
    {
        throw userError
        (
            fmt::format("The error is negative, {:g}", r.error),
            {log().string()}, "Let command print its absolute value."
        );
    }
    r.wallSeconds = ran.seconds;
    r.machine = machineName();
    return r;
}


void variantDirectory::keep(const std::vector<runRecord>& runs) const
{
    writeRecords(recordFile(), runs);
}

} // namespace gpuFsi
