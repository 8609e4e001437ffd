//- type forces: what the fluid does to solids, a file a solid: pressure and
//  viscous force, N, and their moments, N m (2-D: per metre of depth). Keys:
//  solids (names; default all), CofR (centre of the moments, default (0 0 0)).

#include "base/log.H"
#include "base/sum.H"
#include "functionObjects/functionObject.H"
#include "functionObjects/outputFile.H"
#include "functionObjects/solidNames.H"

namespace gpuFsi
{

namespace
{

class forces
:
    public functionObject
{
public:

    forces
    (
        const std::string& name,
        const dictionary& dict,
        const runInfo& info
    )
    :
        functionObject(name, dict, info),
        wanted_
        (
            dict.getOrDefault<std::vector<std::string>>("solids", {})
        ),
        where_(dict.where(dict.found("solids") ? "solids" : "type")),
        centre_(dict.getOrDefault("CofR", vector{0, 0, 0}))
    {}

    void start(const hostState& state, const runInfo&) override
    {
        solids_ = solidsOf(wanted_, where_, name(), state);
    }

    void execute(const hostState& state, const runInfo& info) override
    {
        if (files_.empty())
        {
            open(state, info);
        }
        for (std::size_t n = 0; n < solids_.size(); ++n)
        {
            const solidSet& s = state.solid;
            const auto pressure =
                [&](std::size_t i) { return s.pressureForce[i]; };
            const auto viscous =
                [&](std::size_t i) { return s.viscousForce(i); };
            const vector p = sum(s, solids_[n], pressure, false);
            const vector v = sum(s, solids_[n], viscous, false);
            const vector mp = sum(s, solids_[n], pressure, true);
            const vector mv = sum(s, solids_[n], viscous, true);
            std::string row = fmt::format("{:.12g}", info.time);
            for (const vector& f : {p, v, mp, mv})
            {
                row += fmt::format("\t{:.10e}\t{:.10e}\t{:.10e}",
                    f.x, f.y, f.z);
            }
            files_[n].write(row + "\n");
            if (log())
            {
                gpuFsi::info
                (
                    "{} {}: pressure ({:.4e} {:.4e} {:.4e}) viscous "
                    "({:.4e} {:.4e} {:.4e})", name(), s.names[solids_[n]],
                    p.x, p.y, p.z, v.x, v.y, v.z
                );
            }
        }
    }

private:

    void open(const hostState& state, const runInfo& info)
    {
        for (int solid : solids_)
        {
            files_.emplace_back
            (
                info.casePath, name(), info.startTime,
                state.solid.names[solid] + ".dat"
            );
            files_.back().write
            (
                fmt::format
                (
                    "# CofR ({:g} {:g} {:g})\n"
                    "# Time\tpressure_x\tpressure_y\tpressure_z"
                    "\tviscous_x\tviscous_y\tviscous_z"
                    "\tmomentPressure_x\tmomentPressure_y\tmomentPressure_z"
                    "\tmomentViscous_x\tmomentViscous_y\tmomentViscous_z\n",
                    centre_.x, centre_.y, centre_.z
                )
            );
        }
    }

    //- force(i): of particle i
    template<class Force>
    vector sum
    (
        const solidSet& s,
        int solid,
        const Force& force,
        bool moment
    ) const
    {
        const auto part = [&](int axis)
        {
            return pairwiseSum(0, s.size(), [&](std::size_t i)
            {
                const vector f = s.solid[i] != solid ? vector{0, 0, 0}
                  : moment ? cross(s.positions[i] - centre_, force(i))
                  : force(i);
                return axis == 0 ? f.x : axis == 1 ? f.y : f.z;
            });
        };
        return {part(0), part(1), part(2)};
    }

    std::vector<std::string> wanted_;
    sourceSpan where_;
    vector centre_;
    std::vector<int> solids_;
    std::vector<outputFile> files_;
};

const functionObject::selection::add<forces> add("forces");

} // namespace

} // namespace gpuFsi
