#include "study/stabilityDict.H"

#include <limits>

namespace gpuFsi
{

static errorSource readError(const dictionary& dict)
{
    const errorSource e = errorSource::read(dict);
    if (e.finest)
    {
        throw userError
        (
            "A map has no finest run to compare with", dict.where("finest"),
            "Give exact <number>; or direct yes;."
        );
    }
    return e;
}


static void checkAxes(const stabilityDict& s, const dictionary& dict)
{
    if (s.parameters.size() > 1 && s.resolution == s.y)
    {
        throw userError
        (
            "x and y are both " + s.parameters[s.y].name, dict.where("y"),
            "Name another parameter."
        );
    }
}


stabilityDict stabilityDict::read
(
    const std::filesystem::path& casePath,
    const std::string& file
)
{
    const dictionary dict = dictionary::fromFile(casePath/file);
    stabilityDict s;
    s.variantSet::read
    (
        dict, casePath, file, "stabilityDict", "studyStability"
    );
    const dictionary& error = dict.subDict("error");
    s.error = readError(error);
    s.errorLimit =
        error.getNumber("limit", 0, std::numeric_limits<double>::max());
    s.resolution = s.chosen(dict, "x", 0);
    const std::size_t other =
        s.parameters.size() == 1 ? 0 : s.resolution == 0 ? 1 : 0;
    s.y = s.chosen(dict, "y", other);
    checkAxes(s, dict);
    dict.warnUnread();
    return s;
}

} // namespace gpuFsi
