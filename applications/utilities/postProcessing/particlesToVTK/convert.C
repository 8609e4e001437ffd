#include "convert.H"

#include "words.H"

#include "base/error.H"
#include "base/log.H"
#include "vtk/vtkFiles.H"

#include <vtkPolyData.h>

#include <algorithm>
#include <map>
#include <set>

namespace gpuFsi
{

namespace fs = std::filesystem;

namespace
{

class converter
{
public:

    //- fields: to write, empty for all
    converter
    (
        const caseClouds& source,
        const argList& args,
        const std::set<std::string>& fields
    )
    :
        source_(source),
        out_(args.casePath()/"VTK"),
        encoding_
        (
            args.found("ascii") ? vtkEncoding::ascii
          : args.found("compress") ? vtkEncoding::compressed
          : vtkEncoding::binary
        ),
        single_(args.found("float")),
        fields_(fields)
    {
        if (args.found("ascii") && args.found("compress"))
        {
            throw userError
            (
                "-ascii and -compress exclude each other",
                {},
                "Leave one of them out"
            );
        }
    }

    void write(const instant& time, const std::string& cloudName)
    {
        std::vector<cloud> pieces = source_.read(time, cloudName);
        const auto layout = layoutOf(pieces, fields_, single_);
        const std::string stem =
            cloudName + '_' + std::to_string(source_.index(time));
        const fs::path below = fs::path("lagrangian")/cloudName;

        std::size_t nParticles = 0;
        std::vector<std::string> sources;
        for (std::size_t r = 0; r < pieces.size(); ++r)
        {
            cloud& piece = pieces[r];
            nParticles += piece.size();
            const fs::path from = source_.ranks()[r];
            const fs::path file = out_/from/below/(stem + ".vtp");
            writeVtp
            (
                file,
                *toPolyData(piece, layout, single_, time.value),
                encoding_
            );
            sources.push_back
            (
                (fs::path("../..")/from/below/(stem + ".vtp")).generic_string()
            );
            piece = cloud();    // its memory goes before the next is written
        }
        std::string name = stem + ".vtp";
        if (source_.decomposed())
        {
            name = stem + ".pvtp";
            writePvtp(out_/below/name, sources, layout, single_);
        }
        series_[cloudName].push_back({name, time.value});
        info
        (
            "    {}: {} particles, {} fields -> {}",
            cloudName,
            nParticles,
            layout.size(),
            (fs::path("VTK")/below/name).generic_string()
        );
    }

    void finish() const
    {
        const std::string ending =
            source_.decomposed() ? ".pvtp.series" : ".vtp.series";
        for (const auto& [cloudName, entries] : series_)
        {
            writeSeries
            (
                out_/"lagrangian"/cloudName/(cloudName + ending),
                entries
            );
        }
    }

private:

    const caseClouds& source_;
    const fs::path out_;
    const vtkEncoding encoding_;
    const bool single_;
    const std::set<std::string> fields_;
    std::map<std::string, std::vector<seriesEntry>> series_;
};


//- At each time the clouds there, or the one asked for where it is
std::vector<std::string> chosen
(
    const std::vector<std::string>& there,
    const argList& args
)
{
    if (!args.found("cloud"))
    {
        return there;
    }
    const std::string wanted = args.get("cloud");
    const bool has =
        std::find(there.begin(), there.end(), wanted) != there.end();
    return has ? std::vector<std::string>{wanted} : std::vector<std::string>{};
}

//- Throws where no cloud at any of the times has a field of -fields
std::set<std::string> chosenFields
(
    const caseClouds& source,
    const std::vector<instant>& times,
    const argList& args
)
{
    if (!args.found("fields"))
    {
        return {};
    }
    std::set<std::string> known;
    for (const instant& time : times)
    {
        for (const std::string& name : chosen(source.names(time), args))
        {
            known.merge(source.fieldNames(time, name));
        }
    }
    const auto words = parseWords("fields", args.get("fields"));
    for (const std::string& word : words)
    {
        if (!known.count(word))
        {
            throw userError
            (
                unknownChoice("field", word, {known.begin(), known.end()})
            );
        }
    }
    return {words.begin(), words.end()};
}

} // namespace


void convert(const caseClouds& source, const argList& args)
{
    const std::vector<instant> times = selectTimes(source.times(), args);
    if (times.empty())
    {
        throw userError
        (
            "The options select no time",
            {},
            "Leave -noZero out: the case has time 0 alone"
        );
    }
    std::set<std::string> known;
    for (const instant& time : times)
    {
        const auto there = source.names(time);
        known.insert(there.begin(), there.end());
    }
    if (args.found("cloud") && !known.count(args.get("cloud")))
    {
        throw userError
        (
            unknownChoice
            (
                "cloud",
                args.get("cloud"),
                {known.begin(), known.end()}
            )
        );
    }

    converter to(source, args, chosenFields(source, times, args));
    for (const instant& time : times)
    {
        info("Time = {}", time.name);
        for (const std::string& name : chosen(source.names(time), args))
        {
            to.write(time, name);
        }
    }
    to.finish();
}

} // namespace gpuFsi
