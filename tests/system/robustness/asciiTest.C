// Text files, compressed or not: read by all programs, equal to the binary
// ones within the digits written.
#include "systemCase.H"

#include "case/caseFileIO.H"
#include "case/cloud.H"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{

constexpr const char* control = "system/controlDict";

systemCase written(const char* format, const char* compression)
{
    systemCase c = systemCase::piston();
    c.set(control, "writeFormat", format);
    c.add(control, std::string("writeCompression ") + compression + ';');
    c.add(control, "writePrecision 12;");
    c.seed();
    const outcome o = c.run(app::gpuFsiFoam);
    EXPECT_EQ(o.code, 0) << o.out << o.err;
    return c;
}

//- Largest difference of two clouds' fields and positions, each relative to
//  the field's largest value
double apart(const gpuFsi::cloud& a, const gpuFsi::cloud& b)
{
    double largest = 0;
    EXPECT_EQ(a.size(), b.size());
    EXPECT_EQ(a.fields.size(), b.fields.size());
    for (std::size_t i = 0; i < a.size(); ++i)
    {
        const gpuFsi::vector d = a.positions[i] - b.positions[i];
        largest = std::max(largest, std::sqrt(dot(d, d)));
    }
    for (const gpuFsi::cloudField& field : a.fields)
    {
        const gpuFsi::cloudField* other = b.find(field.name);
        if (!other || other->values.size() != field.values.size())
        {
            ADD_FAILURE() << field.name;
            continue;
        }
        double scale = 1e-300, difference = 0;
        for (std::size_t i = 0; i < field.values.size(); ++i)
        {
            scale = std::max(scale, std::abs(field.values[i]));
            difference = std::max
            (
                difference,
                std::abs(field.values[i] - other->values[i])
            );
        }
        largest = std::max(largest, difference/scale);
    }
    return largest;
}

} // namespace


TEST(ascii, holdsTheSameNumbers)
{
    const systemCase binary = written("binary", "off");
    const systemCase text = written("ascii", "off");
    const std::vector<std::string> names = binary.timeNames();
    EXPECT_EQ(names, text.timeNames());
    for (const std::string& time : names)
    {
        for (const char* cloud : {"fluid", "walls"})
        {
            const double d = apart
            (
                gpuFsi::readCloud(binary.path()/time, cloud),
                gpuFsi::readCloud(text.path()/time, cloud)
            );
            EXPECT_LT(d, 1e-8) << time << ' ' << cloud;
        }
    }
}


TEST(ascii, compressedFilesHoldTheSameText)
{
    const systemCase plain = written("ascii", "off");
    const systemCase zipped = written("ascii", "on");
    std::size_t nZipped = 0;
    for (const auto& [name, bytes] : plain.times())
    {
        if (std::filesystem::is_regular_file(plain.path()/name))
        {
            EXPECT_EQ(gpuFsi::readCaseFile(zipped.path()/name), bytes)
                << name;
            nZipped += std::filesystem::exists
            (
                (zipped.path()/name).string() + ".gz"
            );
        }
    }
    EXPECT_GT(nZipped, 20u);

    // Taken up again and converted
    systemCase again(zipped);
    again.remove(again.timeNames().back());
    again.set(control, "startFrom", "latestTime");
    const outcome o = again.run(app::gpuFsiFoam);
    EXPECT_EQ(o.code, 0) << o.err;
    EXPECT_EQ(again.timeNames(), zipped.timeNames());
    EXPECT_LT
    (
        apart
        (
            gpuFsi::readCloud(again.path()/"0.4", "fluid"),
            gpuFsi::readCloud(zipped.path()/"0.4", "fluid")
        ),
        1e-6
    );
    const outcome converted = zipped.run(app::particlesToVTK);
    EXPECT_EQ(converted.code, 0) << converted.err;
    EXPECT_TRUE(zipped.tree().count("VTK/lagrangian/fluid/fluid_4.vtp"));
}


TEST(ascii, binaryIsNotCompressed)
{
    const systemCase plain = written("binary", "off");
    const systemCase asked = written("binary", "on");
    EXPECT_EQ(difference(asked.times(), plain.times()), "");
    const outcome o = asked.run(app::gpuFsiFoam);
    EXPECT_NE(o.err.find("reset to off"), std::string::npos) << o.err;
}
