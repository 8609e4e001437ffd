#include "functionObjects/timeControl.H"

#include <cmath>
#include <limits>

namespace gpuFsi
{

timeControl::timeControl(const dictionary& dict, const std::string& prefix)
{
    const std::string word = dict.getChoiceOrDefault
    (
        prefix + "Control",
        "timeStep",
        {"timeStep", "runTime", "adjustableRunTime", "writeTime", "none"}
    );
    const std::string key = prefix + "Interval";
    interval_ = dict.getNumberOrDefault
    (
        key,
        1,
        std::numeric_limits<double>::min(),
        1e15
    );
    if (word == "none")
    {
        kind_ = kind::none;
    }
    else if (word == "runTime" || word == "adjustableRunTime")
    {
        kind_ = kind::runTime;
    }
    else
    {
        kind_ = word == "timeStep" ? kind::timeStep : kind::writeTime;
        if (interval_ < 1 || interval_ != std::floor(interval_))
        {
            throw userError
            (
                key + " is not a whole number of steps, as " + prefix
                + "Control " + word + " needs",
                dict.where(key),
                "Give 1 or more, or use " + prefix
                + "Control runTime for an interval in seconds."
            );
        }
        if (kind_ == kind::writeTime && interval_ != 1)
        {
            throw userError
            (
                key + " must be 1 with " + prefix + "Control writeTime",
                dict.where(key),
                "Use " + prefix + "Control runTime or timeStep for fewer."
            );
        }
    }
}


double timeControl::intervalsUntil(const runInfo& info) const
{
    // Half a step early is on time, as OpenFOAM counts
    return std::floor((info.time + 0.5*info.deltaT)/interval_);
}


bool timeControl::due(const runInfo& info) const
{
    switch (kind_)
    {
        case kind::timeStep:
            return info.timeIndex % long(interval_) == 0;
        case kind::runTime:
            return intervalsUntil(info) > done_;
        case kind::writeTime:
            return info.writeTime;
        default:
            return false;
    }
}


void timeControl::passed(const runInfo& info)
{
    if (kind_ == kind::runTime)
    {
        done_ = intervalsUntil(info);
    }
}

} // namespace gpuFsi
