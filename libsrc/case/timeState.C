#include "case/timeState.H"

#include "base/log.H"
#include "case/caseFileIO.H"
#include "case/foamFile.H"

#include <algorithm>
#include <cmath>

namespace gpuFsi
{

long timeState::intervalIndex(double interval) const
{
    return long(std::floor((value - beginTime + 0.5*deltaT)/interval));
}

void timeState::fitToWriteTime(double wanted)
{
    const double toNext = std::max
    (
        0.0,
        (writeIndex + 1)*writeInterval - (value - beginTime)
    );
    const double nSteps = toNext/wanted;
    deltaT = wanted;
    if (nSteps > 1e-6 && nSteps < 1e9)
    {
        deltaT = toNext/std::max(1.0, std::ceil(nSteps - 1e-6));
    }
}

void timeState::advance(bool toWriteTime)
{
    deltaT0 = baseDeltaT;
    if (deltaT != baseDeltaT)
    {
        baseValue = value;
        baseIndex = index;
        baseDeltaT = deltaT;
    }
    ++index;
    value = baseValue + (index - baseIndex)*baseDeltaT;
    if (std::abs(value) < 1e-10*deltaT)
    {
        value = 0;
    }
    if (toWriteTime)
    {
        const double target = beginTime + (writeIndex + 1)*writeInterval;
        if (std::abs(value - target) < 1e-6*deltaT)
        {
            value = baseValue = target;
            baseIndex = index;
        }
    }
}

void timeState::write
(
    const std::filesystem::path& timeDirectory,
    const std::string& name
) const
{
    foamFile header;
    header.cls = "dictionary";
    header.location = name + "/uniform";
    header.object = "time";
    writeTextFile
    (
        timeDirectory/"uniform/time",
        header.text() + fmt::format
        (
            "value           {:.17g};\n"
            "name            \"{}\";\n"
            "index           {};\n"
            "deltaT          {:.17g};\n"
            "deltaT0         {:.17g};\n\n"
            "// For a restart that takes the same steps bit for bit\n"
            "beginTime       {:.17g};\n"
            "baseValue       {:.17g};\n"
            "baseIndex       {};\n"
            "baseDeltaT      {:.17g};\n"
            "writeIndex      {};\n"
            "writeInterval   {:.17g};\n"
            "timePrecision   {};\n",
            value, name, index, deltaT, deltaT0, beginTime, baseValue,
            baseIndex, baseDeltaT, writeIndex, writeInterval, timePrecision
        )
    );
}

timeState timeState::read
(
    const std::filesystem::path& timeDirectory,
    double valueOfName,
    const timeControls& controls
)
{
    timeState s;
    s.value = s.baseValue = s.beginTime = valueOfName;
    s.deltaT = s.deltaT0 = controls.deltaT;
    s.timePrecision = controls.timePrecision;

    const std::filesystem::path file = timeDirectory/"uniform/time";
    const std::string name = timeDirectory.filename().string();
    bool whole = false;
    if (std::filesystem::exists(file))
    {
        const dictionary dict = dictionary::fromFile(file);
        const std::string written = dict.getOrDefault("name", name);
        if (written != name)
        {
            info
            (
                "{} was written as time {}: starting afresh at time {}",
                timeDirectory.string(), written, name
            );
            return s;
        }
        s.value = dict.getOrDefault("value", valueOfName);
        s.index = dict.getOrDefault<long>("index", 0);
        s.deltaT0 = dict.getOrDefault("deltaT0", s.deltaT0);
        if (controls.adjustTimeStep)
        {
            s.deltaT = dict.getOrDefault("deltaT", s.deltaT);
            if (!(s.deltaT > 0))
            {
                throw userError
                (
                    fmt::format
                    (
                        "deltaT is {}, but must be positive", s.deltaT
                    ),
                    dict.where("deltaT"),
                    "Remove the file to start afresh with the deltaT of "
                    "controlDict, or start from an earlier time."
                );
            }
        }
        s.beginTime = dict.getOrDefault("beginTime", s.value);
        s.timePrecision = std::max
        (
            s.timePrecision,
            int(dict.getNumberOrDefault("timePrecision", 1, 1, 17))
        );
        whole = dict.found("baseValue");
        if (whole)
        {
            s.baseValue = dict.get<double>("baseValue");
            s.baseIndex = dict.get<long>("baseIndex");
            s.baseDeltaT = dict.get<double>("baseDeltaT");
            s.writeIndex = dict.get<long>("writeIndex");
            s.writeInterval = dict.get<double>("writeInterval");
        }
    }
    if (!whole)
    {
        s.baseValue = s.value;
        s.baseIndex = s.index;
        s.baseDeltaT = s.deltaT;
    }
    return s;
}

} // namespace gpuFsi
