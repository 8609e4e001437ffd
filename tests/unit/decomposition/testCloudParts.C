// A cloud taken apart and put together is the same, file by file to the byte.
#include "decomposition/cloudForm.H"
#include "decomposition/cloudParts.H"
#include "grids.H"
#include "unit/case/temporaryCase.H"

#include <gtest/gtest.h>

#include <cmath>

using namespace gpuFsi;
namespace fs = std::filesystem;

namespace
{

//- Values with signs, zeros, all sizes; n particles
cloud sample(std::size_t n)
{
    cloud c;
    c.name = "fluid";
    std::vector<vector> U;
    std::vector<double> rho, same, label;
    cloudField stress{"symmTensorField", "stress", {}};
    for (std::size_t i = 0; i < n; ++i)
    {
        const auto value = [&](int k)
        {
            return hashed(10*i + k)*std::pow(10, int(i % 30) - 15);
        };
        c.positions.push_back({value(0), value(1), -0.0});
        U.push_back({value(2), i % 3 ? value(3) : 0, 1e-300});
        rho.push_back(1000 + value(4));
        same.push_back(0.1);
        label.push_back(double(i*7919 % 2147483647));
        for (int k = 0; k < 6; ++k)
        {
            stress.values.push_back(value(5 + k));
        }
    }
    c.addVector("U", U);
    c.addScalar("rho", rho);
    c.addScalar("same", same);
    c.addLabel("node", label);
    c.fields.push_back(stress);
    return c;
}

class cloudRoundTrip
:
    public temporaryCase
{
protected:

    static std::vector<std::vector<std::size_t>> share(std::size_t n, int ranks)
    {
        std::vector<std::vector<std::size_t>> ids(ranks);
        for (std::size_t i = 0; i < n; ++i)
        {
            // The last rank stays empty
            ids[int(0.5*(1 + hashed(i))*(ranks - 1))].push_back(i);
        }
        return ids;
    }

    void write(const cloud& c, int ranks) const
    {
        const cloudForm form = cloudForm::of(path/"1", c.name);
        const auto ids = share(c.size(), ranks);
        for (int r = 0; r < ranks; ++r)
        {
            form.write(path/"parts"/std::to_string(r)/"1", partOf(c, ids[r]));
        }
    }

    void join(int ranks) const
    {
        std::vector<cloud> parts;
        std::vector<fs::path> where;
        cloudForm form;
        for (int r = 0; r < ranks; ++r)
        {
            const fs::path folder = path/"parts"/std::to_string(r)/"1";
            parts.push_back(readCloud(folder, "fluid"));
            where.push_back(folder/"lagrangian/fluid");
            form.widen(cloudForm::of(folder, "fluid"));
        }
        form.write(path/"joined"/"1", joinParts(std::move(parts), where));
    }

    void expectSame() const
    {
        int files = 0;
        for (const auto& e : fs::recursive_directory_iterator(path/"1"))
        {
            if (e.is_regular_file())
            {
                const fs::path name = fs::relative(e.path(), path);
                EXPECT_EQ(text(name), text(path/"joined"/name)) << name;
                ++files;
            }
        }
        EXPECT_EQ(files, 7);
    }
};

} // namespace


TEST_F(cloudRoundTrip, toTheByte)
{
    for (const writeOptions& options : std::vector<writeOptions>
        {
            {true, 6, false}, {false, 6, false}, {false, 6, true},
            {false, 1, false}, {false, 16, false}, {false, 17, false}
        })
    {
        for (std::size_t n : {0, 1, 40})
        {
            for (int ranks : {1, 4})
            {
                fs::remove_all(path/"1");
                fs::remove_all(path/"joined");
                fs::remove_all(path/"parts");
                writeCloud(path/"1", sample(n), options);
                const cloud whole = readCloud(path/"1", "fluid");
                SCOPED_TRACE(testing::Message() << options.binary << ' '
                    << options.precision << ' ' << n << ' ' << ranks);
                write(whole, ranks);
                join(ranks);
                expectSame();
            }
        }
    }
}


TEST_F(cloudRoundTrip, partsAscendAndKeepTheirIds)
{
    const cloud c = sample(100);
    const cloud part = partOf(c, {3, 50, 99});
    ASSERT_EQ(part.size(), 3u);
    EXPECT_EQ(part.positions[1].x, c.positions[50].x);
    EXPECT_EQ(part.find("origId")->values, (std::vector<double>{3, 50, 99}));
    EXPECT_EQ(part.find("stress")->values[17], c.find("stress")->values[599]);
    EXPECT_TRUE(says(errorOf([&] { partOf(part, {0}); }), "Rename it"));
}


TEST_F(cloudRoundTrip, refusesWhatDoesNotFit)
{
    const cloud c = sample(10);
    const auto refuses = [&]
    (
        std::vector<cloud> parts,
        std::optional<std::size_t> size,
        const char* message
    )
    {
        const std::vector<fs::path> where(parts.size(), "processor0/1");
        EXPECT_TRUE(says
        (
            errorOf([&] { joinParts(std::move(parts), where, size); }), message
        ));
    };
    const cloud low = partOf(c, {0, 1, 2, 3, 4}), high = partOf(c, {6, 8, 9});
    refuses({low, high}, {}, "2 missing (the first is 5)");
    refuses({low, low}, {}, "5 more than once (the first is 0)");
    refuses({low, high, high}, {},
        "2 missing (the first is 5) and 3 more than once (the first is 6)");
    refuses({low}, 10, "5 missing (the first is 5)");
    refuses({low, high}, 9, "9 is not the id of a particle of 9");
    refuses({low, c}, {}, "There is no labelField origId");

    cloud other = partOf(c, {5, 6, 7, 8, 9});
    other.fields.erase(other.fields.begin());
    refuses({low, other}, {}, "There is no vectorField U in processor0/1");
    cloud negative = partOf(c, {5, 6, 7, 8, 9});
    negative.fields.back().values[0] = -1;
    refuses({low, negative}, {}, "-1 is not the id of a particle");
}
