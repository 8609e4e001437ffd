#include "case/timeImplementation.H"

#include "base/digest.H"
#include "base/log.H"

#include <algorithm>
#include <cmath>

namespace gpuFsi
{

using writing = timeControls::writing;

Time::implementation::implementation
(
    const std::filesystem::path& path,
    const timeGroup& group
)
:
    casePath(path),
    ranks(group),
    timesPath(group.directory.empty() ? path : group.directory),
    controlFile(path/"system/controlDict"),
    controlDict(dictionary::fromFile(controlFile)),
    controlVersion(controlFile),
    controls(timeControls::read(controlDict)),
    signals(controls.writeNowSignal, controls.stopAtWriteNowSignal),
    start(findStart())
{
    state = timeState::read(timesPath/start.name, start.value, controls);
    startTime = state.value;
    startIndex = state.index;
    endTime = controls.endTime;
    setWriteInterval();
    if (endTime <= startTime)
    {
        warning
        (
            "endTime " + fmt::format("{}", endTime) + " is not after the "
            "start time " + start.name + ": there is nothing to run"
        );
    }
}

instant Time::implementation::findStart() const
{
    const std::vector<instant> times =
        ranks.times ? ranks.times() : findTimes(casePath);
    if (times.empty() && ranks.many())
    {
        throw userError
        (
            "No time is complete in all processor directories of "
          + casePath.string(),
            {controlFile.string()},
            "Run decomposeParticles first."
        );
    }
    if (times.empty())
    {
        throw userError
        (
            "There is no time folder in " + casePath.string(),
            {controlFile.string()},
            "Run seedParticles first: it writes time 0."
        );
    }
    if (controls.startFrom == "firstTime")
    {
        return times.front();
    }
    if (controls.startFrom == "latestTime")
    {
        return times.back();
    }
    const double wanted = controls.startTime;
    const std::string name =
        controls.timeName(wanted, controls.timePrecision);
    std::string there;
    for (const instant& t : times)
    {
        if
        (
            t.name == name
         || std::abs(t.value - wanted) <= 1e-9*std::abs(wanted)
        )
        {
            return t;
        }
        there += " " + t.name;
    }
    throw userError
    (
        "There is no folder of startTime " + name + " in "
      + casePath.string() + "; there are:" + there,
        controlDict.where("startTime"),
        "Take one of these, or startFrom latestTime or firstTime."
    );
}

bool Time::implementation::countsIntervals() const
{
    return controls.writeControl == writing::runTime
        || controls.writeControl == writing::adjustableRunTime;
}

void Time::implementation::setWriteInterval()
{
    const double interval = countsIntervals() ? controls.writeInterval : 0;
    if (interval != state.writeInterval)
    {
        state.writeIndex = interval > 0 ? state.intervalIndex(interval) : 0;
        state.writeInterval = interval;
    }
}

void Time::implementation::readModified()
{
    const bool changed =
        ranks.many() ? controlsChanged : controlVersion.changed();
    controlsChanged = false;
    if (!controls.runTimeModifiable || !changed)
    {
        return;
    }
    timeControls fresh;
    std::string wrong;
    try
    {
        fresh = timeControls::read(dictionary::fromFile(controlFile));
    }
    catch (const userError& e)
    {
        wrong = e.what();
    }
    // Another rank may see an older file, or half of one
    const bool differed = controlsDiffer;
    controlsDiffer =
        !ranks.same(wrong.empty() ? digestOfFile(controlFile) : 0);
    if (controlsDiffer)
    {
        if (!differed)
        {
            warning
            (
                "controlDict was changed, but not all ranks read the same yet; "
                "its former values stay until they do"
            );
        }
        return;
    }
    if (!wrong.empty())
    {
        warning
        (
            "controlDict was changed but cannot be used; its former values "
            "stay:\n" + wrong
        );
        return;
    }
    info("Re-reading object controlDict from file {}", controlFile.string());
    const timeControls old = controls;
    controls = fresh;
    endTime = fresh.endTime;
    if (fresh.deltaT != old.deltaT || !fresh.adjustTimeStep)
    {
        state.deltaT = fresh.deltaT;
    }
    if (fresh.timePrecision != old.timePrecision)
    {
        state.timePrecision = fresh.timePrecision;
    }
    if
    (
        fresh.writeControl != old.writeControl
     || fresh.writeInterval != old.writeInterval
    )
    {
        clockIndex = 0;
        isWriteTime();    // intervals of the past are not written now
    }
    setWriteInterval();
}

bool Time::implementation::isWriteTime()
{
    const auto reached = [](long& last, long now)
    {
        const bool next = now > last;
        last = std::max(last, now);
        return next;
    };
    if (countsClock() && !ranks.master)
    {
        return false;
    }
    const double interval = controls.writeInterval;
    switch (controls.writeControl)
    {
        case writing::timeStep:
            return state.index % long(interval) == 0;
        case writing::runTime:
        case writing::adjustableRunTime:
            return reached(state.writeIndex, state.intervalIndex(interval));
        case writing::clockTime:
            return reached(clockIndex, long(clock.wallSeconds()/interval));
        case writing::cpuTime:
            return reached(clockIndex, long(clock.cpuSeconds()/interval));
        case writing::none:
            break;
    }
    return false;
}

bool Time::implementation::countsClock() const
{
    return controls.writeControl == writing::clockTime
        || controls.writeControl == writing::cpuTime;
}

void Time::implementation::takeSignals()
{
    if (signalsTaken)
    {
        return;
    }
    signalsTaken = true;
    enum : std::uint64_t { now = 1, stop = 2, changed = 4, clock = 8 };
    std::uint64_t asked = signalWatch::takeWriteNow() ? now : 0;
    asked |= signalWatch::takeStop() ? stop : 0;
    if (ranks.many() && ranks.master)
    {
        asked |= controlVersion.changed() || controlsDiffer ? changed : 0;
        asked |= writeTime && countsClock() ? clock : 0;
    }
    asked = ranks.either(asked);
    controlsChanged = asked & changed;
    if (asked & clock)
    {
        writeTime = true;
        if (controls.stopAt == timeControls::stop::nextWrite)
        {
            endTime = state.value;
        }
    }
    if (asked & now)
    {
        info("Signal: writing time {}", timeNameNow());
        writeTime = true;
    }
    if (asked & stop)
    {
        info("Signal: writing time {} and stopping", timeNameNow());
        writeTime = true;
        endTime = state.value;
    }
}

std::string Time::implementation::timeNameNow() const
{
    return controls.timeName(state.value, state.timePrecision);
}

void Time::implementation::keepNamesApart(double previousValue)
{
    const int before = state.timePrecision;
    while
    (
        state.timePrecision < 17
     && timeNameNow()
     == controls.timeName(previousValue, state.timePrecision)
    )
    {
        ++state.timePrecision;
    }
    if (state.timePrecision != before)
    {
        warning
        (
            fmt::format
            (
                "Increased the timePrecision from {} to {} to distinguish "
                "between timeNames at time {}",
                before, state.timePrecision, timeNameNow()
            )
        );
    }
}

void Time::implementation::purge(const std::string& justWritten)
{
    const auto again =
        std::find(written.begin(), written.end(), justWritten);
    if (again != written.end())
    {
        written.erase(again);
    }
    written.push_back(justWritten);
    if (controls.purgeWrite == 0)
    {
        return;
    }
    while (written.size() > std::size_t(controls.purgeWrite))
    {
        std::error_code failed;
        std::filesystem::remove_all(timesPath/written.front(), failed);
        if (failed)
        {
            warning
            (
                "purgeWrite cannot remove time " + written.front() + ": "
              + failed.message()
            );
        }
        written.pop_front();
    }
}

} // namespace gpuFsi
