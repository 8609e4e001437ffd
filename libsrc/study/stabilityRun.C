#include "study/stabilityRun.H"

#include "base/log.H"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace gpuFsi
{

stabilityRun::stabilityRun
(
    const stabilityDict& map,
    const std::filesystem::path& casePath
)
:
    map_(map)
{
    for (const variant& v : allVariants(map))
    {
        results_.push_back({v, {}});
    }
    const std::string bytes = fingerprint(map, casePath);
    for (stabilityResult& r : results_)
    {
        directories_.emplace_back(map, casePath, bytes, r.what);
        r.record = directories_.back().earlier();
        kept_ += bool(r.record);
    }
}


void stabilityRun::forget()
{
    for (std::size_t i = 0; i < results_.size(); ++i)
    {
        directories_[i].forget();
        results_[i].record.reset();
    }
    kept_ = 0;
}


void stabilityRun::run()
{
    info
    (
        "{} variants: {} to do, {} kept from before\n", results_.size(),
        results_.size() - kept_, kept_
    );
    for (std::size_t i = 0; i < results_.size(); ++i)
    {
        if (!results_[i].record)
        {
            runOnce(i);
        }
    }
}


void stabilityRun::runOnce(std::size_t i)
{
    stabilityRecord r;
    try
    {
        directories_[i].prepare();
        r = directories_[i].run();
        directories_[i].keep(r);
        if (allowed(r.kind))
        {
            directories_[i].removeFields();
        }
    }
    catch (const std::exception& e)
    {
        r.word = e.what();
    }
    ++done_;
    seconds_ += r.seconds;
    results_[i].record = r;
    info
    (
        "[{}/{}] {}: {}{}, {:.3g} s; to finish {:.3g} s{}",
        done_, results_.size() - kept_, results_[i].what.name,
        nameOf(r.kind),
        std::isfinite(r.error) ? fmt::format(", error {:.4e}", r.error) : "",
        r.seconds, secondsToFinish(), r.word.empty() ? "" : "\n    " + r.word
    );
    std::fflush(stdout);
}


double stabilityRun::secondsToFinish() const
{
    return seconds_/done_*(results_.size() - kept_ - done_);
}


std::size_t stabilityRun::nBad() const
{
    return std::count_if(results_.begin(), results_.end(), [](const auto& r)
    {
        return r.record && !allowed(r.record->kind);
    });
}

} // namespace gpuFsi
