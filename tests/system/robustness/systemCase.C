#include "systemCase.H"

#include "case/Time.H"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>

#include <unistd.h>

namespace fs = std::filesystem;

systemCase::systemCase()
{
    // Threads of several tests at a time would wait for each other; that
    // their number does not matter is for the tests of determinism
    setenv("OMP_NUM_THREADS", "1", 1);

    static int n = 0;
    path_ = fs::temp_directory_path()
        /("robustness-" + std::to_string(getpid()))
        /("case" + std::to_string(n++));
    fs::create_directories(path_);
}


systemCase::systemCase(const systemCase& other)
:
    systemCase()
{
    fs::copy
    (
        other.path_,
        path_,
        fs::copy_options::recursive | fs::copy_options::overwrite_existing
    );
    // The reader's file is called as the case is
    const fs::path reader =
        path_/(other.path_.filename().string() + ".foam");
    if (fs::exists(reader))
    {
        fs::rename(reader, path_/(path_.filename().string() + ".foam"));
    }
}


systemCase::~systemCase()
{
    for (const char* ending : {"", ".out", ".err"})
    {
        fs::remove_all(path_.string() + ending);
    }
    std::error_code notEmpty;
    fs::remove(path_.parent_path(), notEmpty);
}


//- The dictionaries of a case, without its data
static void copyDictionaries(const fs::path& from, const fs::path& to)
{
    for (const char* folder : {"system", "constant"})
    {
        fs::copy(from/folder, to/folder, fs::copy_options::recursive);
    }
}


systemCase systemCase::pulse()
{
    systemCase c;
    copyDictionaries(PULSE_CASE, c.path_);
    c.set("system/seedParticlesDict", "spacing", "0.9375");
    c.set("system/controlDict", "endTime", "0.6");
    c.set("system/controlDict", "deltaT", "0.05");
    c.set("system/controlDict", "backend", "cpu");
    return c;
}


systemCase systemCase::piston()
{
    systemCase c;
    copyDictionaries(PISTON_CASE, c.path_);
    return c;
}


void systemCase::seed() const
{
    const outcome o = run(app::seedParticles);
    ASSERT_EQ(o.code, 0) << o.out << o.err;
}


std::vector<std::string> systemCase::words
(
    app program,
    const std::vector<std::string>& options
) const
{
    std::vector<std::string> list
    {
        program == app::seedParticles ? SEED_PARTICLES
      : program == app::gpuFsiFoam ? GPU_FSI_FOAM
      : program == app::decomposeParticles ? DECOMPOSE_PARTICLES
      : program == app::reconstructParticles ? RECONSTRUCT_PARTICLES
      : program == app::checkParticles ? CHECK_PARTICLES
      : PARTICLES_TO_VTK
    };
    if (std::find(options.begin(), options.end(), "-case") == options.end())
    {
        list.insert(list.end(), {"-case", path_.string()});
    }
    list.insert(list.end(), options.begin(), options.end());
    return list;
}


outcome systemCase::run
(
    app program,
    const std::vector<std::string>& options,
    const std::vector<std::string>& environment
) const
{
    return ::run(words(program, options), path_, environment);
}


std::string systemCase::text(const std::string& file) const
{
    return bytesOf(path_/file);
}


void systemCase::write(const std::string& file, const std::string& bytes)
{
    fs::create_directories((path_/file).parent_path());
    std::ofstream(path_/file, std::ios::binary) << bytes;
    editedFile_ = file;
    editedLine_ = 0;
}


void systemCase::add(const std::string& file, const std::string& line)
{
    const std::string before = text(file);
    write(file, before + line + '\n');
    editedLine_ = 1 + int(std::count(before.begin(), before.end(), '\n'));
}


void systemCase::replace
(
    const std::string& file,
    const std::string& from,
    const std::string& to
)
{
    std::string all = text(file);
    const std::size_t at = all.find(from);
    ASSERT_NE(at, std::string::npos) << from << " is not in " << file;
    all.replace(at, from.size(), to);
    write(file, all);
    editedLine_ = 1 + int(std::count(all.begin(), all.begin() + at, '\n'));
}


//- Line that starts with the key
static std::string entryLine(const std::string& all, const std::string& key)
{
    std::istringstream in(all);
    for (std::string line; std::getline(in, line); )
    {
        std::istringstream words(line);
        std::string first;
        if (words >> first && first == key)
        {
            return line;
        }
    }
    ADD_FAILURE() << "there is no entry " << key << " in\n" << all;
    return {};
}


void systemCase::set
(
    const std::string& file,
    const std::string& key,
    const std::string& value
)
{
    const std::string line = entryLine(text(file), key);
    replace(file, line, key + ' ' + value + ';');
}


void systemCase::erase(const std::string& file, const std::string& key)
{
    replace(file, entryLine(text(file), key) + '\n', "");
    editedLine_ = 0;
}


void systemCase::remove(const std::string& file)
{
    fs::remove_all(path_/file);
    editedFile_ = file;
    editedLine_ = 0;
}


fileTree systemCase::tree() const
{
    fileTree files;
    for (const auto& entry : fs::recursive_directory_iterator(path_))
    {
        const std::string name = entry.path().lexically_relative(path_);
        files[name] = entry.is_regular_file() ? bytesOf(entry.path()) : "";
    }
    return files;
}


std::vector<std::string> systemCase::timeNames() const
{
    std::vector<std::string> names;
    for (const auto& time : gpuFsi::findTimes(path_))
    {
        names.push_back(time.name);
    }
    return names;
}


fileTree systemCase::times() const
{
    const fileTree all = tree();
    fileTree files;
    for (const std::string& name : timeNames())
    {
        files.merge(within(all, name));
    }
    return files;
}


std::string difference(const fileTree& found, const fileTree& wanted)
{
    std::string text;
    for (const auto& [name, bytes] : wanted)
    {
        const auto here = found.find(name);
        text += here == found.end() ? name + " is missing\n"
            : here->second != bytes ? name + " differs\n" : "";
    }
    for (const auto& [name, bytes] : found)
    {
        text += wanted.count(name) ? "" : name + " is new\n";
    }
    return text;
}


fileTree within(const fileTree& all, const std::string& folder)
{
    fileTree files;
    for (const auto& [name, bytes] : all)
    {
        if (name.compare(0, folder.size() + 1, folder + '/') == 0)
        {
            files[name] = bytes;
        }
    }
    return files;
}
