#include "study/studyDict.H"

namespace gpuFsi
{

studyDict studyDict::read
(
    const std::filesystem::path& casePath,
    const std::string& file
)
{
    const dictionary dict = dictionary::fromFile(casePath/file);
    studyDict s;
    s.error = errorSource::read(dict.subDict("error"));
    s.variantSet::read(dict, casePath, file, "studyDict", "study");
    s.repeats = int(dict.getNumberOrDefault("repeats", 3, 1, 1000));
    s.total = dict.getChoiceOrDefault("cost", "loop", {"loop", "total"})
     == "total";
    s.targets = dict.getOrDefault<std::vector<double>>("targets", {});
    s.resolution = s.chosen(dict, "resolution", 0);
    dict.warnUnread();
    return s;
}

} // namespace gpuFsi
