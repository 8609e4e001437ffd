#include "temporaryCase.H"

#include "case/cloud.H"

#include <cstring>
#include <limits>

using namespace gpuFsi;

namespace
{

class cloudErrors
:
    public temporaryCase
{
public:

    const std::string place = "0/lagrangian/fluid/";

    cloudErrors()
    {
        putField("positions", "Cloud<passiveParticle>",
            "2\n(\n(0 0 0) 0\n(1 1 1) 0\n)\n");
    }

    static std::string header
    (
        const std::string& cls,
        const std::string& format = "ascii",
        const std::string& arch = "LSB;label=32;scalar=64"
    )
    {
        return "FoamFile\n{\n    format " + format + ";\n    arch \"" + arch
            + "\";\n    class " + cls + ";\n    object x;\n}\n";
    }

    void putField
    (
        const std::string& name,
        const std::string& cls,
        const std::string& body
    ) const
    {
        put(place + name, header(cls) + body);
    }

    std::string readError() const
    {
        return errorOf([&] { readCloud(path/"0", "fluid"); });
    }

    std::string fieldError
    (
        const std::string& cls,
        const std::string& body
    ) const
    {
        putField("f", cls, body);
        return readError();
    }
};

} // namespace

TEST_F(cloudErrors, soundFilesHaveNone)
{
    EXPECT_EQ(fieldError("scalarField", "2(1 2)"), "");
}

TEST_F(cloudErrors, nameTheLineAndTheParticle)
{
    const std::string nan = fieldError("scalarField", "2\n(\n1\nnan\n)\n");
    EXPECT_TRUE(says(nan, "f of particle 1 is nan"));
    EXPECT_TRUE(says(nan, "fluid/f at line 11."));
    EXPECT_TRUE(says(fieldError("scalarField", "2(1 1e400)"), "is inf"));
    const std::string word = fieldError("vectorField", "2((1 2 3)\n(4 x 6))");
    EXPECT_TRUE(says(word, "Expected a number for f of particle 1"));
    EXPECT_TRUE(says(word, "found 'x'") || says(word, "found 'x"));
    EXPECT_TRUE(says(word, "at line 9."));
    EXPECT_TRUE
    (
        says(fieldError("labelField", "2(1 2.5)"), "not a 32-bit label")
    );
}

TEST_F(cloudErrors, sizesMustAgree)
{
    EXPECT_TRUE
    (
        says(fieldError("scalarField", "3(1 2 3)"), "f has 3 values, but")
    );
    EXPECT_TRUE(says(fieldError("scalarField", "3{1}"), "f has 3 values"));
    EXPECT_TRUE(says(fieldError("scalarField", "(1)"), "f has 1 values"));
    EXPECT_TRUE(says(fieldError("scalarField", "-2(1)"), "whole number"));
    EXPECT_TRUE(says(fieldError("scalarField", "2(1 2 3)"), "more than said"));
    EXPECT_TRUE(says(fieldError("scalarField", "2(1"), "truncated"));
    EXPECT_TRUE(says(fieldError("scalarField", "2(1 2) 5"), "more after"));
    putField("positions", "Cloud<passiveParticle>", "1000000000000((0 0 0)");
    EXPECT_TRUE(says(readError(), "too short for 1000000000000"));
}

TEST_F(cloudErrors, headersMustFit)
{
    EXPECT_TRUE
    (
        says(fieldError("volScalarField", "2(1 2)"), "Valid cloud field")
    );
    put(place + "f", "2(1 2)");
    EXPECT_TRUE(says(readError(), "no FoamFile header"));
    put(place + "f", "FoamFile { format ascii; class scalarField; }");
    EXPECT_TRUE(says(readError(), "'object' not found"));
    put(place + "f", "FoamFile { format ascii; class scalar");
    EXPECT_TRUE(says(readError(), "end of the file"));
    put(place + "f", header("scalarField", "asci"));
    EXPECT_TRUE(says(readError(), "did you mean ascii?"));
    std::filesystem::remove(path/place/"f");
    putField("positions", "vectorField", "2((0 0 0) 0 (1 1 1) 0)");
    EXPECT_TRUE(says(readError(), "vectorField is not a cloud"));
    std::filesystem::remove(path/place/"positions");
    EXPECT_TRUE(says(readError(), "no file"));
    EXPECT_TRUE(says(errorOf([&] { readCloud(path/"0", "f"); }), "no cloud f"));
}

TEST_F(cloudErrors, binaryWidthsAndTruncation)
{
    for (const char* arch :
        {"LSB;label=64;scalar=64", "LSB;label=32;scalar=32",
         "MSB;label=32;scalar=64"})
    {
        put
        (
            place + "f",
            header("scalarField", "binary", arch) + "2\n(" + std::string(16, 0)
          + ")"
        );
        EXPECT_TRUE(says(readError(), arch));
    }
    const std::string good = header("scalarField", "binary");
    put(place + "f", good + "2\n(" + std::string(16, 0) + ")");
    EXPECT_EQ(readError(), "");
    put(place + "f", good + "2\n(" + std::string(11, 0));
    EXPECT_TRUE(says(readError(), "16 bytes are missing, 11 are left"));
    put(place + "f", good + "2\n(" + std::string(24, 0) + ")");
    EXPECT_TRUE(says(readError(), "width of the numbers is wrong"));
    put(place + "f", good + "2\n(" + std::string(16, 0) + ")\n7");
    EXPECT_TRUE(says(readError(), "more after the list (1 bytes)"));

    const double nan = std::numeric_limits<double>::quiet_NaN();
    std::string bytes(16, 0);
    std::memcpy(&bytes[8], &nan, 8);
    put(place + "f", good + "2\n(" + bytes + ")");
    EXPECT_TRUE(says(readError(), "f of particle 1 is nan"));
}

TEST_F(cloudErrors, damagedGzip)
{
    cloud c;
    c.name = "fluid";
    c.positions = {{0, 0, 0}, {1, 2, 3}};
    writeCloud(path/"0", c, {false, 6, true});
    EXPECT_TRUE(says(readError(), "its .gz exist"));
    std::filesystem::remove(path/place/"positions");
    EXPECT_EQ(readError(), "");
    std::filesystem::resize_file(path/place/"positions.gz", 60);
    EXPECT_TRUE(says(readError(), "damaged"));
}

TEST_F(cloudErrors, labelsMustFitOnWriting)
{
    cloud c;
    c.name = "fluid";
    c.positions = {{0, 0, 0}};
    c.addLabel("id", {3e9});
    EXPECT_TRUE
    (
        says
        (
            errorOf([&] { writeCloud(path/"1", c, {}); }),
            "not a 32-bit label"
        )
    );
}
