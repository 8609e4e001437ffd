//- type displacementProbe: displacement (m) and velocity (m/s) of the solid
//  particle nearest to each point of the unstrained solids. Key: points.

#include "functionObjects/functionObject.H"
#include "functionObjects/outputFile.H"
#include "functionObjects/solidNames.H"

#include <cmath>
#include <fmt/format.h>
#include <optional>

namespace gpuFsi
{

namespace
{

class displacementProbe
:
    public functionObject
{
public:

    displacementProbe
    (
        const std::string& name,
        const dictionary& dict,
        const runInfo& info
    )
    :
        functionObject(name, dict, info),
        points_(dict.get<std::vector<vector>>("points")),
        where_(dict.where("points"))
    {}

    void start(const hostState& state, const runInfo&) override
    {
        solidsOf({}, where_, name(), state);
        for (const vector& point : points_)
        {
            particles_.push_back(nearest(state, point));
        }
    }

    void execute(const hostState& state, const runInfo& info) override
    {
        if (!file_)
        {
            open(state, info);
        }
        std::string row = fmt::format("{:.12g}", info.time);
        for (std::size_t i : particles_)
        {
            const vector d =
                state.solid.positions[i] - state.solid.reference[i];
            const vector& u = state.solid.U[i];
            row += fmt::format
            (
                "\t{:.12e}\t{:.12e}\t{:.12e}\t{:.10e}\t{:.10e}\t{:.10e}",
                d.x, d.y, d.z, u.x, u.y, u.z
            );
        }
        file_->write(row + "\n");
    }

private:

    std::size_t nearest(const hostState& state, const vector& point) const
    {
        const std::vector<vector>& x = state.solid.reference;
        std::size_t best = 0;
        double least = HUGE_VAL;
        for (std::size_t i = 0; i < x.size(); ++i)
        {
            vector d = x[i] - point;
            d.z = state.dimensions == 2 ? 0 : d.z;
            if (dot(d, d) < least)
            {
                least = dot(d, d);
                best = i;
            }
        }
        if (std::sqrt(least) > 2*state.h)
        {
            throw userError
            (
                fmt::format
                (
                    "{}: point ({:g} {:g} {:g}) is {:g} m from the nearest "
                    "particle of a solid, ({:g} {:g} {:g})",
                    name(), point.x, point.y, point.z, std::sqrt(least),
                    x[best].x, x[best].y, x[best].z
                ),
                where_,
                "Choose a point of the unstrained solid."
            );
        }
        return best;
    }

    void open(const hostState& state, const runInfo& info)
    {
        file_.emplace
        (
            info.casePath, name(), info.startTime, "displacement.dat"
        );
        std::string header, columns = "# Time";
        for (std::size_t n = 0; n < particles_.size(); ++n)
        {
            const vector& x = state.solid.reference[particles_[n]];
            header += fmt::format
            (
                "# Probe {}: particle {} at ({:.12g} {:.12g} {:.12g})\n",
                n, particles_[n], x.x, x.y, x.z
            );
            columns += "\td_x\td_y\td_z\tU_x\tU_y\tU_z";
        }
        file_->write(header + columns + "\n");
    }

    std::vector<vector> points_;
    sourceSpan where_;
    std::vector<std::size_t> particles_;
    std::optional<outputFile> file_;
};

const functionObject::selection::add<displacementProbe>
    add("displacementProbe");

} // namespace

} // namespace gpuFsi
