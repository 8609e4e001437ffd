//- type flowRate: volume a second through a disk, m^3/s, by quadrature of the
//  velocity sampled on rings of points.
//  Keys: centre, normal (flow along it counts as positive), radius (m),
//  exact <word> (optional: the exact rate and the relative error, too), and
//  those of pointSampler. 3-D only.

#include "base/log.H"
#include "exact/gaussLegendre.H"
#include "functionObjects/fields.H"
#include "functionObjects/functionObject.H"
#include "functionObjects/outputFile.H"
#include "functionObjects/pointSampler.H"
#include "functionObjects/referenceField.H"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <optional>

namespace gpuFsi
{

namespace
{

struct disk
{
    vector normal;                    // unit
    std::vector<vector> points;
    std::vector<double> areas;        // of the points, m^2

    explicit disk(const dictionary& dict)
    :
        normal(dict.get<vector>("normal"))
    {
        const double length = std::sqrt(dot(normal, normal));
        if (!(length > 0))
        {
            throw userError
            (
                "normal has no length", dict.where("normal"), "Give (1 0 0)."
            );
        }
        normal = (1/length)*normal;
        const vector centre = dict.get<vector>("centre");
        const double radius =
            dict.getNumber("radius", 0, std::numeric_limits<double>::max());

        // Two directions in the disk, the first from the axis farthest off
        const vector off = std::abs(normal.x) < 0.6
            ? vector{1, 0, 0} : vector{0, 1, 0};
        const vector across = cross(normal, off);
        const vector e1 = (1/std::sqrt(dot(across, across)))*across;
        const vector e2 = cross(normal, e1);
        constexpr int around = 64;
        const double pi = std::acos(-1.0);
        for (const quadratureNode& ring : gaussLegendre(0, radius, 2))
        {
            for (int i = 0; i < around; ++i)
            {
                const double a = 2*pi*(i + 0.5)/around;
                points.push_back
                (
                    centre + (ring.x*std::cos(a))*e1 + (ring.x*std::sin(a))*e2
                );
                areas.push_back(ring.weight*ring.x*2*pi/around);
            }
        }
    }

    //- values: of U, point-major
    double through(const std::vector<double>& values) const
    {
        double sum = 0;
        for (std::size_t i = 0; i < areas.size(); ++i)
        {
            const double* u = &values[3*i];
            sum += areas[i]*dot(normal, vector{u[0], u[1], u[2]});
        }
        return sum;
    }
};


class flowRate
:
    public functionObject
{
public:

    flowRate
    (
        const std::string& name,
        const dictionary& dict,
        const runInfo& info
    )
    :
        functionObject(name, dict, info),
        where_(dict.where("centre")),
        disk_(dict),
        sampler_(dict, disk_.points)
    {
        if (dict.found("exact"))
        {
            exact_.emplace("U", dict, info, vector{0, 0, 0});
        }
    }

    void start(const hostState& state, const runInfo& info) override
    {
        if (info.dimensions != 3)
        {
            throw userError
            (
                "flowRate " + name() + " needs a case in 3-D",
                where_,
                "In 2-D use sets across the flow."
            );
        }
        sampler_.update(state);
        for (std::size_t i = 0; i < disk_.points.size(); ++i)
        {
            if (!sampler_.inside(i))
            {
                const vector& p = disk_.points[i];
                throw userError
                (
                    fmt::format
                    (
                        "The disk of flowRate {} is partly outside the fluid,"
                        " at ({:g} {:g} {:g})",
                        name(), p.x, p.y, p.z
                    ),
                    where_,
                    "Check centre, normal and radius; lengths are in metres."
                );
            }
        }
    }

    void execute(const hostState& state, const runInfo& info) override
    {
        if (!file_)
        {
            file_.emplace
            (
                info.casePath, name(), info.startTime, "flowRate.dat"
            );
            file_->write
            (
                exact_ ? "# Time\tflowRate\texact\trelativeError\n"
                    : "# Time\tflowRate\n"
            );
        }
        sampler_.update(state);
        const double rate = disk_.through
        (
            sampler_.values
            (
                fields::values("U", state.fluid, state, info),
                fields::values("U", state.walls, state, info),
                3
            )
        );
        std::string row = fmt::format("{:.12g}\t{:.8e}", info.time, rate);
        std::string text = fmt::format("{}: flow rate = {:.6e}", name(), rate);
        if (exact_)
        {
            const double wanted =
                disk_.through(exact_->values(disk_.points, info));
            row += fmt::format("\t{:.8e}\t{:.8e}", wanted, rate/wanted - 1);
            text += fmt::format(" relative error = {:.3e}", rate/wanted - 1);
        }
        file_->write(row + "\n");
        if (log())
        {
            gpuFsi::info("{}", text);
        }
    }

private:

    sourceSpan where_;
    disk disk_;
    pointSampler sampler_;
    std::optional<referenceField> exact_;
    std::optional<outputFile> file_;
};

const functionObject::selection::add<flowRate> add("flowRate");

} // namespace

} // namespace gpuFsi
