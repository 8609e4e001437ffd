#include "temporaryCase.H"

#include "base/largeBlocks.H"
#include "case/cloudView.H"
#include "case/largeFields.H"
#include "case/parallelFiles.H"

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <limits>

using namespace gpuFsi;

namespace
{

//- Some pieces of a list, and not a whole number of them
constexpr std::size_t n = 50007;

class largeFiles
:
    public temporaryCase
{
public:

    cloud written;
    const std::filesystem::path folder = path/"0/lagrangian/fluid";

    largeFiles()
    {
        written.name = "fluid";
        std::vector<vector> U;
        std::vector<double> rho, label;
        for (std::size_t i = 0; i < n; ++i)
        {
            const double a = std::sin(double(i));
            written.positions.push_back({a, 2*a, 1/(a + 3)});
            U.push_back({-a, a*a, double(i)});
            rho.push_back(1 + 1e-9*a);
            label.push_back(double(i % 7) - 3);
        }
        written.addVector("U", U);
        written.addLabel("label", label);
        written.addScalar("rho", rho);
        writeCloud(path/"0", written, {});
    }

    //- Overwrite bytes of a file; negative: counted from its end
    void spoil(const char* file, long at, const std::string& bytes) const
    {
        std::fstream f(folder/file, std::ios::in | std::ios::out
            | std::ios::binary);
        f.seekp(at, at < 0 ? std::ios::end : std::ios::beg);
        f << bytes;
    }

    std::string readError() const
    {
        return errorOf([&] { readCloud(path/"0", "fluid"); });
    }

    static std::string bytesOf(double value)
    {
        std::string bytes(sizeof(value), '\0');
        std::memcpy(bytes.data(), &value, sizeof(value));
        return bytes;
    }
};

} // namespace

TEST_F(largeFiles, areReadInPieces)
{
    EXPECT_EQ(largePositions(folder/"positions")->size(), n);
    EXPECT_EQ(largeField(folder/"U")->values, written.find("U")->values);
    EXPECT_EQ(largeField(folder/"label")->cls, "labelField");
    EXPECT_FALSE(largeField(folder/"positions"));
    EXPECT_FALSE(largePositions(folder/"U"));
    EXPECT_FALSE(largeField(folder/"none"));
}

TEST_F(largeFiles, comeBackAsTheyWere)
{
    const cloud c = readCloud(path/"0", "fluid");
    ASSERT_EQ(c.size(), n);
    EXPECT_EQ
    (
        std::memcmp
        (
            c.positions.data(), written.positions.data(), n*sizeof(vector)
        ),
        0
    );
    for (const cloudField& f : written.fields)
    {
        EXPECT_EQ(c.find(f.name)->values, f.values) << f.name;
        EXPECT_EQ(c.find(f.name)->cls, f.cls);
    }
}

TEST_F(largeFiles, damageIsNamedAsInSmallOnes)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    spoil("rho", -2 - 8*10, bytesOf(nan));    // before ")\n"
    EXPECT_TRUE(says(readError(), "rho of particle 49997 is nan"))
        << readError();
    spoil("rho", -2 - 8*10, bytesOf(1));
    EXPECT_EQ(readError(), "");

    // An infinite number 40 positions before the end, of 31 bytes each
    spoil("positions", -2 - 31*40 + 1, bytesOf(1/0.0));
    EXPECT_TRUE(says(readError(), "position of particle 49967"))
        << readError();
    spoil("positions", -2 - 31*40 + 1, bytesOf(1));
    spoil("positions", -2 - 31*40 + 29, "x");
    EXPECT_TRUE(says(readError(), "Expected ')' after"))
        << readError();
    spoil("positions", -2 - 31*40 + 29, ")");
    EXPECT_EQ(readError(), "");

    spoil("U", -2, "]\n");
    EXPECT_TRUE(says(readError(), "after the values")) << readError();
    spoil("U", -2, ")x");
    EXPECT_TRUE(says(readError(), "more after the list")) << readError();
    std::filesystem::resize_file
    (
        folder/"U", std::filesystem::file_size(folder/"U") - 100
    );
    EXPECT_TRUE(says(readError(), "truncated")) << readError();
}

TEST_F(largeFiles, sizesMustAgree)
{
    cloud other = written;
    other.positions.resize(n - 1);
    other.fields.clear();
    writeCloud(path/"1", other, {});
    std::filesystem::copy_file
    (
        folder/"rho", path/"1/lagrangian/fluid/rho"
    );
    EXPECT_TRUE
    (
        says
        (
            errorOf([&] { readCloud(path/"1", "fluid"); }),
            "rho has 50007 values, but positions holds 50006"
        )
    );
}

TEST(parallelFiles, throwWhatTheFirstThrew)
{
    std::vector<int> done(20, 0);
    const auto some = [&](int k)
    {
        done[k] = 1;
        if (k == 7 || k == 13)
        {
            throw std::runtime_error(std::to_string(k));
        }
    };
    try
    {
        forEachFile(20, some);
        FAIL();
    }
    catch (const std::runtime_error& e)
    {
        EXPECT_STREQ(e.what(), "7");
    }
    EXPECT_EQ(done, std::vector<int>(20, 1));
}

TEST(largeBlocks, beginAtLines)
{
    for (const std::size_t size : {1u, 4096u, 9000000u})
    {
        void* const p = allocateBlock(size);
        ASSERT_NE(p, nullptr);
        std::memset(p, 1, size);
        const std::uintptr_t place = reinterpret_cast<std::uintptr_t>(p);
        EXPECT_EQ(place % (size > 8000000 ? 2u << 20 : 64u), 0u);
        std::free(p);
    }
    EXPECT_EQ(allocateBlock(std::size_t(-1)), nullptr);
    EXPECT_THROW
    (
        std::vector<char>(std::size_t(1) << 60), std::bad_alloc
    );
    const std::vector<double> large(2000000, 1.5);
    EXPECT_EQ(large.back(), 1.5);
}


TEST_F(largeFiles, vectorsAndNothingElseWhereAsked)
{
    const cloud c = readCloud(path/"0", "fluid", {{"rho"}, {"U", "label"}});
    EXPECT_EQ(c.find("rho"), nullptr);
    EXPECT_EQ(c.find("U"), nullptr);
    ASSERT_EQ(c.vectors.at("U").size(), n);
    EXPECT_EQ
    (
        std::memcmp
        (
            c.vectors.at("U").data(), written.find("U")->values.data(),
            n*sizeof(vector)
        ),
        0
    );
    EXPECT_EQ(c.find("label")->values, written.find("label")->values);
}
