// Cases of our programs, read by OpenFOAM's and by ParaView's reader.
#include "systemCase.H"

#include "case/cloud.H"

#include <gtest/gtest.h>

#include <map>
#include <sstream>

namespace
{

constexpr const char* control = "system/controlDict";

//- To go before a command of OpenFOAM's; none: not installed
const char* environment(const std::filesystem::path& scratch)
{
    for (const char* before :
        {"", ". /usr/share/openfoam/etc/bashrc > /dev/null 2>&1; "})
    {
        const std::string test = before + std::string("checkMesh -help");
        if (shell(test, scratch).code == 0)
        {
            return before;
        }
    }
    return nullptr;
}

systemCase result(systemCase c, const char* format)
{
    c.set(control, "writeFormat", format);
    c.add(control, "writePrecision 9;");
    c.seed();
    const outcome o = c.run(app::gpuFsiFoam);
    EXPECT_EQ(o.code, 0) << o.err;
    return c;
}

//- Numbers of the DataArray `name` of an ascii .vtp
std::vector<double> vtpArray(const std::string& vtp, const std::string& name)
{
    std::vector<double> values;
    const std::size_t at = vtp.find("Name='" + name + "'");
    if (at != std::string::npos)
    {
        std::istringstream in(vtp.substr(vtp.find('>', at) + 1));
        for (double v; in >> v; )
        {
            values.push_back(v);
        }
    }
    return values;
}

void expectPositions
(
    const std::vector<double>& found,
    const gpuFsi::cloud& c
)
{
    ASSERT_EQ(found.size(), 3*c.size());
    for (std::size_t i = 0; i < c.size(); ++i)
    {
        EXPECT_NEAR(found[3*i], c.positions[i].x, 1e-5);
        EXPECT_NEAR(found[3*i + 1], c.positions[i].y, 1e-5);
        EXPECT_NEAR(found[3*i + 2], c.positions[i].z, 1e-5);
    }
}

//- Without quotes and space at the end, of which OpenFOAM has its own mind
std::string bare(std::string value)
{
    std::string text;
    for (const char c : value)
    {
        text += c == '"' || c == '\n' ? "" : std::string(1, c);
    }
    return text;
}

} // namespace


TEST(interoperability, foamDictionaryReadsOurDictionaries)
{
    const systemCase c = result(systemCase::piston(), "binary");
    const char* before = environment(c.path());
    if (!before)
    {
        GTEST_SKIP() << "OpenFOAM's programs are not installed";
    }
    struct { const char *file, *entry, *value; } rows[] =
    {
        {"system/controlDict", "writePrecision", "9"},
        {"system/particleSchemes", "neighbours/method", "cellSearch"},
        {"system/seedParticlesDict", "regions/end/type", "plane"},
        {"constant/fluidProperties", "equationOfState/type", "Tait"},
        {"constant/wallProperties", "piston/omega", "3"},
        {"constant/domain", "dimensions", "2"},
        {"constant/domain", "walls", "( piston end )"},
        {"0.4/uniform/time", "index", "40"},
        {"0.4/uniform/time", "name", "0.4"},
        {"0.4/uniform/lagrangian/fluid/cloudProperties", "geometry",
            "positions"},
    };
    for (const auto& row : rows)
    {
        const outcome o = shell
        (
            std::string(before) + "foamDictionary -entry " + row.entry
              + " -value " + row.file,
            c.path()
        );
        EXPECT_EQ(o.code, 0) << row.file << o.out << o.err;
        EXPECT_EQ(bare(o.out), row.value) << row.file << ' ' << row.entry;
    }
}


TEST(interoperability, checkMeshAndFoamToVTKReadOurCases)
{
    for (const char* format : {"ascii", "binary"})
    {
        systemCase pulse = systemCase::pulse();
        pulse.set(control, "endTime", "0.2");
        for (const systemCase& start : {pulse, systemCase::piston()})
        {
            const systemCase c = result(start, format);
            const char* before = environment(c.path());
            if (!before)
            {
                GTEST_SKIP() << "OpenFOAM's programs are not installed";
            }
            // OpenFOAM does not know our function objects
            const outcome mesh = shell
            (
                before + std::string("checkMesh -noFunctionObjects"),
                c.path()
            );
            EXPECT_EQ(mesh.code, 0) << mesh.out << mesh.err;
            EXPECT_TRUE(mesh.says("Mesh OK.")) << mesh.out;

            const outcome o = shell
            (
                before + std::string("foamToVTK -noFunctionObjects "
                    "-latestTime -ascii -no-internal -no-boundary"),
                c.path()
            );
            EXPECT_EQ(o.code, 0) << o.out << o.err;
            const std::string time = c.timeNames().back();
            for (const char* name : {"fluid", "walls"})
            {
                const gpuFsi::cloud expected =
                    gpuFsi::readCloud(c.path()/time, name);
                std::string vtp;
                for (const auto& [file, bytes] : c.tree())
                {
                    const std::string wanted =
                        std::string("VTK/lagrangian/") + name + '/';
                    vtp = file.compare(0, wanted.size(), wanted) == 0
                        && file.find(".vtp") + 4 == file.size()
                      ? bytes : vtp;
                }
                expectPositions(vtpArray(vtp, "Points"), expected);
                const auto rho = vtpArray(vtp, "rho");
                ASSERT_EQ(rho.size(), expected.size());
                for (std::size_t i = 0; i < rho.size(); ++i)
                {
                    // foamToVTK prints 6 digits
                    EXPECT_NEAR(rho[i], expected.find("rho")->values[i],
                        2e-5);
                }
            }
        }
    }
}


TEST(interoperability, paraViewsReaderReadsOurCases)
{
    for (const char* format : {"ascii", "binary"})
    {
        const systemCase c = result(systemCase::piston(), format);
        const std::string reader =
            (c.path()/(c.path().filename().string() + ".foam")).string();
        outcome o;
        o.code = 77;
        for (const char* python : {"python3", "/usr/bin/python3"})
        {
            if (o.code == 77 || o.code == 127)
            {
                o = run({python, READ_WITH_VTK, reader}, c.path());
            }
        }
        if (o.code == 77 || o.code == 127)
        {
            GTEST_SKIP() << "VTK's Python modules are not installed";
        }
        ASSERT_EQ(o.code, 0) << o.err;
        std::istringstream in(o.out);
        int nClouds = 0;
        std::string name, fields;
        for (std::size_t n; in >> name >> n >> fields; ++nClouds)
        {
            const gpuFsi::cloud expected =
                gpuFsi::readCloud(c.path()/"0.4", name);
            ASSERT_EQ(n, expected.size());
            for (const gpuFsi::cloudField& f : expected.fields)
            {
                EXPECT_NE((',' + fields + ',').find(',' + f.name + ','),
                    std::string::npos) << f.name << " in " << fields;
            }
            std::vector<double> positions;
            for (std::size_t i = 0; i < n; ++i)
            {
                double v[4];
                in >> v[0] >> v[1] >> v[2] >> v[3];
                positions.insert(positions.end(), v, v + 3);
                EXPECT_NEAR(v[3], expected.find("rho")->values[i], 1e-6);
            }
            expectPositions(positions, expected);
        }
        EXPECT_EQ(nClouds, 2) << o.out;
    }
}
