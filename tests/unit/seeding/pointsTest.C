#include "fixture.H"

#include "seeding/nearestPoints.H"

#include <algorithm>
#include <fstream>
#include <random>
#include <unistd.h>

using namespace gpuFsi;

namespace
{

const double pi = std::acos(-1.0);

std::filesystem::path write(const std::string& name, const std::string& text)
{
    const auto folder = std::filesystem::temp_directory_path()
        /("seedingPoints" + std::to_string(getpid()));
    std::filesystem::create_directories(folder);
    std::ofstream(folder/name) << text;
    return folder;
}

} // namespace

TEST(nearestPoints, agreesWithBruteForce)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<double> uniform(0, 1);
    const auto place = [&]
    {
        return vector{uniform(random), uniform(random), uniform(random)};
    };
    std::vector<vector> points(500);
    std::generate(points.begin(), points.end(), place);
    const nearestPoints nearest(points);
    nearestPoints::found found, all;
    for (int trial = 0; trial < 200; ++trial)
    {
        const vector p = 2.0*place();
        all.clear();
        for (std::size_t i = 0; i < points.size(); ++i)
        {
            const vector d = points[i] - p;
            all.emplace_back(dot(d, d), i);
        }
        std::sort(all.begin(), all.end());
        all.resize(8);
        nearest.find(p, 8, found);
        ASSERT_EQ(found.size(), all.size());
        for (std::size_t i = 0; i < all.size(); ++i)
        {
            EXPECT_EQ(found[i].second, all[i].second);
            EXPECT_DOUBLE_EQ(found[i].first, all[i].first);
        }
    }
}


TEST(points, sphereOfPoints)
{
    const double h = 0.1;
    const int n = 1100;    // about one a h^2
    std::string text = "# golden spiral\n";
    for (int i = 0; i < n; ++i)
    {
        const double z = 1 - (2*i + 1.0)/n;
        const double a = i*pi*(3 - std::sqrt(5.0));
        const double x = std::sqrt(1 - z*z)*std::cos(a);
        const double y = std::sqrt(1 - z*z)*std::sin(a);
        char line[200];
        std::snprintf(line, sizeof line, "%.15g %.15g %.15g %.15g %.15g"
            " %.15g\n", 0.9*x, 0.9*y, 0.9*z, -x, -y, -z);
        text += line;
    }
    const auto folder = write("sphere.txt", text);
    const lattice l(3, h, {-1, -1, -1}, {1, 1, 1}, {});
    const auto s = seedFluid(l, makeRegions(
        "w { type points; file \"sphere.txt\"; }", 3, h, folder));
    const auto exact = seedFluid(l, makeRegions(
        "w { type sphere; centre (0 0 0); radius 0.9; }", 3, h));
    EXPECT_EQ(s.nCandidates[0], std::size_t(n));
    EXPECT_TRUE(s.uncovered.empty());
    EXPECT_NEAR(double(s.bulk.size()), double(exact.bulk.size()),
        0.03*exact.bulk.size());
    EXPECT_NEAR(totalArea(s), 4*pi*0.81, 0.02*4*pi*0.81);
    EXPECT_NEAR(s.volume, exact.volume, 0.01*exact.volume);
}


TEST(points, badLinesAreNamed)
{
    const auto lineOf = [](const std::string& text)
    {
        const auto folder = write("bad.txt", text);
        try
        {
            makeRegions("w { type points; file \"bad.txt\"; }", 3, 0.1, folder);
        }
        catch (const userError& e)
        {
            return e.where().first;
        }
        return -1;
    };
    EXPECT_EQ(lineOf("0 0 0 1 0 0\n\n1 2 3\n"), 3);
    EXPECT_EQ(lineOf("0 0 0 1 0 x\n"), 1);
    EXPECT_EQ(lineOf("# none\n0 0 0 0 0 0\n"), 2);
    EXPECT_EQ(lineOf("0 0 0 1 0 0 1\n0 0 0 1 0 0\n"), 2);
    EXPECT_EQ(lineOf("0 0 0 1 0 0 -1\n"), 1);
    EXPECT_EQ(lineOf("nan 0 0 1 0 0\n"), 1);
    EXPECT_EQ(lineOf("# nothing\n"), 0);
    EXPECT_EQ(lineOf("0 0 0 1 0 0 # fine\n"), -1);
}
