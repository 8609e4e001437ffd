//- type error: norms of a field's difference from what it should be, over the
//  fluid particles weighted by their volumes m/rho; at the end of the run what
//  the latest of them cost.
//  Keys: field, exact or reference, centre, region "expression, not zero
//  inside", includeWalls (no). Annotated: etc/caseDicts/annotated/functions.

#include "base/log.H"
#include "functionObjects/errorCost.H"
#include "functionObjects/fields.H"
#include "functionObjects/functionObject.H"
#include "functionObjects/outputFile.H"
#include "functionObjects/referenceField.H"

#include <optional>

namespace gpuFsi
{

namespace
{

//- Error over size of the exact field; 0 where both vanish
double relative(double error, double size)
{
    return error == 0 ? 0 : error/size;
}

class fieldError
:
    public functionObject
{
public:

    fieldError
    (
        const std::string& name,
        const dictionary& dict,
        const runInfo& info
    )
    :
        functionObject(name, dict, info),
        field_(fields::readName(dict, "field")),
        centre_(dict.getOrDefault<vector>("centre", {0, 0, 0})),
        walls_(dict.getOrDefault<bool>("includeWalls", false)),
        reference_(field_, dict, info, centre_)
    {
        if (dict.found("region"))
        {
            regionWhere_ = dict.where("region");
            region_.emplace
            (
                dict.get<std::string>("region"),
                regionWhere_
            );
        }
    }

    void start(const hostState& state, const runInfo& info) override
    {
        pick(state, info);
    }

    void execute(const hostState& state, const runInfo& info) override
    {
        const selected s = pick(state, info);
        const int n = fields::nComponents(field_);
        const auto exact = reference_.values(s.points, info);
        const std::vector<double> rest
        (
            exact.size(),
            fields::restValue(field_, info)
        );
        const norms error = normsOf(distances(s.values, exact, n), s.volume);
        const norms size = normsOf(distances(exact, rest, n), s.volume);

        if (!file_)
        {
            file_.emplace
            (
                info.casePath, name(), info.startTime, "error.dat"
            );
            file_->write
            (
                "# Time\tL1\tL2\tLinf\trelL1\trelL2\trelLinf\tloopSeconds\n"
            );
        }
        const norms part
        {
            relative(error.L1, size.L1),
            relative(error.L2, size.L2),
            relative(error.Linf, size.Linf)
        };
        latest_.emplace(errorCost{error, part, info});
        file_->write
        (
            fmt::format
            (
                "{:.12g}\t{:.8e}\t{:.8e}\t{:.8e}\t{:.8e}\t{:.8e}\t{:.8e}"
                "\t{:.8e}\n",
                info.time,
                error.L1,
                error.L2,
                error.Linf,
                part.L1,
                part.L2,
                part.Linf,
                info.loopSeconds
            )
        );
        if (log())
        {
            gpuFsi::info
            (
                "{}: error of {} L2 = {:.4e} Linf = {:.4e} relL2 = {:.4e}",
                name(), field_, error.L2, error.Linf, part.L2
            );
        }
    }

    //- What the latest error cost: cost.dat, and a line in the log
    void end(const runInfo& info) override
    {
        if (!latest_)
        {
            return;
        }
        latest_->run.totalSeconds = info.totalSeconds;
        outputFile file(info.casePath, name(), info.startTime, "cost.dat");
        file.write(errorCost::header() + latest_->row());
        gpuFsi::info("{}: {}", name(), latest_->sentence(field_));
    }

private:

    struct selected
    {
        std::vector<vector> points;
        std::vector<double> values;
        std::vector<double> volume;
    };

    void append
    (
        selected& s,
        const particleSet& set,
        const hostState& state,
        const runInfo& info,
        const std::vector<double>& volume
    ) const
    {
        const auto values = fields::values(field_, set, state, info);
        const int n = fields::nComponents(field_);
        std::vector<double> inside;
        if (region_)
        {
            std::vector<vector> fromCentre;
            fromCentre.reserve(set.size());
            for (const vector& p : set.positions)
            {
                fromCentre.push_back(p - centre_);
            }
            inside = region_->at(fromCentre, info.time);
        }
        const std::size_t most = s.points.size() + set.size();
        s.points.reserve(most);
        s.volume.reserve(most);
        s.values.reserve(n*most);
        for (std::size_t i = 0; i < set.size(); ++i)
        {
            if (region_ && inside[i] == 0)
            {
                continue;
            }
            s.points.push_back(set.positions[i]);
            s.volume.push_back(volume[i]);
            const auto first = values.begin() + n*i;
            s.values.insert(s.values.end(), first, first + n);
        }
    }

    selected pick(const hostState& state, const runInfo& info) const
    {
        selected s;
        const std::size_t nFluid = state.fluid.size();
        std::vector<double> volume(nFluid);
        for (std::size_t i = 0; i < nFluid; ++i)
        {
            volume[i] =
                state.fluid.mass[i]/(state.rho0 + state.fluid.deltaRho[i]);
        }
        append(s, state.fluid, state, info, volume);
        if (walls_)
        {
            volume.clear();
            for (double area : state.area)
            {
                volume.push_back(area*state.h/2);
            }
            append(s, state.walls, state, info, volume);
        }
        if (s.points.empty())
        {
            throw userError
            (
                "No particle lies inside the region of function object "
                + name() + (region_ ? ": \"" + region_->text() + "\"" : ""),
                regionWhere_,
                "The region is where the expression is not zero; x y z r"
                " are measured from centre."
            );
        }
        return s;
    }

    std::string field_;
    vector centre_;
    bool walls_;
    referenceField reference_;
    std::optional<expression> region_;
    sourceSpan regionWhere_;
    std::optional<outputFile> file_;
    std::optional<errorCost> latest_;
};

const functionObject::selection::add<fieldError> add("error");

} // namespace

} // namespace gpuFsi
