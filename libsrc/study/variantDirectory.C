#include "study/variantDirectory.H"

#include "base/digest.H"
#include "case/caseFileIO.H"
#include "study/caseCopy.H"
#include "study/commandRun.H"
#include "study/entryEdit.H"
#include "study/includedFiles.H"
#include "study/machine.H"

#include <cmath>
#include <cstdint>
#include <deque>
#include <fmt/format.h>
#include <fstream>
#include <sstream>

namespace gpuFsi
{

namespace fs = std::filesystem;

namespace
{

std::string settingsOf
(
    const studyDict& s,
    const variant& v,
    const std::string& caseBytes
)
{
    std::string text = "case " + caseBytes + "\nerror "
      + s.error.functionObject + " " + s.error.norm + s.error.command
      + fmt::format(" {} {} {:.17g}\n", s.error.direct, s.error.finest,
            s.error.exact);
    for (const std::string& command : s.commands)
    {
        text += "command " + command + "\n";
    }
    for (const std::string& setting : v.environment(s))
    {
        text += setting + "\n";
    }
    for (const variant::change& c : v.changes(s))
    {
        text += c.entry.file + ": " + c.entry.assignment(c.value);
    }
    return text;
}


std::string bytesOf(const fs::path& file)
{
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}


//- The last lines of a log, or those after its last FOAM FATAL, up to five
//  that are not empty, for a message
std::string lastWords(const fs::path& log)
{
    const std::string text = bytesOf(log);
    const std::size_t fatal = text.rfind("FOAM FATAL");
    std::istringstream stream
    (
        fatal == text.npos ? text : text.substr(text.find('\n', fatal))
    );
    std::deque<std::string> lines;
    for (std::string line; std::getline(stream, line);)
    {
        if (!line.empty() && (fatal == text.npos || lines.size() < 5))
        {
            lines.push_back(line);
        }
        if (lines.size() > 5)
        {
            lines.pop_front();
        }
    }
    std::string all;
    for (const std::string& line : lines)
    {
        all += "\n    " + line;
    }
    return all;
}

//- cost.dat, and the like that a second run from the same time leaves
std::vector<fs::path> costFilesIn(const fs::path& directory)
{
    std::vector<fs::path> files;
    if (fs::is_directory(directory))
    {
        for (const auto& entry : fs::directory_iterator(directory))
        {
            const std::string name = entry.path().filename().string();
            if (name.compare(0, 4, "cost") == 0
             && entry.path().extension() == ".dat")
            {
                files.push_back(entry.path());
            }
        }
    }
    return files;
}


double startTime(const fs::path& directory)
{
    return std::atof(directory.filename().c_str());
}

} // namespace


std::string fingerprint(const studyDict& s, const fs::path& casePath)
{
    // The dictionaries of studies tell what to run, not what runs
    std::uint64_t hash = digestOf({});
    const auto add = [&](const std::string& bytes)
    {
        hash = digestOf(bytes, hash);
    };
    for (const fs::path& file : ownFiles(casePath, s.noCopy))
    {
        if (file.filename().string().compare(0, 9, "studyDict") != 0)
        {
            const std::string bytes = bytesOf(casePath/file);
            add(file.string());
            add(bytes);
            for (const fs::path& included :
                includedFiles(casePath/file, bytes))
            {
                add(bytesOf(included));
            }
        }
    }
    return fmt::format("{:016x}", hash);
}


variantDirectory::variantDirectory
(
    const studyDict& s,
    const fs::path& casePath,
    const std::string& caseBytes,
    const variant& v
)
:
    study_(s),
    casePath_(casePath),
    variant_(v),
    path_(casePath/s.directory/v.name),
    caseBytes_(caseBytes),
    settings_(settingsOf(s, v, caseBytes))
{}


fs::path variantDirectory::beside(const char* ending) const
{
    return path_.string() + ending;
}


std::vector<runRecord> variantDirectory::earlier() const
{
    const fs::path runs = beside(".runs.dat");
    if (!fs::exists(runs) || bytesOf(beside(".settings")) != settings_)
    {
        return {};
    }
    return readRecords(runs);
}


void variantDirectory::prepare() const
{
    if (fingerprint(study_, casePath_) != caseBytes_)
    {
        throw userError
        (
            "The case has changed since the study began",
            {casePath_.string()},
            "Start errorVsRunTime again; name what is written there meanwhile "
            "(nohup.out) in noCopy, or log.*."
        );
    }
    if (bytesOf(beside(".settings")) != settings_)
    {
        // In this order: records never belong to other settings
        fs::remove(beside(".runs.dat"));
        fs::create_directories(path_.parent_path());
        writeTextFile(beside(".settings"), settings_);
    }
    fs::remove_all(path_);
    for (const fs::path& file : ownFiles(casePath_, study_.noCopy))
    {
        fs::create_directories((path_/file).parent_path());
        fs::copy_file(casePath_/file, path_/file);
    }
    fs::create_directories(path_);
    for (const variant::change& c : variant_.changes(study_))
    {
        setEntry(path_/c.entry.file, c.entry, c.value);
    }
}


fs::path variantDirectory::costFile() const
{
    const fs::path top =
        path_/"postProcessing"/study_.error.functionObject;
    fs::path latest;
    if (fs::is_directory(top))
    {
        for (const auto& entry : fs::directory_iterator(top))
        {
            if (!costFilesIn(entry.path()).empty() && (latest.empty()
             || startTime(entry.path()) > startTime(latest)))
            {
                latest = entry.path();
            }
        }
    }
    const std::vector<fs::path> files = costFilesIn(latest);
    if (files.size() != 1)
    {
        throw userError
        (
            files.empty()
              ? "The commands left no cost.dat of function object "
              + study_.error.functionObject
              : fmt::format("There are {} tables cost*.dat: which is the "
                    "run's?", files.size()),
            {(latest.empty() ? top : latest).string()},
            "controlDict needs a function object of that name, of type error; "
            "the commands must run gpuFsiFoam once from a start time."
        );
    }
    return files[0];
}


double variantDirectory::printedNumber() const
{
    const fs::path output = path_/"error.txt";
    const commandOutcome ran = runCommands
    (
        path_, {study_.error.command}, variant_.environment(study_), output,
        study_.timeLimit
    );
    std::ifstream stream(output);
    double value = 0;
    if (!ran.good() || !(stream >> value))
    {
        throw userError
        (
            "The command of error printed no number:" + lastWords(output),
            {output.string()}
        );
    }
    return value;
}


runRecord variantDirectory::run() const
{
    const fs::path log = path_/"log.study";
    const commandOutcome ran = runCommands
    (
        path_, study_.commands, variant_.environment(study_), log,
        study_.timeLimit
    );
    if (!ran.good())
    {
        throw userError
        (
            (ran.timedOut
              ? fmt::format("took longer than timeLimit, {:g} s",
                    study_.timeLimit)
              : fmt::format("ended with code {}", ran.code))
          + ":" + lastWords(log), {log.string()}
        );
    }
    runRecord r;
    if (study_.error.command.empty())
    {
        r = recordOfCost(costFile(), study_.error.norm);
    }
    else
    {
        r = recordOfLog(log);
        const double value = printedNumber();
        r.error = study_.error.exact == 0
          ? value : std::abs(value/study_.error.exact - 1);
    }
    if (!std::isfinite(r.error))
    {
        throw userError("The error is not finite", {log.string()});
    }
    if (r.error < 0 && !study_.error.finest)
    {
        throw userError
        (
            fmt::format("The error is negative, {:g}", r.error),
            {log.string()}, "Let command print its absolute value."
        );
    }
    r.wallSeconds = ran.seconds;
    r.machine = machineName();
    return r;
}


void variantDirectory::keep(const std::vector<runRecord>& runs) const
{
    writeRecords(beside(".runs.dat"), runs);
}


void variantDirectory::forget() const
{
    fs::remove(beside(".runs.dat"));
    fs::remove(beside(".settings"));
    fs::remove_all(path_);
}


void variantDirectory::removeFields() const
{
    std::vector<fs::path> gone;
    for (const auto& entry : fs::directory_iterator(path_))
    {
        if (holdsFields(entry.path().filename().string()))
        {
            gone.push_back(entry.path());
        }
    }
    for (const fs::path& p : gone)
    {
        fs::remove_all(p);
    }
}

} // namespace gpuFsi
