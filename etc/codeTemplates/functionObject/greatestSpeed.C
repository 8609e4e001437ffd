//- type greatestSpeed: the greatest |U| of the fluid, and where, a row a time:
//  postProcessing/<name>/<start time>/greatestSpeed.dat
//  Keys: above (m/s, default 0: smaller speeds give no row).

#include "base/log.H"
#include "functionObjects/functionObject.H"
#include "functionObjects/outputFile.H"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace gpuFsi
{

namespace
{

class greatestSpeed
:
    public functionObject
{
public:

    greatestSpeed
    (
        const std::string& name,
        const dictionary& dict,
        const runInfo& info
    )
    :
        functionObject(name, dict, info),
        above_
        (
            dict.getNumberOrDefault
            (
                "above", 0, 0, std::numeric_limits<double>::max()
            )
        )
    {}

    void execute(const hostState& state, const runInfo& info) override
    {
        if (!file_)
        {
            file_.emplace
            (
                info.casePath, name(), info.startTime, "greatestSpeed.dat"
            );
            file_->write("# Time\tspeed\tx\ty\tz\n");
        }
        double greatest = -1;
        vector where{0, 0, 0};
        for (std::size_t i = 0; i < state.fluid.size(); ++i)
        {
            const vector& u = state.fluid.U[i];
            const double square = dot(u, u);
            if (square > greatest)
            {
                greatest = square;
                where = state.fluid.positions[i];
            }
        }
        const double speed = std::sqrt(std::max(greatest, 0.0));
        if (speed < above_)
        {
            return;
        }
        file_->write
        (
            fmt::format
            (
                "{:.12g}\t{:.8e}\t{:.8e}\t{:.8e}\t{:.8e}\n",
                info.time, speed, where.x, where.y, where.z
            )
        );
        if (log())
        {
            gpuFsi::info("{}: greatest speed = {:.4e}", name(), speed);
        }
    }

private:

    double above_;
    std::optional<outputFile> file_;    // made when there is something to say
};

const functionObject::selection::add<greatestSpeed> add("greatestSpeed");

} // namespace

} // namespace gpuFsi
