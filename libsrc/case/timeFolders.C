#include "case/Time.H"

#include "case/argList.H"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <sstream>

namespace gpuFsi
{

namespace
{

constexpr double infinite = std::numeric_limits<double>::infinity();

bool parseTime(const std::string& text, double& value)
{
    if (text.find_first_not_of("0123456789+-.eE") != std::string::npos)
    {
        return false;
    }
    const char* end = text.data() + text.size();
    const auto result = std::from_chars(text.data(), end, value);
    return result.ec == std::errc() && result.ptr == end;
}

struct timeRange
{
    double low, high;

    bool contains(double t) const
    {
        const double slack = low == high ? 1e-6*std::abs(low) + 1e-300 : 0;
        return t >= low - slack && t <= high + slack;
    }
};

double bound(const std::string& text, const std::string& all, double open)
{
    double value = open;
    if (!text.empty() && !parseTime(text, value))
    {
        throw userError
        (
            "-time " + all + ": '" + text + "' is not a number",
            {},
            "Give times and ranges, as -time ':10,20,40:70'."
        );
    }
    return value;
}

std::vector<timeRange> parseRanges(const std::string& text)
{
    std::vector<timeRange> ranges;
    std::stringstream list(text);
    for (std::string part; std::getline(list, part, ',');)
    {
        const std::size_t colon = part.find(':');
        if (colon == std::string::npos)
        {
            const double t = bound(part, text, std::nan(""));
            ranges.push_back({t, t});
        }
        else
        {
            ranges.push_back
            ({
                bound(part.substr(0, colon), text, -infinite),
                bound(part.substr(colon + 1), text, infinite)
            });
        }
    }
    return ranges;
}

} // namespace

std::vector<instant> findTimes(const std::filesystem::path& casePath)
{
    std::vector<instant> times;
    std::error_code failed;
    std::filesystem::directory_iterator entries(casePath, failed);
    if (failed)
    {
        throw userError
        (
            "Cannot look for times in " + casePath.string() + ": "
          + failed.message()
        );
    }
    for (const auto& entry : entries)
    {
        const std::string name = entry.path().filename().string();
        double value;
        if (entry.is_directory() && parseTime(name, value))
        {
            times.push_back({name, value});
        }
    }
    std::sort
    (
        times.begin(),
        times.end(),
        [](const instant& a, const instant& b)
        {
            return a.value < b.value
                || (a.value == b.value && a.name < b.name);
        }
    );
    return times;
}

std::vector<instant> selectTimes
(
    const std::vector<instant>& all,
    const argList& args
)
{
    const bool latest = args.found("latestTime");
    std::vector<timeRange> ranges;
    if (args.found("time"))
    {
        ranges = parseRanges(args.get("time"));
    }
    else if (!latest)
    {
        ranges.push_back({-infinite, infinite});
    }
    std::vector<instant> selected;
    for (const instant& t : all)
    {
        const bool wanted = (latest && t.name == all.back().name)
            || std::any_of
            (
                ranges.begin(),
                ranges.end(),
                [&](const timeRange& r) { return r.contains(t.value); }
            );
        if (wanted && !(args.found("noZero") && t.value == 0))
        {
            selected.push_back(t);
        }
    }
    if (selected.empty() && args.found("time"))
    {
        std::string there;
        for (const instant& t : all)
        {
            there += " " + t.name;
        }
        throw userError
        (
            "-time " + args.get("time") + " selects none of the times of the "
            "case:" + (there.empty() ? " there are none" : there)
        );
    }
    return selected;
}

} // namespace gpuFsi
