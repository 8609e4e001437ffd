#include "study/runRecord.H"

#include "base/error.H"
#include "case/caseFileIO.H"

#include <cstdlib>
#include <fmt/format.h>

namespace gpuFsi
{

namespace fs = std::filesystem;

void writeRecords(const fs::path& file, const std::vector<runRecord>& runs)
{
    std::string text = "# error\tloopSeconds\ttotalSeconds\twallSeconds\t"
        "particleSteps\th\tdeltaT\tTime\tranks\tdevice\tprecision\t"
        "scheme\tmachine\n";
    for (const runRecord& r : runs)
    {
        text += fmt::format
        (
            "{:.17g}\t{:.9g}\t{:.9g}\t{:.9g}\t{:.17g}\t{:.12g}\t{:.12g}\t"
            "{:.12g}\t{}\t{}\t{}\t{}\t{}\n",
            r.error, r.loopSeconds, r.totalSeconds, r.wallSeconds,
            r.particleSteps, r.h, r.deltaT, r.time, r.ranks, r.device,
            r.precision, r.scheme, r.machine
        );
    }
    // Whole or not at all: a later run of the program builds on it
    const fs::path unfinished = file.string() + ".new";
    writeTextFile(unfinished, text);
    fs::rename(unfinished, file);
}


static runRecord recordOfRow(const textTable& t, std::size_t i)
{
    runRecord r;
    r.loopSeconds = t.number(i, "loopSeconds");
    r.totalSeconds = t.number(i, "totalSeconds");
    r.particleSteps = t.number(i, "particleSteps");
    r.h = t.number(i, "h");
    r.deltaT = t.number(i, "deltaT");
    r.time = t.number(i, "Time");
    r.ranks = int(t.number(i, "ranks"));
    r.device = t.text(i, "device");
    r.precision = t.text(i, "precision");
    r.scheme = t.text(i, "scheme");
    return r;
}


std::vector<runRecord> readRecords(const fs::path& file)
{
    const textTable table = textTable::fromTabs(file);
    std::vector<runRecord> runs;
    for (std::size_t i = 0; i < table.size(); ++i)
    {
        runs.push_back(recordOfRow(table, i));
        runs.back().error = table.number(i, "error");
        runs.back().wallSeconds = table.number(i, "wallSeconds");
        runs.back().machine = table.text(i, "machine");
    }
    return runs;
}


runRecord recordOfCost(const fs::path& file, const std::string& norm)
{
    const textTable table = textTable::fromTabs(file);
    if (table.size() == 0)
    {
        throw userError("There is no row in it", {file.string()});
    }
    const std::size_t last = table.size() - 1;
    runRecord r = recordOfRow(table, last);
    if (norm == "rmsByMax")
    {
        const double largest =
            table.number(last, "Linf")/table.number(last, "relLinf");
        r.error = table.number(last, "L2")/largest;
    }
    else
    {
        r.error = table.number(last, norm);
    }
    return r;
}


namespace
{

//- Text from the end of the last `before` to `until`
std::string between
(
    const std::string& text,
    const std::string& before,
    const std::string& until,
    const fs::path& file
)
{
    const std::size_t at = text.rfind(before);
    const std::size_t end =
        at == text.npos ? text.npos : text.find(until, at + before.size());
    if (end == text.npos)
    {
        throw userError
        (
            "There is no '" + before + "' in the log", {file.string()},
            "The commands must run gpuFsiFoam to its end, its log being "
            "theirs."
        );
    }
    return text.substr(at + before.size(), end - at - before.size());
}

} // namespace


runRecord recordOfLog(const fs::path& file)
{
    const std::string text = readCaseFile(file);
    const auto word = [&](const char* before, const char* until)
    {
        return between(text, before, until, file);
    };
    const auto number = [&](const char* before, const char* until)
    {
        return std::atof(word(before, until).c_str());
    };
    runRecord r;
    r.particleSteps = number("Particle-steps = ", " ");
    const std::string tail = text.substr(text.rfind("Particle-steps = "));
    const std::string line = tail.substr(0, tail.find('\n') + 1);
    const auto inLine = [&](const char* before)
    {
        return std::atof(between(line, before, " ", file).c_str());
    };
    r.loopSeconds = inLine("loop = ");
    r.totalSeconds = inLine("total = ");
    r.ranks = int(inLine("ranks = "));
    r.h = number(", spacing ", ",");
    r.deltaT = number("deltaT = ", "\n");
    r.time = number("\nTime = ", "\n");
    const std::string device = word("Device      : ", " precision\n");
    const std::size_t comma = device.rfind(", ");
    r.device = device.substr(0, comma);
    r.precision = device.substr(comma + 2);
    r.scheme = text.find("Schemes     : ") == text.npos
      ? "solids" : word("Schemes     : ", "\n");
    return r;
}

} // namespace gpuFsi
