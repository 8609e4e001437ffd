#include "functionObjects/functionObject.H"

#include <limits>

namespace gpuFsi
{

namespace
{

//- executeControl is read, and so checked, in any case
timeControl controlOf(const dictionary& dict)
{
    const timeControl execute(dict, "execute");
    const timeControl write(dict, "write");
    const bool onlyExecute =
        dict.found("executeControl") && !dict.found("writeControl");
    return onlyExecute ? execute : write;
}

} // namespace


functionObject::functionObject
(
    const std::string& name,
    const dictionary& dict,
    const runInfo&
)
:
    name_(name),
    control_(controlOf(dict)),
    atStart_(dict.getOrDefault<bool>("executeAtStart", true)),
    timeStart_
    (
        dict.getOrDefault<double>
        (
            "timeStart",
            -std::numeric_limits<double>::max()
        )
    ),
    timeEnd_
    (
        dict.getOrDefault<double>
        (
            "timeEnd",
            std::numeric_limits<double>::max()
        )
    ),
    log_(dict.getOrDefault<bool>("log", true))
{
    if (timeEnd_ < timeStart_)
    {
        throw userError
        (
            "timeEnd lies before timeStart, so " + name
            + " would never act",
            dict.where("timeEnd"),
            "Exchange the two, or set enabled no."
        );
    }
}


bool functionObject::inWindow(const runInfo& info) const
{
    const double slack = 0.5*info.deltaT;
    return info.time >= timeStart_ - slack && info.time <= timeEnd_ + slack;
}


bool functionObject::due(const runInfo& info) const
{
    return inWindow(info) && control_.due(info);
}


bool functionObject::dueAtStart(const runInfo& info) const
{
    return atStart_ && inWindow(info);
}


void functionObject::passed(const runInfo& info)
{
    control_.passed(info);
}

} // namespace gpuFsi
