#include "study/studyRun.H"

#include "base/log.H"
#include "case/caseFileIO.H"
#include "study/finestRun.H"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <sstream>

namespace gpuFsi
{

namespace fs = std::filesystem;

studyRun::studyRun(const studyDict& study, const fs::path& casePath)
:
    study_(study),
    variants_(allVariants(study))
{
    const std::string bytes = fingerprint(study, casePath);
    for (const variant& v : variants_)
    {
        members_.push_back
        (
            {v, variantDirectory(study, casePath, bytes, v), {}, false}
        );
        members_.back().records = members_.back().directory.earlier();
    }
}


void studyRun::forget()
{
    for (member& m : members_)
    {
        m.directory.forget();
        m.records.clear();
    }
}


int studyRun::runsLeft(const member& m) const
{
    return m.failed ? 0 : std::max(0, study_.repeats - int(m.records.size()));
}


void studyRun::run()
{
    for (const member& m : members_)
    {
        all_ += runsLeft(m);
    }
    const int kept = study_.repeats*int(members_.size()) - all_;
    leaveOutKnown();
    info
    (
        "{} variants, {} runs each: {} to do, {} kept from before\n",
        members_.size(), study_.repeats, all_, std::max(0, kept)
    );
    for (int round = 0; round < study_.repeats; ++round)
    {
        for (member& m : members_)
        {
            if (!m.failed && int(m.records.size()) <= round)
            {
                runOnce(m);
            }
        }
    }
}


void studyRun::runOnce(member& m)
{
    ++done_;
    try
    {
        m.directory.prepare();
        m.records.push_back(m.directory.run());
        m.directory.keep(m.records);
        warnOfRepeats(m);
        warnOnce(m);
        m.directory.removeFields();
    }
    catch (const std::exception& e)
    {
        fail(m, e.what());
        return;
    }
    const runRecord& r = m.records.back();
    info
    (
        "[{}/{}] {}: {} {:.4e}, loop {:.4g} s, total {:.4g} s; "
        "to finish {:.3g} s",
        done_, all_, m.what.name,
        study_.error.finest ? "value" : "error", r.error, r.loopSeconds,
        r.totalSeconds, secondsToFinish()
    );
    std::fflush(stdout);
}


void studyRun::fail(member& m, const std::string& why)
{
    m.failed = true;
    all_ -= std::max(0, study_.repeats - int(m.records.size()) - 1);
    failures_.push_back(m.what.name + ": " + why);
    info("[{}/{}] {}: FAILED: {}", done_, all_, m.what.name, why);
    if (why.find("longer than timeLimit") != std::string::npos)
    {
        dropFiner(m);
    }
    std::fflush(stdout);
}


//- What took too long in an earlier call
void studyRun::leaveOutKnown()
{
    for (member& m : members_)
    {
        if (runsLeft(m) > 0 && m.directory.knownTooLong())
        {
            leaveOut
            (
                m, "it took longer than timeLimit before; -force tries again"
            );
            dropFiner(m);
        }
    }
}


void studyRun::leaveOut(member& m, const std::string& why)
{
    all_ -= runsLeft(m);
    m.failed = true;
    failures_.push_back(m.what.name + ": left out, as " + why);
    info("{}", failures_.back());
}


void studyRun::dropFiner(const member& slow)
{
    for (member& m : members_)
    {
        if
        (
            !m.failed && m.what.curve == slow.what.curve && m.records.empty()
         && m.what.choice[study_.resolution]
          > slow.what.choice[study_.resolution]
        )
        {
            leaveOut
            (
                m,
                slow.what.name
              + ", which is coarser, took longer than timeLimit"
            );
        }
    }
}


//- A key that nobody reads makes two variants one
void studyRun::warnOnce(const member& m)
{
    std::istringstream log(readCaseFile(m.directory.path()/"log.study"));
    for (std::string line; std::getline(log, line);)
    {
        const std::size_t at = line.find("Unused ");
        const std::size_t in = line.find("' in \"");
        if (at == line.npos || in == line.npos)
        {
            continue;
        }
        const std::string what = line.substr(at, in + 1 - at);
        if (std::find(warnings_.begin(), warnings_.end(), what)
         == warnings_.end())
        {
            warnings_.push_back(what);
            warning(m.what.name + ": " + line.substr(at));
        }
    }
}


//- Runs of a variant are the same to the byte, unless its programs have changed
//  or its commands depend on something else
void studyRun::warnOfRepeats(const member& m) const
{
    const double first = m.records.front().error;
    const double last = m.records.back().error;
    if (last != first)
    {
        warning
        (
            fmt::format
            (
                "{}: its runs differ in {}: {:.9g} and {:.9g}", m.what.name,
                study_.error.finest ? "value" : "error", first, last
            )
        );
    }
}


//- Errors at different times are not those of one problem
void studyRun::warnOfTimes() const
{
    const member* first = nullptr;
    for (const member& m : members_)
    {
        if (m.records.empty())
        {
            continue;
        }
        const double time = m.records.back().time;
        first = first ? first : &m;
        const double wanted = first->records.back().time;
        if (std::fabs(time - wanted) > 1e-6*std::fabs(wanted))
        {
            warning
            (
                fmt::format
                (
                    "The error of {} is that at Time = {:g}, but the error of "
                    "{} is that at Time = {:g}", m.what.name, time,
                    first->what.name, wanted
                )
            );
            return;
        }
    }
}


double studyRun::secondsToFinish() const
{
    double sum = 0;
    int n = 0;
    for (const member& m : members_)
    {
        for (const runRecord& r : m.records)
        {
            sum += r.wallSeconds;
            ++n;
        }
    }
    double left = 0;
    for (const member& m : members_)
    {
        left += runsLeft(m)
           *(m.records.empty() ? sum/n : m.records.back().wallSeconds);
    }
    return left;
}


curvePoint studyRun::pointOf(const member& m) const
{
    curvePoint p;
    p.resolution = m.what.resolution;
    p.size = m.what.size;
    p.repeats = m.records.size();
    p.run = m.records.back();
    std::vector<double> error, loop, total;
    for (const runRecord& r : m.records)
    {
        error.push_back(r.error);
        loop.push_back(r.loopSeconds);
        total.push_back(r.totalSeconds);
        if (r.machine != p.run.machine)
        {
            p.run.machine += " and " + r.machine;
        }
    }
    p.error = spread::of(error).median;
    p.run.error = p.error;
    p.seconds = spread::of(study_.total ? total : loop);
    p.run.loopSeconds = spread::of(loop).median;
    p.run.totalSeconds = spread::of(total).median;
    return p;
}


void studyRun::compareWithFinestRuns(std::vector<curve>& all)
{
    const std::string finest =
        study_.parameters[study_.resolution].choices.back().label;
    for (curve& c : all)
    {
        const std::string why = compareWithFinest(c, finest);
        if (!why.empty())
        {
            failures_.push_back("curve " + c.name + ": left out, as " + why);
            info("{}", failures_.back());
            c.points.clear();
        }
    }
}


std::vector<curve> studyRun::curves()
{
    warnOfTimes();
    std::vector<curve> all;
    for (const member& m : members_)
    {
        if (m.records.empty())
        {
            continue;
        }
        if (all.empty() || all.back().name != m.what.curve)
        {
            all.push_back({m.what.curve, false, {}});
        }
        all.back().points.push_back(pointOf(m));
    }
    if (study_.error.finest)
    {
        compareWithFinestRuns(all);
    }
    for (curve& c : all)
    {
        addOrders(c);
    }
    return all;
}

} // namespace gpuFsi
