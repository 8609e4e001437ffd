#include "decomposedFiles.H"

#include "decomposition/cloudParts.H"
#include "decomposition/processorDirectories.H"

#include <algorithm>

namespace gpuFsi
{

namespace fs = std::filesystem;

//- Whatever is called processor and a number
static std::vector<fs::path> formerOnes(const fs::path& casePath)
{
    std::vector<fs::path> found;
    for (const auto& entry : fs::directory_iterator(casePath))
    {
        const std::string name = entry.path().filename().string();
        if
        (
            name.size() > 9 && name.compare(0, 9, "processor") == 0
         && name.find_first_not_of("0123456789", 9) == std::string::npos
        )
        {
            found.push_back(entry.path());
        }
    }
    return found;
}


void checkPlace(const fs::path& casePath, bool force)
{
    const std::vector<fs::path> former = formerOnes(casePath);
    for (const fs::path& p : former)
    {
        if (!fs::is_directory(p))
        {
            throw userError
            (
                p.string() + " is a file where a directory must be",
                {p.string()},
                "Move the file elsewhere and run again."
            );
        }
    }
    if (!former.empty() && !force)
    {
        throw userError
        (
            "Case is already decomposed: there are "
          + std::to_string(former.size()) + " processor directories in "
          + casePath.string(),
            {},
            "Give -force to remove them and what runs have written there, or"
            " reconstructParticles first."
        );
    }
}


decomposedFiles::decomposedFiles(const fs::path& casePath, int nRanks)
:
    casePath_(casePath),
    aside_(casePath/".decomposeParticles.partial"),
    nRanks_(nRanks)
{
    fs::remove_all(aside_);    // of a run that was killed
    fs::create_directories(aside_);
}


decomposedFiles::~decomposedFiles()
{
    std::error_code ignored;
    fs::remove_all(aside_, ignored);
}


void decomposedFiles::add(const decomposedTime& t)
{
    for (int r = 0; r < nRanks_; ++r)
    {
        const fs::path time = processorPath(aside_, r)/t.name();
        fs::create_directories(time);
        if (fs::exists(t.folder()/"uniform"))
        {
            fs::copy
            (
                t.folder()/"uniform", time/"uniform",
                fs::copy_options::recursive
            );
        }
        for (const auto& c : t.clouds())
        {
            c.form.write(time, partOf(c.whole, c.ids[r]));
        }
    }
}


void decomposedFiles::addConstant(const domain& d, const decomposedTime& last)
{
    decompositionRecord record;
    record.numberOfSubdomains = nRanks_;
    for (const auto& c : last.clouds())
    {
        record.clouds[c.whole.name] = c.whole.size();
    }
    const fs::path mesh = casePath_/"constant/polyMesh";
    const double half = 0.5*d.spacing;
    const vector margin{half, half, half};
    for (int r = 0; r < nRanks_; ++r)
    {
        const fs::path processor = processorPath(aside_, r);
        record.write(processor);
        if (fs::exists(mesh))
        {
            fs::copy
            (
                mesh, processor/"constant/polyMesh",
                fs::copy_options::recursive
            );
        }
        else
        {
            writeBoxMesh(processor, d.lo - margin, d.hi + margin);
        }
    }
}


void decomposedFiles::moveIn()
{
    fs::create_directories(aside_/"former");
    std::vector<fs::path> former = formerOnes(casePath_);
    std::sort(former.begin(), former.end());    // processor0 first
    for (const fs::path& p : former)
    {
        fs::rename(p, aside_/"former"/p.filename());
    }
    for (int r = nRanks_ - 1; r >= 0; --r)
    {
        fs::rename(processorPath(aside_, r), processorPath(casePath_, r));
    }
}

} // namespace gpuFsi
