//- type probes: fields at points, a file a field and a row a time, as
//  OpenFOAM writes them. Keys: probeLocations, fields, and those of
//  pointSampler.

#include "functionObjects/fields.H"
#include "functionObjects/functionObject.H"
#include "functionObjects/outputFile.H"
#include "functionObjects/pointSampler.H"

#include <fmt/format.h>

namespace gpuFsi
{

namespace
{

class probes
:
    public functionObject
{
public:

    probes
    (
        const std::string& name,
        const dictionary& dict,
        const runInfo& info
    )
    :
        functionObject(name, dict, info),
        fields_(fields::readNames(dict, "fields")),
        where_(dict.where("probeLocations")),
        sampler_(dict, dict.get<std::vector<vector>>("probeLocations"))
    {
        if (sampler_.points().empty())
        {
            throw userError
            (
                "probeLocations is empty",
                where_,
                "Give one point or more: probeLocations ((0 0 0));"
            );
        }
    }

    void start(const hostState& state, const runInfo&) override
    {
        sampler_.update(state);
        for (std::size_t i = 0; i < sampler_.points().size(); ++i)
        {
            if (!sampler_.inside(i))
            {
                const vector& p = sampler_.points()[i];
                throw userError
                (
                    fmt::format
                    (
                        "Probe {} of {} at ({:g} {:g} {:g}) lies outside the"
                        " fluid: no particle within {:g} m",
                        i, name(), p.x, p.y, p.z,
                        pointSampler::reach*state.h
                    ),
                    where_,
                    "Move the probe into the fluid."
                );
            }
        }
    }

    void execute(const hostState& state, const runInfo& info) override
    {
        if (files_.empty())
        {
            open(info);
        }
        sampler_.update(state);
        for (std::size_t f = 0; f < fields_.size(); ++f)
        {
            const int n = fields::nComponents(fields_[f]);
            const auto values = sampler_.values
            (
                fields::values(fields_[f], state.fluid, state, info),
                fields::values(fields_[f], state.walls, state, info),
                n
            );
            std::string row = fmt::format("{:.12g}", info.time);
            for (std::size_t i = 0; i < values.size(); i += n)
            {
                row += n == 1
                    ? fmt::format("\t{:.8e}", values[i])
                    : fmt::format
                      (
                          "\t({:.8e} {:.8e} {:.8e})",
                          values[i], values[i + 1], values[i + 2]
                      );
            }
            files_[f].write(row + "\n");
        }
    }

private:

    void open(const runInfo& info)
    {
        std::string header;
        std::string numbers = "# Probe";
        for (std::size_t i = 0; i < sampler_.points().size(); ++i)
        {
            const vector& p = sampler_.points()[i];
            header += fmt::format
            (
                "# Probe {} ({:.12g} {:.12g} {:.12g})\n", i, p.x, p.y, p.z
            );
            numbers += fmt::format("\t{}", i);
        }
        for (const std::string& field : fields_)
        {
            files_.emplace_back(info.casePath, name(), info.startTime, field);
            files_.back().write(header + numbers + "\n# Time\n");
        }
    }

    std::vector<std::string> fields_;
    sourceSpan where_;
    pointSampler sampler_;
    std::vector<outputFile> files_;
};

const functionObject::selection::add<probes> add("probes");

} // namespace

} // namespace gpuFsi
