#include "temporaryCase.H"

#include "case/cloud.H"

#include <zlib.h>

#include <cmath>
#include <cstring>

using namespace gpuFsi;

namespace
{

using cloudIO = temporaryCase;

//- Values that need all 17 digits, of every field class
cloud makeCloud(std::size_t n)
{
    cloud c;
    c.name = "fluid";
    std::vector<double> scalar, label, symmTensor;
    std::vector<vector> velocity;
    for (std::size_t i = 0; i < n; ++i)
    {
        const double s = std::sin(double(i) + 1);
        c.positions.push_back({s, 1/(i + 3.), -s*1e-7});
        scalar.push_back(1000*s);
        label.push_back(double(i)*7 - 5);
        velocity.push_back({s, s*s, 1e10*s});
        for (int k = 0; k < 6; ++k)
        {
            symmTensor.push_back(s + k/3.);
        }
    }
    c.addVector("U", velocity);
    c.addLabel("patch", label);
    c.addScalar("rho", scalar);
    c.fields.push_back({"symmTensorField", "sigma", symmTensor});
    return c;
}

void expectEqual(const cloud& a, const cloud& b)
{
    ASSERT_EQ(a.size(), b.size());
    EXPECT_EQ
    (
        std::memcmp
        (
            a.positions.data(),
            b.positions.data(),
            a.size()*sizeof(vector)
        ),
        0
    );
    ASSERT_EQ(a.fields.size(), b.fields.size());
    for (std::size_t f = 0; f < a.fields.size(); ++f)
    {
        EXPECT_EQ(a.fields[f].name, b.fields[f].name);
        EXPECT_EQ(a.fields[f].cls, b.fields[f].cls);
        EXPECT_EQ(a.fields[f].values, b.fields[f].values);
    }
}

} // namespace

TEST_F(cloudIO, comesBackAsItWent)
{
    for (std::size_t n : {0, 1, 2, 10, 11, 1000, 300000})
    {
        for (const writeOptions& options :
        {
            writeOptions{true, 6, false},
            writeOptions{false, 17, false},
            writeOptions{false, 17, true}
        })
        {
            if (n > 1000 && options.compress)
            {
                continue;    // slow, and only the buffer's size matters
            }
            std::filesystem::remove_all(path/"0.5");
            const cloud c = makeCloud(n);
            const std::size_t bytes = writeCloud(path/"0.5", c, options);
            expectEqual(readCloud(path/"0.5", "fluid"), c);
            EXPECT_EQ
            (
                exists("0.5/lagrangian/fluid/U.gz"),
                options.compress
            );
            std::size_t onDisk = 0;
            for (const auto& file :
                std::filesystem::recursive_directory_iterator(path/"0.5"))
            {
                onDisk += file.is_regular_file() ? file.file_size() : 0;
            }
            EXPECT_EQ(bytes, onDisk);
        }
    }
    EXPECT_EQ(cloudNames(path/"0.5"), std::vector<std::string>{"fluid"});
    EXPECT_TRUE(cloudNames(path/"0.7").empty());
}

TEST_F(cloudIO, asciiLooksAsOpenFOAMsOwn)
{
    cloud c;
    c.name = "solid";
    c.positions = {{0.1, 1./3, -1e-7}, {1e10, 123456.7, 0}};
    c.addScalar("rho", {1000, 1000});
    c.addVector("U", {{1, 2, 3}, {0, 0, 0.5}});
    writeCloud(path/"0.25", c, {false, 6, false});
    EXPECT_EQ
    (
        text("0.25/lagrangian/solid/positions"),
        "FoamFile\n{\n"
        "    version     2.0;\n"
        "    format      ascii;\n"
        "    arch        \"LSB;label=32;scalar=64\";\n"
        "    class       Cloud<passiveParticle>;\n"
        "    location    \"0.25/lagrangian/solid\";\n"
        "    object      positions;\n"
        "}\n\n"
        "2\n(\n(0.1 0.333333 -1e-07) 0\n(1e+10 123457 0) 0\n)\n"
    );
    const std::string rho = text("0.25/lagrangian/solid/rho");
    EXPECT_EQ(rho.substr(rho.find("}\n\n") + 3), "2{1000}\n");
    const std::string U = text("0.25/lagrangian/solid/U");
    EXPECT_EQ(U.substr(U.find("}\n\n") + 3), "2((1 2 3) (0 0 0.5))\n");
}

TEST_F(cloudIO, binaryHasTheBytesOpenFOAMWrites)
{
    cloud c;
    c.name = "fluid";
    c.positions = {{1, 2, 3}};
    c.addLabel("id", {258});
    writeCloud(path/"1", c, {true, 6, false});
    std::string record = "1\n(\n(";
    for (double x : {1., 2., 3.})
    {
        record.append(reinterpret_cast<const char*>(&x), 8);
    }
    record += std::string(4, '\0') + ")\n)\n";
    const std::string positions = text("1/lagrangian/fluid/positions");
    EXPECT_EQ(positions.substr(positions.find("}\n\n") + 3), record);
    const std::string id = text("1/lagrangian/fluid/id");
    EXPECT_EQ
    (
        id.substr(id.find("}\n\n") + 3),
        "1\n(" + std::string("\x02\x01\0\0", 4) + ")\n"
    );
}

TEST_F(cloudIO, readsEveryFormOfList)
{
    const auto field = [](const std::string& cls, const std::string& body)
    {
        return "// a comment\nFoamFile { version 2; format ascii; class "
            + cls + "; object f; meta { a 1; } note \"a ; b\"; }\n/* more */\n"
            + body + "\n// *** //\n";
    };
    const std::string place = "0/lagrangian/fluid/";
    put(place + "positions", field
    (
        "Cloud<passiveParticle>",
        "2 ( (0 0 0) 0 (1 +1 1) -1 )"
    ));
    put(place + "a", field("scalarField", "2{3.5}"));
    put(place + "b", field("vectorField", "uniform (1 2 3);"));
    put(place + "c", field("scalarField", "nonuniform List<scalar> 2(1 2);"));
    put(place + "d", field("scalarField", "(1e-400 // tiny\n 2)"));
    put(place + "e", field("labelField", "2 ( -3 4 )"));
    const cloud c = readCloud(path/"0", "fluid");
    using list = std::vector<double>;
    EXPECT_EQ(c.find("a")->values, (list{3.5, 3.5}));
    EXPECT_EQ(c.find("b")->values, (list{1, 2, 3, 1, 2, 3}));
    EXPECT_EQ(c.find("c")->values, (list{1, 2}));
    EXPECT_EQ(c.find("d")->values, (list{0, 2}));
    EXPECT_EQ(c.find("e")->values, (list{-3, 4}));
    EXPECT_EQ(c.find("f"), nullptr);
}

TEST_F(cloudIO, aFullDiskIsSaid)
{
    if (!std::filesystem::exists("/dev/full"))
    {
        GTEST_SKIP() << "there is no /dev/full";
    }
    for (const writeOptions& options :
    {
        writeOptions{true, 6, false},
        writeOptions{false, 6, false},
        writeOptions{false, 6, true}
    })
    {
        for (std::size_t n : {10, 300000})
        {
            std::filesystem::remove_all(path/"0");
            std::filesystem::create_directories(path/"0/lagrangian/fluid");
            std::filesystem::create_symlink
            (
                "/dev/full",
                path/"0/lagrangian/fluid"
               /(options.compress ? "positions.gz" : "positions")
            );
            const std::string error = errorOf([&]
            {
                writeCloud(path/"0", makeCloud(n), options);
            });
            EXPECT_TRUE(says(error, "the disk is full"));
            EXPECT_TRUE(says(error, "fluid/positions"));
        }
    }
}
