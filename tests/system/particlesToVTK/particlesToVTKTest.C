// Runs the program on small cases and reads what it wrote.
#include "case/cloud.H"
#include "case/domain.H"

#include <gtest/gtest.h>

#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkXMLPPolyDataReader.h>
#include <vtkXMLPolyDataReader.h>

#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

using namespace gpuFsi;
namespace fs = std::filesystem;

namespace
{

class particlesToVTK
:
    public ::testing::Test
{
protected:

    void SetUp() override
    {
        const auto* test =
            ::testing::UnitTest::GetInstance()->current_test_info();
        case_ = fs::temp_directory_path()
            /("particlesToVTK-" + std::to_string(getpid()) + test->name());
        fs::create_directories(case_/"system");
        fs::create_directories(case_/"constant");
        std::ofstream(case_/"system/controlDict") << "\n";
        domain d;
        d.spacing = 0.1;
        d.hi = {1, 1, 1};
        d.write(case_);
    }

    void TearDown() override
    {
        fs::remove_all(case_);
    }

    //- Exit status; what it prints goes to log_
    int run(const std::string& options)
    {
        const fs::path log = case_/"log.particlesToVTK";
        const std::string command = std::string("env -u DISPLAY ")
          + PARTICLES_TO_VTK + " -case " + case_.string() + ' ' + options
          + " > " + log.string() + " 2>&1";
        const int status = std::system(command.c_str());
        log_ = contents(log);
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }

    static std::string contents(const fs::path& file)
    {
        std::ifstream in(file, std::ios::binary);
        std::stringstream text;
        text << in.rdbuf();
        return text.str();
    }

    //- n particles with U = 3 x and id = 10 times the place
    static cloud particles(const std::string& name, std::size_t n)
    {
        cloud c;
        c.name = name;
        std::vector<vector> velocity;
        std::vector<double> ids;
        for (std::size_t i = 0; i < n; ++i)
        {
            const double s = (i + 0.5)/(n + 1);
            c.positions.push_back({s, s/3, 0.5});
            velocity.push_back(3.0*c.positions.back());
            ids.push_back(10.0*i);
        }
        c.addVector("U", velocity);
        c.addLabel("id", ids);
        return c;
    }

    void writeTime
    (
        const fs::path& folder,
        long index,
        const std::vector<cloud>& clouds
    )
    {
        for (const cloud& c : clouds)
        {
            writeCloud(case_/folder, c, {});
        }
        fs::create_directories(case_/folder/"uniform");
        std::ofstream(case_/folder/"uniform/time")
            << "FoamFile\n{\n    format ascii;\n    class dictionary;\n"
            << "    object time;\n}\nindex " << index << ";\n";
    }

    //- Two times, two clouds, the solid from 0.5 on
    void writeSerial()
    {
        writeTime("0", 0, {particles("fluid", 7)});
        writeTime("0.5", 40, {particles("fluid", 7), particles("solid", 2)});
    }

    void expectError(const std::string& options, const std::string& text)
    {
        EXPECT_EQ(run(options), 1) << options;
        EXPECT_NE(log_.find("FOAM FATAL"), std::string::npos) << log_;
        EXPECT_NE(log_.find(text), std::string::npos) << options << log_;
    }

    fs::path case_;
    std::string log_;
};


template<class Reader>
vtkSmartPointer<vtkPolyData> readBack(const fs::path& file)
{
    vtkNew<Reader> reader;
    reader->SetFileName(file.c_str());
    reader->Update();
    return reader->GetOutput();
}

} // namespace


TEST_F(particlesToVTK, writesEveryTimeAndCloud)
{
    writeSerial();
    ASSERT_EQ(run(""), 0) << log_;
    EXPECT_NE(log_.find("\nEnd"), std::string::npos);
    const fs::path out = case_/"VTK/lagrangian";
    EXPECT_TRUE(fs::exists(out/"fluid/fluid_0.vtp"));
    EXPECT_TRUE(fs::exists(out/"solid/solid_40.vtp"));
    EXPECT_FALSE(fs::exists(out/"solid/solid_0.vtp"));
    const auto data =
        readBack<vtkXMLPolyDataReader>(out/"fluid/fluid_40.vtp");
    const cloud expected = particles("fluid", 7);
    ASSERT_EQ(data->GetNumberOfPoints(), 7);
    vtkDataArray* velocity = data->GetPointData()->GetArray("U");
    vtkDataArray* ids = data->GetPointData()->GetArray("id");
    ASSERT_TRUE(velocity && ids);
    for (int i = 0; i < 7; ++i)
    {
        EXPECT_EQ(data->GetPoint(i)[1], expected.positions[i].y);
        EXPECT_EQ(velocity->GetComponent(i, 0), 3*expected.positions[i].x);
        EXPECT_EQ(ids->GetComponent(i, 0), 10*i);
    }
    const std::string series = contents(out/"fluid/fluid.vtp.series");
    EXPECT_NE(series.find("\"fluid_0.vtp\", \"time\" : 0 }"),
        std::string::npos);
    EXPECT_NE(series.find("\"fluid_40.vtp\", \"time\" : 0.5 }"),
        std::string::npos);
}


TEST_F(particlesToVTK, selectsTimesCloudsAndFields)
{
    writeSerial();
    const fs::path out = case_/"VTK/lagrangian";
    ASSERT_EQ(run("-noZero -cloud fluid -fields '(U)' -float"), 0) << log_;
    EXPECT_FALSE(fs::exists(out/"fluid/fluid_0.vtp"));
    EXPECT_FALSE(fs::exists(out/"solid"));
    const auto data =
        readBack<vtkXMLPolyDataReader>(out/"fluid/fluid_40.vtp");
    EXPECT_EQ(data->GetPointData()->GetNumberOfArrays(), 1);
    EXPECT_EQ(data->GetPointData()->GetArray("U")->GetDataType(), VTK_FLOAT);
    ASSERT_EQ(run("-latestTime -ascii"), 0) << log_;
    ASSERT_EQ(run("-time :0.2 -compress"), 0) << log_;
    EXPECT_TRUE(fs::exists(out/"fluid/fluid_0.vtp"));
}


TEST_F(particlesToVTK, timesWithoutIndexAreNumberedInOrder)
{
    writeSerial();
    fs::remove_all(case_/"0/uniform");
    ASSERT_EQ(run(""), 0) << log_;
    EXPECT_TRUE(fs::exists(case_/"VTK/lagrangian/fluid/fluid_0.vtp"));
    EXPECT_TRUE(fs::exists(case_/"VTK/lagrangian/fluid/fluid_1.vtp"));
}


TEST_F(particlesToVTK, emptyCloudWorks)
{
    writeTime("0", 0, {particles("fluid", 0)});
    ASSERT_EQ(run(""), 0) << log_;
    const auto data = readBack<vtkXMLPolyDataReader>
    (
        case_/"VTK/lagrangian/fluid/fluid_0.vtp"
    );
    EXPECT_EQ(data->GetNumberOfPoints(), 0);
    ASSERT_NE(data->GetPointData()->GetArray("U"), nullptr);
    EXPECT_EQ(run("-image " + (case_/"a.png").string()), 0) << log_;
}


TEST_F(particlesToVTK, decomposedCaseGivesPieces)
{
    // The root has time 0 alone; one rank has no cloud, another an empty one
    writeTime("0", 0, {particles("fluid", 7)});
    const std::vector<std::size_t> sizes{3, 0, 4};
    for (std::size_t r = 0; r < 4; ++r)
    {
        const fs::path rank = "processor" + std::to_string(r);
        for (const char* time : {"0", "0.5"})
        {
            std::vector<cloud> clouds;
            if (r < sizes.size())
            {
                clouds.push_back(particles("fluid", sizes[r]));
            }
            writeTime(rank/time, std::string(time) == "0" ? 0 : 40, clouds);
        }
    }
    writeTime("processor0/0.7", 60, {particles("fluid", 3)});
    ASSERT_EQ(run(""), 0) << log_;
    EXPECT_NE(log_.find("only 1 of 4 processors"), std::string::npos);
    EXPECT_TRUE(fs::exists
    (
        case_/"VTK/processor3/lagrangian/fluid/fluid_40.vtp"
    ));
    const fs::path out = case_/"VTK/lagrangian/fluid";
    const auto data =
        readBack<vtkXMLPPolyDataReader>(out/"fluid_40.pvtp");
    ASSERT_EQ(data->GetNumberOfPoints(), 7);
    ASSERT_EQ(data->GetNumberOfVerts(), 7);
    vtkDataArray* ids = data->GetPointData()->GetArray("id");
    ASSERT_NE(ids, nullptr);
    EXPECT_EQ(ids->GetComponent(2, 0), 20);
    EXPECT_EQ(ids->GetComponent(3, 0), 0);
    EXPECT_EQ(ids->GetComponent(6, 0), 30);
    const std::string series = contents(out/"fluid.pvtp.series");
    EXPECT_NE(series.find("fluid_0.pvtp"), std::string::npos);
    EXPECT_NE(series.find("fluid_40.pvtp"), std::string::npos);

    // Reconstructed: the root has the latest time of all ranks
    writeTime("0.5", 40, {particles("fluid", 7)});
    fs::remove_all(case_/"VTK");
    ASSERT_EQ(run(""), 0) << log_;
    EXPECT_TRUE(fs::exists(out/"fluid_40.vtp"));
    EXPECT_FALSE(fs::exists(case_/"VTK/processor0"));

    // The pieces all the same, where they are asked for
    ASSERT_EQ(run("-decomposed -latestTime"), 0) << log_;
    EXPECT_EQ
    (
        readBack<vtkXMLPPolyDataReader>
        (
            out/"fluid_40.pvtp"
        )->GetNumberOfPoints(),
        7
    );
    const std::string picture = (case_/"a.png").string();
    EXPECT_EQ(run("-decomposed -image " + picture), 0) << log_;
}


TEST_F(particlesToVTK, paintsPictures)
{
    writeSerial();
    const std::string file = (case_/"pictures/a.png").string();
    for
    (
        const char* options
      : {
            "", "-field U.x -cut x=0.3 -range '-1 2'", "-view 3d -field id",
            "-view 3d -camera '30 -20' -clip 'x<0.5 || y>0.1'",
            "-clouds '(solid)' -colours coolToWarm -size '400 300'",
            "-imageTime 0 -colours grey"
        }
    )
    {
        fs::remove(file);
        EXPECT_EQ(run("-image " + file + ' ' + options), 0)
            << options << log_;
        EXPECT_EQ(contents(file).compare(1, 3, "PNG"), 0) << options;
    }
    EXPECT_FALSE(fs::exists(case_/"VTK"));

    const std::string again = (case_/"b.png").string();
    ASSERT_EQ(run("-image " + file), 0);
    ASSERT_EQ(run("-image " + again), 0);
    EXPECT_EQ(contents(file), contents(again));
}


TEST_F(particlesToVTK, mistakesAreNamed)
{
    expectError("", "no time folder with a cloud");
    writeSerial();
    const std::string image = "-image " + (case_/"a.png").string() + ' ';
    expectError("-cloud steel", "solid");
    expectError("-decomposed", "Leave -decomposed out");
    expectError("-fields '(U rho)'", "rho");
    expectError("-fields '()'", "list of names");
    expectError("-time 3", "0.5");
    expectError("-ascii -compress", "exclude each other");
    expectError("-field U", "only with -image");
    expectError(image + "-float", "no meaning with -image");
    expectError(image + "-field rho", "rho");
    expectError(image + "-field U.w", "U.w");
    expectError(image + "-imageTime 3", "0 0.5");
    expectError(image + "-imageTime soon", "not a number");
    expectError(image + "-clouds '(steel)'", "fluid");
    expectError(image + "-cut w=1", "not a plane");
    expectError(image + "-cut z", "not a plane");
    expectError(image + "-cut z=1 -view 3d", "exclude each other");
    expectError(image + "-view top", "3d");
    expectError(image + "-camera '1 2'", "-view 3d");
    expectError(image + "-view 3d -camera '1 200'", "elevation");
    expectError(image + "-clip 'q>0'", "q");
    expectError(image + "-range '2 1'", "ascending");
    expectError(image + "-range 2", "2 numbers");
    expectError(image + "-colours jet", "viridis");
    expectError(image + "-size '10 10'", "out of range");
    expectError("-image a.jpg", ".png");
    expectError("-image /dev/null/a.png", "Cannot write");
    std::ofstream(case_/"VTK") << "in the way";
    expectError("", "Cannot write");
    fs::remove_all(case_/"0");
    fs::remove(case_/"constant/domain");
    expectError(image, "seedParticles");
    std::ofstream(case_/"0.5/lagrangian/fluid/U") << "broken";
    expectError("", "lagrangian/fluid/U");
    fs::create_directories(case_/"processor1");
    expectError("", "no processor0");
}
