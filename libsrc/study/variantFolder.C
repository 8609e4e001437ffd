#include "study/variantFolder.H"

#include "base/digest.H"
#include "case/caseFileIO.H"
#include "study/caseCopy.H"
#include "study/entryEdit.H"
#include "study/includedFiles.H"
#include "study/logWords.H"

#include <cstdint>
#include <fmt/format.h>

namespace gpuFsi
{

namespace fs = std::filesystem;

namespace
{

std::string settingsOf
(
    const variantSet& s,
    const variant& v,
    const std::string& caseBytes,
    const std::string& reading
)
{
    std::string text = "case " + caseBytes + "\n" + reading;
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


//- They tell what to run, not what runs
bool ofStudies(const std::string& file)
{
    return file.compare(0, 9, "studyDict") == 0
     || file.compare(0, 13, "stabilityDict") == 0;
}

} // namespace


std::string fingerprint(const variantSet& s, const fs::path& casePath)
{
    std::uint64_t hash = digestOf({});
    const auto add = [&](const std::string& bytes)
    {
        hash = digestOf(bytes, hash);
    };
    for (const fs::path& file : ownFiles(casePath, s.noCopy))
    {
        if (!ofStudies(file.filename().string()))
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


variantFolder::variantFolder
(
    const variantSet& s,
    const fs::path& casePath,
    const std::string& caseBytes,
    const variant& v,
    const std::string& reading
)
:
    set_(s),
    variant_(v),
    casePath_(casePath),
    path_(casePath/s.directory/v.name),
    caseBytes_(caseBytes),
    settings_(settingsOf(s, v, caseBytes, reading))
{}


fs::path variantFolder::beside(const char* ending) const
{
    return path_.string() + ending;
}


bool variantFolder::holds(const fs::path& records) const
{
    return fs::exists(records)
     && bytesOf(beside(".settings")) == settings_;
}


commandOutcome variantFolder::execute() const
{
    return runCommands
    (
        path_, set_.commands, variant_.environment(set_), log(),
        set_.timeLimit
    );
}


void variantFolder::prepare() const
{
    if (fingerprint(set_, casePath_) != caseBytes_)
    {
        throw userError
        (
            "The case has changed since the study began",
            {casePath_.string()},
            "Start again; name what is written there meanwhile "
            "(nohup.out) in noCopy, or log.*."
        );
    }
    if (bytesOf(beside(".settings")) != settings_)
    {
        // In this order: records never belong to other settings
        fs::remove(recordFile());
        fs::remove(limitFile());
        fs::create_directories(path_.parent_path());
        writeTextFile(beside(".settings"), settings_);
    }
    fs::remove_all(path_);
    for (const fs::path& file : ownFiles(casePath_, set_.noCopy))
    {
        fs::create_directories((path_/file).parent_path());
        fs::copy_file(casePath_/file, path_/file);
    }
    fs::create_directories(path_);
    for (const variant::change& c : variant_.changes(set_))
    {
        setEntry(path_/c.entry.file, c.entry, c.value);
    }
}


void variantFolder::forget() const
{
    fs::remove(recordFile());
    fs::remove(limitFile());
    fs::remove(beside(".settings"));
    fs::remove_all(path_);
}


void variantFolder::removeFields() const
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
