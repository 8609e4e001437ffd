//- type spacing: distance of each fluid particle to the nearest particle, wall
//  or fluid, in seeding spacings h: its least, mean and greatest value. Clumps
//  show as a small minimum, voids as a great maximum. No keys of its own.

#include "base/log.H"
#include "base/sum.H"
#include "functionObjects/functionObject.H"
#include "functionObjects/nearestDistance.H"
#include "functionObjects/outputFile.H"

#include <algorithm>
#include <optional>

namespace gpuFsi
{

namespace
{

class spacing
:
    public functionObject
{
public:

    using functionObject::functionObject;

    void start(const hostState&, const runInfo& info) override
    {
        domain_ = domain::read(info.casePath);
    }

    void execute(const hostState& state, const runInfo& info) override
    {
        if (!file_)
        {
            file_.emplace
            (
                info.casePath, name(), info.startTime, "spacing.dat"
            );
            file_->write("# Time\tmin\tmean\tmax\n");
        }
        const std::vector<double> nearest = nearestDistance(state, domain_);
        const auto [least, greatest] =
            std::minmax_element(nearest.begin(), nearest.end());
        const double mean = pairwiseSum
        (
            0, nearest.size(), [&](std::size_t i) { return nearest[i]; }
        )/nearest.size();
        file_->write
        (
            fmt::format
            (
                "{:.12g}\t{:.8e}\t{:.8e}\t{:.8e}\n",
                info.time, *least, mean, *greatest
            )
        );
        if (log())
        {
            gpuFsi::info
            (
                "{}: nearest distance min = {:.3f} mean = {:.3f} max = {:.3f}"
                " h",
                name(), *least, mean, *greatest
            );
        }
    }

private:

    domain domain_;
    std::optional<outputFile> file_;
};

const functionObject::selection::add<spacing> add("spacing");

} // namespace

} // namespace gpuFsi
