#include "base/error.H"
#include "vtk/colourMap.H"
#include "vtk/picture.H"
#include "vtk/raster.H"

#include <gtest/gtest.h>

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

using namespace gpuFsi;

namespace
{

constexpr int n = 20;

//- Lattice filling the unit cube; T is x + y + z over its largest value
cloud cube()
{
    cloud c;
    c.name = "fluid";
    std::vector<double> values;
    for (int i = 0; i < n*n*n; ++i)
    {
        const vector p
        {
            (i % n + 0.5)/n, (i/n % n + 0.5)/n, (i/(n*n) + 0.5)/n
        };
        c.positions.push_back(p);
        values.push_back(p.x + p.y + p.z);
    }
    c.addScalar("T", values);
    return c;
}


domain unitCube()
{
    domain d;
    d.spacing = 1.0/n;
    d.hi = {1, 1, 1};
    return d;
}


pictureOptions small()
{
    pictureOptions options;
    options.width = 400;
    options.height = 360;
    return options;
}


std::size_t inked(const image& picture)
{
    std::size_t count = 0;
    for (int y = 0; y < picture.height(); ++y)
    {
        for (int x = 0; x < picture.width(); ++x)
        {
            count += !(picture.at(x, y) == rgb{255, 255, 255});
        }
    }
    return count;
}


//- Pixels of exactly this colour left of the colour bar: count, mean place
struct found
{
    std::size_t count = 0;
    double x = 0, y = 0;
};

found find(const image& picture, rgb colour)
{
    const int bar = std::min(picture.width(), 320);    // of small()
    found all;
    for (int y = 0; y < picture.height(); ++y)
    {
        for (int x = 0; x < bar; ++x)
        {
            if (picture.at(x, y) == colour)
            {
                ++all.count;
                all.x += x + 0.5;
                all.y += y + 0.5;
            }
        }
    }
    all.x /= std::max<std::size_t>(1, all.count);
    all.y /= std::max<std::size_t>(1, all.count);
    return all;
}

} // namespace


TEST(picture, centreOfACutHasTheColourOfItsParticle)
{
    // One particle differs; its square has area (scale h)^2 and only it
    cloud c = cube();
    const int chosen = (n/2*n + 13)*n + 4;    // i 4, j 13, k n/2
    std::fill(c.fields[0].values.begin(), c.fields[0].values.end(), 0.0);
    c.fields[0].values[chosen] = 1;
    pictureOptions options = small();
    options.range = {-1, 3};
    options.cut = cutPlane{2, c.positions[chosen].z};
    const image picture = paint({c}, unitCube(), 0, options);

    // A quarter and a half of the colour bar's range
    const colourMap map("viridis");
    const found rest = find(picture, map(0.25)), one = find(picture, map(0.5));
    const double side = std::sqrt(static_cast<double>(rest.count))/n;
    EXPECT_GT(side, 8);
    EXPECT_NEAR(std::sqrt(static_cast<double>(one.count)), side, 3);

    // rest is the whole square but for one cell: its middle is the plot's
    EXPECT_NEAR(one.x - rest.x, (4.5/n - 0.5)*n*side, 1);
    EXPECT_NEAR(rest.y - one.y, (13.5/n - 0.5)*n*side, 1);
}


TEST(picture, cutPicksTheLayer)
{
    // Layers alternate between 0 and 1 along x
    cloud c = cube();
    for (std::size_t i = 0; i < c.size(); ++i)
    {
        c.fields[0].values[i] = i % 2;
    }
    const colourMap map("grey");
    pictureOptions options = small();
    options.colours = "grey";
    options.range = {-1, 3};
    for (const int layer : {0, 7, 12})
    {
        options.cut = cutPlane{0, (layer + 0.5)/n};
        const image picture = paint({c}, unitCube(), 0, options);
        const rgb expected = map(layer % 2 ? 0.5 : 0.25);
        const rgb other = map(layer % 2 ? 0.25 : 0.5);
        EXPECT_GT(find(picture, expected).count, 20000u);
        EXPECT_LT(find(picture, other).count, 200u);
    }
}


TEST(picture, disorderedCloudLeavesNoPinholes)
{
    cloud c = cube();
    unsigned state = 1;
    const auto jitter = [&state]()
    {
        state = state*1664525u + 1013904223u;
        return (state/4294967296.0 - 0.5)*0.5/n;
    };
    for (vector& p : c.positions)
    {
        p += {jitter(), jitter(), jitter()};
    }
    std::fill(c.fields[0].values.begin(), c.fields[0].values.end(), 1.0);
    pictureOptions options = small();
    const image picture = paint({c}, unitCube(), 0, options);
    const rgb only = colourMap("viridis")(0.5);
    const found area = find(picture, only);
    const int half = static_cast<int>
    (
        0.35*std::sqrt(static_cast<double>(area.count))
    );
    const int cx = static_cast<int>(area.x), cy = static_cast<int>(area.y);
    for (int y = cy - half; y < cy + half; ++y)
    {
        for (int x = cx - half; x < cx + half; ++x)
        {
            ASSERT_EQ(picture.at(x, y), only) << x << ' ' << y;
        }
    }
}


TEST(picture, spaceViewHidesWhatLiesBehind)
{
    // Seen from +x: the layer at the largest x covers all others
    cloud c = cube();
    for (std::size_t i = 0; i < c.size(); ++i)
    {
        c.fields[0].values[i] = c.positions[i].x > 1 - 1.0/n ? 1 : 0;
    }
    pictureOptions options = small();
    options.view3d = true;
    options.azimuth = 0;
    options.elevation = 0;
    options.colours = "coolToWarm";
    const auto balance = [&](double azimuth)
    {
        options.azimuth = azimuth;
        const image picture = paint({c}, unitCube(), 0, options);
        long red = 0, blue = 0;
        for (int y = 100; y < 260; ++y)
        {
            for (int x = 100; x < 240; ++x)
            {
                const rgb p = picture.at(x, y);
                red += p.r > p.b + 40;
                blue += p.b > p.r + 40;
            }
        }
        return red - blue;
    };
    EXPECT_GT(balance(0), 15000);
    EXPECT_LT(balance(180), -15000);
}


TEST(picture, clipRemovesParticles)
{
    pictureOptions options = small();
    options.cut = cutPlane{2, 0.475};
    options.range = {0, 1};
    cloud c = cube();
    std::fill(c.fields[0].values.begin(), c.fields[0].values.end(), 0.5);
    const rgb only = colourMap("viridis")(0.5);
    const auto all = find(paint({c}, unitCube(), 0, options), only).count;
    options.keep = [](const vector& p) { return p.x < 0.5; };
    const auto half = find(paint({c}, unitCube(), 0, options), only).count;
    EXPECT_NEAR(static_cast<double>(half)/all, 0.5, 0.03);
}


TEST(picture, cloudWithoutTheFieldIsGrey)
{
    cloud fluid = cube(), solid;
    solid.name = "solid";
    for (std::size_t i = 0; i < fluid.size(); ++i)
    {
        if (fluid.positions[i].x < 0.5)
        {
            solid.positions.push_back(fluid.positions[i]);
        }
    }
    const image picture = paint({solid, fluid}, unitCube(), 0, small());
    EXPECT_GT(find(picture, {176, 176, 176}).count, 5000u);
}


TEST(picture, noneAndOneParticle)
{
    cloud none = cube();
    none.positions.clear();
    none.fields[0].values.clear();
    cloud one = none;
    one.positions = {{0.5, 0.5, 0.5}};
    one.fields[0].values = {0};
    for (const bool space : {false, true})
    {
        pictureOptions options = small();
        options.view3d = space;
        const std::size_t axes =
            inked(paint({none}, unitCube(), 0, options));
        EXPECT_GT(axes, 1000u);
        EXPECT_GT(inked(paint({one}, unitCube(), 0, options)), axes + 20);
    }
}


TEST(picture, particleFarAwayDoesNoHarm)
{
    cloud c = cube();
    c.positions[0] = {1e300, -1e300, 0.5};
    pictureOptions options = small();
    EXPECT_GT(inked(paint({c}, unitCube(), 0, options)), 20000u);
    options.view3d = true;
    EXPECT_GT(inked(paint({c}, unitCube(), 0, options)), 20000u);
}


TEST(picture, twoDimensionalCaseIsShownWhole)
{
    domain d = unitCube();
    d.dimensions = 2;
    d.lo.z = d.hi.z = 0;
    cloud c = cube();
    c.positions.resize(n*n);
    c.fields[0].values.assign(n*n, 2.0);
    EXPECT_GT
    (
        find(paint({c}, d, 0, small()), colourMap("viridis")(0.5)).count,
        20000u
    );
    pictureOptions options = small();
    options.cut = cutPlane{0, 0.5};
    EXPECT_THROW(paint({c}, d, 0, options), userError);
    options = small();
    options.view3d = true;
    EXPECT_THROW(paint({c}, d, 0, options), userError);
}


TEST(picture, sizeIsAsAskedOrFitsTheScene)
{
    EXPECT_EQ(paint({cube()}, unitCube(), 0, small()).height(), 360);
    domain channel = unitCube();
    channel.hi = {5, 1, 1};
    pictureOptions options;
    const image picture = paint({cube()}, channel, 0, options);
    EXPECT_EQ(picture.width(), 1200);
    EXPECT_LT(picture.height(), 600);
    channel.hi.x = 0;
    EXPECT_THROW(paint({cube()}, channel, 0, options), userError);
}


TEST(image, pngReadsBackPixelByPixel)
{
    image picture(7, 5);
    picture.at(0, 0) = {1, 2, 3};
    picture.at(6, 4) = {200, 100, 50};
    const auto file = std::filesystem::temp_directory_path()
        /("image-" + std::to_string(getpid()) + ".png");
    picture.writePng(file);
    vtkNew<vtkPNGReader> reader;
    reader->SetFileName(file.c_str());
    reader->Update();
    std::filesystem::remove(file);
    vtkImageData* data = reader->GetOutput();
    ASSERT_EQ(data->GetDimensions()[0], 7);
    ASSERT_EQ(data->GetDimensions()[1], 5);
    EXPECT_EQ(data->GetScalarComponentAsDouble(0, 4, 0, 1), 2);
    EXPECT_EQ(data->GetScalarComponentAsDouble(6, 0, 0, 0), 200);
    EXPECT_EQ(data->GetScalarComponentAsDouble(3, 3, 0, 2), 255);
}


TEST(image, textStandsWhereItIsAnchored)
{
    for (const int across : {-1, 0, 1})
    {
        image picture(200, 60);
        picture.text(100, 30, "HHH", 20, {0, 0, 0}, {across, 0});
        int left = 200, right = 0;
        for (int y = 0; y < 60; ++y)
        {
            for (int x = 0; x < 200; ++x)
            {
                if (picture.at(x, y).r < 128)
                {
                    left = std::min(left, x);
                    right = std::max(right, x);
                }
            }
        }
        ASSERT_LT(left, right);
        EXPECT_NEAR(across < 0 ? left : across > 0 ? right
          : (left + right)/2, 100, 3);
    }
}


TEST(raster, nearestCentreWinsWhateverTheOrder)
{
    const rgb red{255, 0, 0}, blue{0, 0, 255};
    for (const bool swapped : {false, true})
    {
        raster canvas(20, 10, 3);
        for (const bool second : {swapped, !swapped})
        {
            canvas.cell(second ? 14 : 6, 5, 6, 0, second ? blue : red);
        }
        image picture(20, 10);
        canvas.putOn(picture, 0, 0);
        EXPECT_EQ(picture.at(9, 5), red);
        EXPECT_EQ(picture.at(10, 5), blue);
        EXPECT_EQ(picture.at(0, 0), (rgb{255, 255, 255}));
    }
}


TEST(raster, gapsCloseAndEdgesStay)
{
    const rgb red{255, 0, 0}, white{255, 255, 255};
    raster canvas(30, 30, 1);
    for (int y = 5; y < 25; ++y)
    {
        for (int x = 5; x < 25; ++x)
        {
            if (x != 15 || y != 15)
            {
                canvas.cell(x + 0.5, y + 0.5, 0.5, 0, red);
            }
        }
    }
    image before(30, 30), after(30, 30);
    canvas.putOn(before, 0, 0);
    canvas.closeGaps(3);
    canvas.putOn(after, 0, 0);
    EXPECT_EQ(before.at(15, 15), white);
    EXPECT_EQ(after.at(15, 15), red);
    EXPECT_EQ(find(after, red).count, 400u);
}
