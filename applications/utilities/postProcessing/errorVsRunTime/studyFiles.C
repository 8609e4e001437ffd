#include "studyFiles.H"

#include "base/log.H"
#include "case/caseFileIO.H"
#include "study/comparison.H"
#include "study/gnuplot.H"
#include "study/picture.H"
#include "study/report.H"

#include <algorithm>

namespace gpuFsi
{

namespace fs = std::filesystem;

namespace
{

const char* const stem = "errorVsRunTime";

//- Own and compared curves share one front
void markFront(std::vector<curve>& own, std::vector<curve>& compared)
{
    std::vector<curve> all = own;
    all.insert(all.end(), compared.begin(), compared.end());
    markPareto(all, own.front().points.front().run.machine);
    std::copy_n(all.begin(), own.size(), own.begin());
    std::copy(all.begin() + own.size(), all.end(), compared.begin());
}

} // namespace


void writeStudyFiles
(
    const studyDict& study,
    const fs::path& directory,
    std::vector<curve> own,
    std::vector<curve> compared,
    const std::vector<std::string>& failures
)
{
    // A single point has nothing finer to be compared with
    own.erase
    (
        std::remove_if(own.begin(), own.end(), [](const curve& c)
        {
            return c.points.empty();
        }),
        own.end()
    );
    if (own.empty())
    {
        throw userError
        (
            "No variant has a result", {},
            "See the messages above, and log.study in the variants' "
            "directories under " + directory.string() + "."
        );
    }
    markFront(own, compared);
    const std::string table = markdownOf(study, own, compared, failures);
    writeTextFile(directory/(std::string(stem) + ".csv"), csvOf(own));
    writeTextFile(directory/(std::string(stem) + ".md"), table);

    std::vector<curve> all = std::move(own);
    all.insert(all.end(), compared.begin(), compared.end());
    writeTextFile
    (
        directory/(std::string(stem) + ".gp"),
        gnuplotOf
        (
            all, stem, study.title,
            study.total ? "total clock time, s" : "clock time of the loop, s",
            errorLabel(study), study.parameters[study.resolution].name
        )
    );
    info("\n{}", table);
    paint(directory, stem);
}

} // namespace gpuFsi
