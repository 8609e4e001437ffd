#include "decomposition/cloudForm.H"

#include "base/error.H"
#include "case/caseFileIO.H"
#include "case/fieldIO.H"
#include "case/foamFile.H"
#include "case/parallelFiles.H"

#include <algorithm>
#include <fstream>

namespace gpuFsi
{

namespace fs = std::filesystem;

//- Of the longest number, without leading zeros and exponents; 1 to 17. The
//  size of the list, before its parenthesis, is none of the values: one digit
//  too many would print 1e+06 as 1000000.
static int significantDigits(std::string_view text)
{
    const std::size_t list = text.find_first_of("({");
    if (list != std::string_view::npos)
    {
        text.remove_prefix(list);
    }
    int most = 1, here = 0;
    bool mantissa = true;
    for (const char c : text)
    {
        if (c >= '0' && c <= '9')
        {
            here += mantissa && (here > 0 || c != '0');
        }
        else if (c == 'e' || c == 'E')
        {
            mantissa = false;
        }
        else if (c != '.' && c != '-' && c != '+')
        {
            most = std::max(most, here);
            here = 0;
            mantissa = true;
        }
    }
    return std::min(most, 17);
}


//- Looks no further than the header of a file that is not compressed
static bool isBinary(const fs::path& file)
{
    std::string head(4096, '\0');
    std::ifstream in(file, std::ios::binary);
    in.read(head.data(), std::streamsize(head.size()));
    head.resize(std::size_t(in.gcount()));
    std::size_t begin = 0;
    return foamFile::parse(head, file, begin).binary();
}


static writeOptions formOf(const fs::path& file)
{
    writeOptions options;
    options.compress = existingCaseFile(file).extension() == ".gz";
    options.binary = !options.compress && isBinary(file);
    if (!options.binary)
    {
        const std::string bytes = readCaseFile(file);
        std::size_t begin = 0;
        options.binary = foamFile::parse(bytes, file, begin).binary();
        options.precision =
            significantDigits(std::string_view(bytes).substr(begin));
    }
    return options;
}


cloudForm cloudForm::of(const fs::path& time, const std::string& cloudName)
{
    cloudForm form;
    const fs::path directory = time/"lagrangian"/cloudName;
    for (const auto& entry : fs::directory_iterator(directory))
    {
        fs::path file = entry.path();
        if (file.extension() == ".gz")
        {
            file.replace_extension();
        }
        const std::string name = file.filename().string();
        if (entry.is_regular_file() && name[0] != '.' && name != "coordinates")
        {
            form.files_[name] = formOf(file);
        }
    }
    return form;
}


void cloudForm::widen(const cloudForm& other)
{
    for (const auto& [name, options] : other.files_)
    {
        int& digits = files_.insert({name, options}).first->second.precision;
        digits = std::max(digits, options.precision);
    }
}


const writeOptions& cloudForm::options(const std::string& file) const
{
    const auto known = files_.find(file);
    return known != files_.end() ? known->second : files_.at("positions");
}


void cloudForm::write(const fs::path& time, cloud c) const
{
    const std::vector<cloudField> fields = std::move(c.fields);
    c.fields.clear();
    writeCloud(time, c, options("positions"));
    const fs::path place = fs::path("lagrangian")/c.name;
    forEachFile(int(fields.size()), [&](int k)
    {
        writeField
        (
            time/place, (time.filename()/place).string(),
            fieldView(fields[k]), options(fields[k].name)
        );
    });
}

} // namespace gpuFsi
