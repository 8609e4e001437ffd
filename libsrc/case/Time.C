#include "case/Time.H"

#include "base/log.H"
#include "case/atomicFolder.H"
#include "case/timeImplementation.H"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gpuFsi
{

using stop = timeControls::stop;

Time::Time(const std::filesystem::path& casePath, const timeGroup& ranks)
:
    impl_(std::make_shared<implementation>(casePath, ranks))
{}

bool Time::run()
{
    return value() < impl_->endTime - 0.5*deltaT();
}

Time& Time::operator++()
{
    implementation& m = *impl_;
    timeState& s = m.state;
    m.readModified();

    const bool adjustable = m.controls.writeControl
        == timeControls::writing::adjustableRunTime;
    if (adjustable)
    {
        s.fitToWriteTime
        (
            m.controls.adjustTimeStep ? s.deltaT : m.controls.deltaT
        );
    }
    const double previous = s.value;
    s.advance(adjustable);
    if (s.value == previous)
    {
        throw userError
        (
            fmt::format
            (
                "deltaT {} is too small to move time {}", s.deltaT, previous
            ),
            m.controlDict.where("deltaT"),
            "The run has probably diverged; see the last times written."
        );
    }
    m.keepNamesApart(previous);

    m.writeTime = m.isWriteTime();
    m.signalsTaken = false;
    if
    (
        m.controls.stopAt == stop::noWriteNow
     || m.controls.stopAt == stop::writeNow
     || (m.controls.stopAt == stop::nextWrite && m.writeTime)
    )
    {
        m.endTime = s.value;
        m.writeTime = m.controls.stopAt != stop::noWriteNow;
    }
    return *this;
}

void Time::adjustDeltaT(double courant)
{
    implementation& m = *impl_;
    timeState& s = m.state;
    if (!m.controls.adjustTimeStep)
    {
        return;
    }
    if (!std::isfinite(courant))
    {
        throw userError
        (
            fmt::format
            (
                "The Courant number is {} at time {}: the run has diverged",
                courant, timeName()
            ),
            {},
            "Restart from an earlier time with a smaller maxCo, or more "
            "viscosity."
        );
    }
    const double ratio = m.controls.maxCo/std::max
    (
        courant,
        std::numeric_limits<double>::min()
    );
    const double factor = std::min({ratio, 1 + 0.1*ratio, 1.2});
    s.deltaT = std::min(factor*s.deltaT, m.controls.maxDeltaT);
    if
    (
        m.controls.writeControl
     == timeControls::writing::adjustableRunTime
    )
    {
        s.fitToWriteTime(s.deltaT);
    }
}

bool Time::writeTime() const
{
    impl_->takeSignals();
    return impl_->writeTime;
}

void Time::write
(
    const std::function<void(const std::filesystem::path&)>& body
)
{
    const std::string name = timeName();
    const auto all = [&](const std::filesystem::path& folder)
    {
        body(folder);
        impl_->state.write(folder, name);
    };
    if (impl_->ranks.many())
    {
        atomicFolder folder(impl_->timesPath, name);
        impl_->ranks.agree([&] { folder.fill(all); });
        try
        {
            impl_->ranks.agree([&] { folder.clear(); });
        }
        catch (...)
        {
            folder.restore();    // whole on all ranks again
            throw;
        }
        impl_->ranks.agree([&] { folder.publish(); });
    }
    else
    {
        writeFolderAtomically(impl_->timesPath, name, all);
    }
    impl_->purge(name);
}

void Time::writeAside
(
    const std::string& name,
    const std::function<void(const std::filesystem::path&)>& body
)
{
    writeFolderAtomically
    (
        impl_->timesPath,
        name,
        [&](const std::filesystem::path& folder)
        {
            body(folder);
            impl_->state.write(folder, name);
        }
    );
}

double Time::value() const
{
    return impl_->state.value;
}

long Time::index() const
{
    return impl_->state.index;
}

double Time::deltaT() const
{
    return impl_->state.deltaT;
}

double Time::endTime() const
{
    return impl_->endTime;
}

double Time::startTime() const
{
    return impl_->startTime;
}

std::string Time::timeName() const
{
    return impl_->timeNameNow();
}

std::string Time::timeName(double value) const
{
    return impl_->controls.timeName(value, impl_->state.timePrecision);
}

bool Time::adjustTimeStep() const
{
    return impl_->controls.adjustTimeStep;
}

double Time::maxCo() const
{
    return impl_->controls.maxCo;
}

const std::filesystem::path& Time::casePath() const
{
    return impl_->casePath;
}

std::filesystem::path Time::startPath() const
{
    return impl_->timesPath/impl_->start.name;
}

const dictionary& Time::controlDict() const
{
    return impl_->controlDict;
}

const writeOptions& Time::writing() const
{
    return impl_->controls.output;
}

double Time::fractionDone() const
{
    const double whole = impl_->endTime - impl_->startTime;
    return whole > 0
        ? std::clamp((value() - impl_->startTime)/whole, 0.0, 1.0)
        : 1;
}

double Time::secondsToFinish() const
{
    const long taken = index() - impl_->startIndex;
    if (taken == 0)
    {
        return std::numeric_limits<double>::infinity();
    }
    const double left = std::max(0.0, impl_->endTime - value())/deltaT();
    return left*clockSeconds()/taken;
}

std::string Time::executionTime() const
{
    return fmt::format
    (
        "ExecutionTime = {:.2f} s  ClockTime = {:.0f} s",
        cpuSeconds(),
        std::floor(clockSeconds())
    );
}

double Time::cpuSeconds() const
{
    return impl_->clock.cpuSeconds();
}

double Time::clockSeconds() const
{
    return impl_->clock.wallSeconds();
}

} // namespace gpuFsi
