//- type sets: fields along lines, a file a line and time:
//  postProcessing/<name>/<time>/<set>_<fields>.xy
//  Keys: fields, exact <word> (optional: the exact solution's columns, too),
//  sets { <set> { start; end; nPoints; axis; } ... } (or start end nPoints
//  axis of a single line, called as the object), and those of pointSampler.

#include "functionObjects/fields.H"
#include "functionObjects/functionObject.H"
#include "functionObjects/outputFile.H"
#include "functionObjects/pointSampler.H"
#include "functionObjects/referenceField.H"

#include <fmt/format.h>

#include <cmath>

namespace gpuFsi
{

namespace
{

struct line
{
    std::string name, axis;
    std::vector<double> abscissa;
    sourceSpan where;
    pointSampler sampler;

    //- general: where the sampler's keys stand
    line
    (
        const std::string& setName,
        const dictionary& dict,
        const dictionary& general
    )
    :
        name(setName),
        axis
        (
            dict.getChoiceOrDefault
            (
                "axis", "distance", {"x", "y", "z", "distance"}
            )
        ),
        where(dict.where("start")),
        sampler(general, pointsOf(dict))
    {
        const vector first = sampler.points().front();
        for (const vector& p : sampler.points())
        {
            const vector d = p - first;
            abscissa.push_back
            (
                axis == "x" ? p.x : axis == "y" ? p.y : axis == "z" ? p.z
              : std::sqrt(dot(d, d))
            );
        }
    }

    static std::vector<vector> pointsOf(const dictionary& dict)
    {
        const vector start = dict.get<vector>("start");
        const vector end = dict.get<vector>("end");
        const int n = int(dict.getNumber("nPoints", 2, 1e8));
        std::vector<vector> points;
        for (int i = 0; i < n; ++i)
        {
            points.push_back(start + (double(i)/(n - 1))*(end - start));
        }
        return points;
    }
};


class sets
:
    public functionObject
{
public:

    sets
    (
        const std::string& name,
        const dictionary& dict,
        const runInfo& info
    )
    :
        functionObject(name, dict, info),
        fields_(fields::readNames(dict, "fields"))
    {
        if (dict.found("exact"))
        {
            for (const std::string& field : fields_)
            {
                exact_.emplace_back(field, dict, info, vector{0, 0, 0});
            }
        }
        const dictionary* several = dict.subDictPtr("sets");
        if (!several)
        {
            lines_.emplace_back(name, dict, dict);
            return;
        }
        for (const std::string& set : several->keys())
        {
            lines_.emplace_back(set, several->subDict(set), dict);
        }
        if (lines_.empty())
        {
            throw userError
            (
                "sets is empty",
                dict.where("sets"),
                "Write sets { yAxis { start (0 0 0); end (0 1 0);"
                " nPoints 50; axis y; } }"
            );
        }
    }

    void start(const hostState& state, const runInfo&) override
    {
        for (line& l : lines_)
        {
            l.sampler.update(state);
            bool inside = false;
            for (std::size_t i = 0; i < l.abscissa.size(); ++i)
            {
                inside = inside || l.sampler.inside(i);
            }
            if (!inside)
            {
                throw userError
                (
                    "The line " + l.name + " of function object " + name()
                    + " lies outside the fluid",
                    l.where,
                    "Check start and end; lengths are in metres."
                );
            }
        }
    }

    void execute(const hostState& state, const runInfo& info) override
    {
        for (line& l : lines_)
        {
            l.sampler.update(state);
            write(l, state, info);
        }
    }

private:

    void write(const line& l, const hostState& state, const runInfo& info)
    {
        std::string file = l.name;
        std::string header = "# " + l.axis;
        std::vector<std::string> rows;
        for (double a : l.abscissa)
        {
            rows.push_back(fmt::format("{:.8e}", a));
        }
        for (std::size_t f = 0; f < fields_.size(); ++f)
        {
            const std::string& field = fields_[f];
            const int n = fields::nComponents(field);
            file += "_" + field;
            header += columnNames(field, n);
            addColumns
            (
                l.sampler.values
                (
                    fields::values(field, state.fluid, state, info),
                    fields::values(field, state.walls, state, info),
                    n
                ),
                rows
            );
            if (!exact_.empty())
            {
                header += columnNames("exact_" + field, n);
                addColumns(exact_[f].values(l.sampler.points(), info), rows);
            }
        }
        std::string text = header + "\n";
        for (const std::string& row : rows)
        {
            text += row + "\n";
        }
        outputFile(info.casePath, name(), info.timeName, file + ".xy")
            .write(text);
    }

    static std::string columnNames(const std::string& field, int n)
    {
        return n == 1 ? "\t" + field
            : "\t" + field + "_x\t" + field + "_y\t" + field + "_z";
    }

    //- values: row-major
    static void addColumns
    (
        const std::vector<double>& values,
        std::vector<std::string>& rows
    )
    {
        const std::size_t n = values.size()/rows.size();
        for (std::size_t i = 0; i < values.size(); ++i)
        {
            rows[i/n] += fmt::format("\t{:.8e}", values[i]);
        }
    }

    std::vector<std::string> fields_;
    std::vector<referenceField> exact_;    // by field; empty: not asked for
    std::vector<line> lines_;
};

const functionObject::selection::add<sets> add("sets");

} // namespace

} // namespace gpuFsi
