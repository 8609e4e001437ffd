#include "case/timeControls.H"

#include "base/log.H"

#include <charconv>
#include <cmath>
#include <csignal>
#include <limits>

namespace gpuFsi
{

namespace
{

constexpr double infinite = std::numeric_limits<double>::infinity();

//- Read on behalf of others, or without effect here
void markKnown(const dictionary& dict, const std::string& key)
{
    if (dict.isDict(key))
    {
        dict.subDict(key);
    }
    else if (dict.found(key))
    {
        dict.tokens(key);
    }
}

double positive(const dictionary& dict, const std::string& key)
{
    const double value = dict.get<double>(key);
    if (!(value > 0) || std::isinf(value))
    {
        throw userError
        (
            key + " must be positive and finite, found "
          + fmt::format("{}", value),
            dict.where(key)
        );
    }
    return value;
}

int whole
(
    const dictionary& dict,
    const std::string& key,
    int otherwise,
    int low,
    int high
)
{
    if (!dict.found(key))
    {
        return otherwise;
    }
    dict.getNumber(key, low, high);
    return dict.get<int>(key);
}

timeControls::stop readStop(const dictionary& dict)
{
    using stop = timeControls::stop;
    const std::string word = dict.getChoiceOrDefault
    (
        "stopAt",
        "endTime",
        {"endTime", "noWriteNow", "writeNow", "nextWrite"}
    );
    return word == "endTime" ? stop::endTime
        : word == "noWriteNow" ? stop::noWriteNow
        : word == "writeNow" ? stop::writeNow
        : stop::nextWrite;
}

timeControls::writing readWriteControl(const dictionary& dict)
{
    using writing = timeControls::writing;
    const std::string word = dict.getChoiceOrDefault
    (
        "writeControl",
        "timeStep",
        {
            "timeStep", "runTime", "adjustableRunTime", "adjustable",
            "clockTime", "cpuTime", "none"
        }
    );
    return word == "timeStep" ? writing::timeStep
        : word == "runTime" ? writing::runTime
        : word == "clockTime" ? writing::clockTime
        : word == "cpuTime" ? writing::cpuTime
        : word == "none" ? writing::none
        : writing::adjustableRunTime;
}

void readWriteInterval(const dictionary& dict, timeControls& controls)
{
    if (controls.writeControl == timeControls::writing::none)
    {
        markKnown(dict, "writeInterval");
        return;
    }
    const double interval = positive(dict, "writeInterval");
    if
    (
        controls.writeControl == timeControls::writing::timeStep
     && (interval < 1 || interval != std::floor(interval))
    )
    {
        throw userError
        (
            "writeInterval " + fmt::format("{}", interval)
          + (interval < 1 ? " < 1" : " is not a whole number")
          + " for writeControl timeStep, which counts steps",
            dict.where("writeInterval"),
            "Give a number of steps, or writeControl runTime or "
            "adjustableRunTime for seconds."
        );
    }
    controls.writeInterval = interval;
}

bool readCompression(const dictionary& dict, bool binary)
{
    const std::string word = dict.getChoiceOrDefault
    (
        "writeCompression",
        "off",
        {
            "on", "off", "true", "false", "yes", "no", "y", "n", "t", "f",
            "compressed", "uncompressed"
        }
    );
    const bool on = word == "on" || word == "true" || word == "yes"
        || word == "y" || word == "t" || word == "compressed";
    if (on && binary)
    {
        warning
        (
            "writeCompression on does nothing for binary files; it is reset "
            "to off"
        );
        return false;
    }
    return on;
}

int readSignal(const dictionary& dict, const std::string& key)
{
    const int number = dict.getOrDefault<int>(key, -1);
    const bool valid = number == -1
        || (number > 0 && number < NSIG && number != SIGKILL
         && number != SIGSTOP);
    if (!valid)
    {
        throw userError
        (
            key + " " + std::to_string(number) + " is not a signal",
            dict.where(key),
            "Take -1 (none), 10 (SIGUSR1) or 12 (SIGUSR2)."
        );
    }
    return number;
}

} // namespace

timeControls timeControls::read(const dictionary& dict)
{
    for (const char* others : {"application", "libs", "functions"})
    {
        markKnown(dict, others);
    }
    timeControls c;
    c.startFrom = dict.getChoiceOrDefault
    (
        "startFrom",
        "latestTime",
        {"startTime", "firstTime", "latestTime"}
    );
    if (c.startFrom == "startTime" || dict.found("startTime"))
    {
        c.startTime = dict.get<double>("startTime");
    }
    c.stopAt = readStop(dict);
    c.endTime = infinite;
    if (c.stopAt == stop::endTime)
    {
        c.endTime = dict.get<double>("endTime");
    }
    else
    {
        markKnown(dict, "endTime");
    }
    c.deltaT = positive(dict, "deltaT");
    c.writeControl = readWriteControl(dict);
    readWriteInterval(dict, c);
    c.purgeWrite = whole(dict, "purgeWrite", 0, 0, 1000000000);
    c.output.binary = dict.getChoiceOrDefault
    (
        "writeFormat",
        "ascii",
        {"ascii", "binary"}
    ) == "binary";
    c.output.precision = whole(dict, "writePrecision", 6, 1, 17);
    c.output.compress = readCompression(dict, c.output.binary);
    c.timeFormat = dict.getChoiceOrDefault
    (
        "timeFormat",
        "general",
        {"general", "fixed", "scientific"}
    );
    c.timePrecision = whole(dict, "timePrecision", 6, 1, 17);
    c.runTimeModifiable = dict.getOrDefault("runTimeModifiable", false);
    c.adjustTimeStep = dict.getOrDefault("adjustTimeStep", false);
    c.maxCo = 1;
    if (dict.found("maxCo"))
    {
        c.maxCo = positive(dict, "maxCo");
    }
    c.maxDeltaT = dict.found("maxDeltaT")
        ? positive(dict, "maxDeltaT")
        : infinite;
    c.writeNowSignal = readSignal(dict, "writeNowSignal");
    c.stopAtWriteNowSignal = readSignal(dict, "stopAtWriteNowSignal");
    return c;
}

std::string timeControls::timeName(double value, int precision) const
{
    return formatTime(value, timeFormat, precision);
}

std::string formatTime
(
    double value,
    const std::string& timeFormat,
    int precision
)
{
    char text[400];
    const auto format = timeFormat == "fixed" ? std::chars_format::fixed
        : timeFormat == "scientific" ? std::chars_format::scientific
        : std::chars_format::general;
    return
    {
        text,
        std::to_chars(text, text + sizeof text, value, format, precision).ptr
    };
}

} // namespace gpuFsi
