// Cases of ours read by OpenFOAM's own programs and by ParaView's reader
#include "timeCase.H"

#include "case/cloud.H"

#include <cmath>
#include <cstdio>

using namespace gpuFsi;

namespace
{

class openFOAM
:
    public timeCase
{
public:

    static constexpr int nParticles = 40;

    //- 0 in ascii, 0.5 in binary, 1 in compressed ascii
    void writeCase(bool flat = false) const
    {
        control
        (
            "deltaT 0.5; endTime 1; writeControl adjustableRunTime;"
            "writeInterval 0.5; startFrom firstTime; startTime 0;"
            "stopAt endTime; adjustTimeStep no; maxCo 0.5; functions {}"
        );
        const cloud c = makeCloud(flat);
        writeCloud(path/"0", c, {false, 10, false});
        Time time(path);
        for (bool binary : {true, false})
        {
            ++time;
            time.write([&](const std::filesystem::path& folder)
            {
                writeCloud(folder, c, {binary, 10, !binary});
            });
        }
        writeBoxMesh(path, {0, 0, 0}, {1, 1, flat ? 0. : 1.});
        writeReaderFiles(path);
    }

    static cloud makeCloud(bool flat)
    {
        cloud c;
        c.name = "fluid";
        std::vector<double> rho, id;
        std::vector<vector> velocity;
        for (int i = 0; i < nParticles; ++i)
        {
            c.positions.push_back
            ({
                0.01 + i/41.,
                0.5 + 0.4*std::sin(i),
                flat ? 0 : 0.1 + i/100.
            });
            velocity.push_back({1. + i, -0.25*i, i/1024.});
            rho.push_back(1000 + i);
            id.push_back(i);
        }
        c.addVector("U", velocity);
        c.addScalar("rho", rho);
        c.addLabel("id", id);
        c.addScalar("m", std::vector<double>(nParticles, 2.5));
        return c;
    }

    //- Exit code; what is printed goes to `output`
    static int shell(const std::string& command, std::string& output)
    {
        output.clear();
        FILE* pipe = popen(("bash -c '" + command + "' 2>&1").c_str(), "r");
        char part[4096];
        std::size_t n;
        while ((n = fread(part, 1, sizeof part, pipe)) > 0)
        {
            output.append(part, n);
        }
        return WEXITSTATUS(pclose(pipe));
    }

    //- Command to run before a program of OpenFOAM, or false without it
    static bool environment(std::string& before)
    {
        std::string output;
        for (const char* setUp :
            {"", ". /usr/share/openfoam/etc/bashrc >/dev/null 2>&1; "})
        {
            before = setUp;
            if (shell(before + "checkMesh -help", output) == 0)
            {
                return true;
            }
        }
        return false;
    }
};

//- Numbers of the DataArray `name` of an ascii .vtp
std::vector<double> vtpArray(const std::string& vtp, const std::string& name)
{
    std::vector<double> values;
    const std::size_t at = vtp.find("Name='" + name + "'");
    if (at != std::string::npos)
    {
        std::istringstream in(vtp.substr(vtp.find('>', at) + 1));
        for (double v; in >> v;)
        {
            values.push_back(v);
        }
    }
    return values;
}

} // namespace

TEST_F(openFOAM, checkMeshAndFoamToVTKReadOurCases)
{
    std::string before;
    if (!environment(before))
    {
        GTEST_SKIP() << "OpenFOAM's programs are not installed";
    }
    for (bool flat : {false, true})
    {
        writeCase(flat);
        const std::string onCase = " -case " + path.string();
        std::string output;
        EXPECT_EQ(shell(before + "checkMesh" + onCase, output), 0) << output;
        EXPECT_TRUE(says(output, "Mesh OK."));
        EXPECT_TRUE(says(output, "cells:            1"));

        EXPECT_EQ
        (
            shell(before + "foamToVTK -ascii -no-internal -no-boundary"
                + onCase, output),
            0
        ) << output;
        const cloud c = makeCloud(flat);
        for (int t = 0; t < 3; ++t)
        {
            const std::string vtp = text
            (
                "VTK/lagrangian/fluid/fluid_" + std::to_string(t) + ".vtp"
            );
            const auto points = vtpArray(vtp, "Points");
            ASSERT_EQ(points.size(), 3u*nParticles) << output << vtp;
            for (int i = 0; i < nParticles; ++i)
            {
                EXPECT_NEAR(points[3*i], c.positions[i].x, 1e-5);
                EXPECT_NEAR(points[3*i + 1], c.positions[i].y, 1e-5);
                EXPECT_NEAR(points[3*i + 2], c.positions[i].z, 1e-5);
            }
            EXPECT_EQ(vtpArray(vtp, "id"), c.find("id")->values);
            EXPECT_EQ(vtpArray(vtp, "rho"), c.find("rho")->values);
            EXPECT_EQ(vtpArray(vtp, "m"), c.find("m")->values);
            EXPECT_EQ(vtpArray(vtp, "U").size(), 3u*nParticles);
        }
        std::filesystem::remove_all(path/"VTK");
        std::filesystem::remove_all(path/"0.5");
        std::filesystem::remove_all(path/"1");
    }
}

TEST_F(openFOAM, paraViewsReaderReadsOurCases)
{
    writeCase();
    const std::string arguments = " " CASE_TESTS "/readWithVTK.py "
        + (path/(path.filename().string() + ".foam")).string() + " fluid";
    std::string output;
    int code = 77;
    for (const char* python : {"python3", "/usr/bin/python3"})
    {
        if (code == 77 || code == 127)
        {
            code = shell(python + arguments, output);
        }
    }
    if (code == 77 || code == 127)
    {
        GTEST_SKIP() << "VTK's Python modules are not installed";
    }
    ASSERT_EQ(code, 0) << output;
    const cloud c = makeCloud(false);
    std::istringstream in(output);
    for (double wanted : {0., 0.5, 1.})
    {
        double time = -1;
        int n = 0;
        in >> time >> n;
        ASSERT_EQ(time, wanted) << output;
        ASSERT_EQ(n, nParticles);
        for (int i = 0; i < n; ++i)
        {
            double v[8];
            for (double& x : v)
            {
                in >> x;
            }
            EXPECT_FLOAT_EQ(v[0], c.positions[i].x);
            EXPECT_FLOAT_EQ(v[1], c.positions[i].y);
            EXPECT_FLOAT_EQ(v[2], c.positions[i].z);
            for (int d = 0; d < 3; ++d)
            {
                EXPECT_FLOAT_EQ(v[3 + d], c.find("U")->values[3*i + d]);
            }
            EXPECT_EQ(v[6], 1000 + i);
            EXPECT_EQ(v[7], i);
        }
    }
}

TEST_F(openFOAM, weReadFieldsThatOpenFOAMWrites)
{
    std::string before;
    if (!environment(before))
    {
        GTEST_SKIP() << "OpenFOAM's programs are not installed";
    }
    put
    (
        "system/decomposeParDict",
        "FoamFile { version 2.0; format ascii; class dictionary; "
        "object decomposeParDict; }\nnumberOfSubdomains 1;\nmethod simple;\n"
        "simpleCoeffs { n (1 1 1); delta 0.001; }\n"
    );
    for (const char* format : {"ascii", "binary"})
    {
        writeCase();
        control
        (
            "deltaT 0.5; endTime 1; writeInterval 1; startFrom startTime; "
            "startTime 0; writePrecision 10; writeFormat "
          + std::string(format) + ";"
        );
        std::string output;
        ASSERT_EQ
        (
            shell(before + "decomposePar -force -case " + path.string(),
                output),
            0
        ) << output;
        // OpenFOAM leaves out the Cartesian positions
        std::filesystem::copy_file
        (
            path/"0/lagrangian/fluid/positions",
            path/"processor0/0/lagrangian/fluid/positions"
        );
        EXPECT_TRUE
        (
            says(text("processor0/0/lagrangian/fluid/U"), format)
        );
        const cloud theirs = readCloud(path/"processor0/0", "fluid");
        for (const cloudField& ours : makeCloud(false).fields)
        {
            const cloudField* field = theirs.find(ours.name);
            ASSERT_TRUE(field) << ours.name;
            EXPECT_EQ(field->cls, ours.cls);
            EXPECT_EQ(field->values, ours.values) << format << ours.name;
        }
        for (const char* folder : {"processor0", "0.5", "1"})
        {
            std::filesystem::remove_all(path/folder);
        }
    }
}

TEST_F(openFOAM, boxesMustHaveAnExtent)
{
    const auto error = [&](const vector& lo, const vector& hi)
    {
        return errorOf([&] { writeBoxMesh(path, lo, hi); });
    };
    EXPECT_TRUE(says(error({0, 0, 0}, {0, 0, 0}), "hi must be above lo"));
    EXPECT_TRUE(says(error({0, 2, 0}, {1, 1, 1}), "(0 2 0) to (1 1 1)"));
}

TEST_F(openFOAM, readerFilesOfTheUserStay)
{
    put("system/fvSchemes", "mine");
    writeReaderFiles(path);
    EXPECT_EQ(text("system/fvSchemes"), "mine");
    EXPECT_TRUE(exists("system/fvSolution"));
    EXPECT_TRUE(exists(path.filename().string() + ".foam"));
}
