// Files are read back by VTK's own readers; every value must come back exactly.
#include "vtk/vtkFiles.H"

#include <gtest/gtest.h>

#include <vtkCellArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkXMLPPolyDataReader.h>
#include <vtkXMLPolyDataReader.h>

#include <unistd.h>

#include <fstream>
#include <sstream>

using namespace gpuFsi;
namespace fs = std::filesystem;

namespace
{

class vtkFiles
:
    public ::testing::Test
{
protected:

    void SetUp() override
    {
        const auto* test =
            ::testing::UnitTest::GetInstance()->current_test_info();
        directory_ = fs::temp_directory_path()
            /("vtkFiles-" + std::to_string(getpid()) + '-' + test->name());
        fs::create_directories(directory_);
    }

    void TearDown() override
    {
        fs::remove_all(directory_);
    }

    fs::path directory_;
};


//- Values that no short decimal holds
cloud sample(std::size_t n)
{
    cloud c;
    c.name = "fluid";
    cloudField scalars{"scalarField", "rho", {}};
    cloudField vectors{"vectorField", "U", {}};
    cloudField labels{"labelField", "id", {}};
    cloudField symm{"symmTensorField", "stress", {}};
    cloudField tensors{"tensorField", "F", {}};
    for (std::size_t i = 0; i < n; ++i)
    {
        const double s = 1.0/(3 + i);
        c.positions.push_back({s, 2*s, -7*s});
        scalars.values.push_back(1000 + s);
        labels.values.push_back(static_cast<double>(i) - 5);
        for (int k = 0; k < 3; ++k)
        {
            vectors.values.push_back(s*(k + 1)/7);
        }
        for (int k = 0; k < 6; ++k)
        {
            symm.values.push_back(s + k);
        }
        for (int k = 0; k < 9; ++k)
        {
            tensors.values.push_back(s - k);
        }
    }
    c.fields = {scalars, vectors, labels, symm, tensors};
    return c;
}


vtkSmartPointer<vtkPolyData> readBack(const fs::path& file)
{
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->SetFileName(file.c_str());
    reader->Update();
    EXPECT_EQ(reader->GetErrorCode(), 0u);
    return reader->GetOutput();
}


void write
(
    const fs::path& file,
    const cloud& particles,
    vtkEncoding encoding,
    bool single = false
)
{
    std::vector<cloud> pieces{particles};
    const auto layout = layoutOf(pieces, {}, single);
    writeVtp(file, *toPolyData(pieces[0], layout, single, 0.25), encoding);
}


//- file: our order of components; place: where VTK has component c of it
void expectField
(
    vtkPolyData& data,
    const cloudField& field,
    const std::vector<int>& place
)
{
    vtkDataArray* array = data.GetPointData()->GetArray(field.name.c_str());
    ASSERT_NE(array, nullptr) << field.name;
    const int n = static_cast<int>(place.size());
    ASSERT_EQ(array->GetNumberOfComponents(), n);
    ASSERT_EQ(array->GetNumberOfTuples(), vtkIdType(field.values.size()/n));
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    {
        for (int c = 0; c < n; ++c)
        {
            EXPECT_EQ(array->GetComponent(i, place[c]), field.values[i*n + c]);
        }
    }
}


void expectSame(vtkPolyData& data, const cloud& particles)
{
    const auto n = static_cast<vtkIdType>(particles.size());
    ASSERT_EQ(data.GetNumberOfPoints(), n);
    ASSERT_EQ(data.GetNumberOfVerts(), n);
    for (vtkIdType i = 0; i < n; ++i)
    {
        double p[3];
        data.GetPoint(i, p);
        EXPECT_EQ(p[0], particles.positions[i].x);
        EXPECT_EQ(p[1], particles.positions[i].y);
        EXPECT_EQ(p[2], particles.positions[i].z);
        vtkIdType size;
        const vtkIdType* ids;
        data.GetVerts()->GetCellAtId(i, size, ids);
        ASSERT_EQ(size, 1);
        EXPECT_EQ(ids[0], i);
    }
    ASSERT_EQ(data.GetPointData()->GetNumberOfArrays(), 5);
    expectField(data, particles.fields[0], {0});
    expectField(data, particles.fields[1], {0, 1, 2});
    expectField(data, particles.fields[2], {0});

    // xx xy xz yy yz zz among XX YY ZZ XY YZ XZ
    expectField(data, particles.fields[3], {0, 3, 5, 1, 4, 2});
    expectField(data, particles.fields[4], {0, 1, 2, 3, 4, 5, 6, 7, 8});
}


std::string contents(const fs::path& file)
{
    std::ifstream in(file, std::ios::binary);
    std::stringstream text;
    text << in.rdbuf();
    return text.str();
}

} // namespace


TEST_F(vtkFiles, everyEncodingReadsBackExactly)
{
    for
    (
        const vtkEncoding encoding
      : {vtkEncoding::binary, vtkEncoding::compressed, vtkEncoding::ascii}
    )
    {
        for (const std::size_t n : {0, 1, 137})
        {
            const cloud particles = sample(n);
            const fs::path file = directory_/"new/deeper/a.vtp";
            write(file, particles, encoding);
            const auto data = readBack(file);
            expectSame(*data, particles);
            vtkDataArray* time = data->GetFieldData()->GetArray("TimeValue");
            ASSERT_NE(time, nullptr);
            EXPECT_EQ(time->GetComponent(0, 0), 0.25);
            EXPECT_FALSE(fs::exists(file.string() + ".part"));
        }
    }
}


TEST_F(vtkFiles, componentsAreNamedAsParaViewDoes)
{
    write(directory_/"a.vtp", sample(2), vtkEncoding::binary);
    const auto data = readBack(directory_/"a.vtp");
    vtkDataArray* stress = data->GetPointData()->GetArray("stress");
    EXPECT_STREQ(stress->GetComponentName(3), "XY");
    EXPECT_STREQ(stress->GetComponentName(5), "XZ");
    EXPECT_EQ
    (
        data->GetPointData()->GetArray("id")->GetDataType(),
        VTK_INT
    );
}


TEST_F(vtkFiles, singlePrecisionRoundsEveryNumberButLabels)
{
    const cloud particles = sample(9);
    write(directory_/"a.vtp", particles, vtkEncoding::binary, true);
    const auto data = readBack(directory_/"a.vtp");
    vtkDataArray* rho = data->GetPointData()->GetArray("rho");
    ASSERT_EQ(rho->GetDataType(), VTK_FLOAT);
    ASSERT_EQ(data->GetPoints()->GetDataType(), VTK_FLOAT);
    for (int i = 0; i < 9; ++i)
    {
        EXPECT_EQ
        (
            rho->GetComponent(i, 0),
            static_cast<float>(particles.fields[0].values[i])
        );
        EXPECT_EQ
        (
            data->GetPointData()->GetArray("id")->GetComponent(i, 0),
            i - 5
        );
    }
}


TEST_F(vtkFiles, labelBeyond32BitsKeepsItsValue)
{
    cloud particles = sample(2);
    particles.fields[2].values[1] = 9007199254740991.0;
    write(directory_/"a.vtp", particles, vtkEncoding::binary);
    const auto data = readBack(directory_/"a.vtp");
    EXPECT_EQ
    (
        data->GetPointData()->GetArray("id")->GetVariantValue(1).ToLongLong(),
        9007199254740991LL
    );
}


TEST_F(vtkFiles, sameInputGivesSameBytes)
{
    for (const char* name : {"a.vtp", "b.vtp"})
    {
        write(directory_/name, sample(50), vtkEncoding::compressed);
    }
    EXPECT_EQ(contents(directory_/"a.vtp"), contents(directory_/"b.vtp"));
}


TEST_F(vtkFiles, piecesWithAnEmptyRankReadAsOne)
{
    // The empty rank has no fields at all, as one without a cloud folder
    std::vector<cloud> pieces{sample(3), cloud{"fluid", {}, {}}, sample(4)};
    const std::vector<cloud> originals = pieces;
    const auto layout = layoutOf(pieces, {}, false);
    std::vector<std::string> names;
    for (std::size_t r = 0; r < pieces.size(); ++r)
    {
        names.push_back("p" + std::to_string(r) + ".vtp");
        writeVtp
        (
            directory_/names.back(),
            *toPolyData(pieces[r], layout, false, 1),
            vtkEncoding::binary
        );
    }
    writePvtp(directory_/"all.pvtp", names, layout, false);

    vtkNew<vtkXMLPPolyDataReader> reader;
    reader->SetFileName((directory_/"all.pvtp").c_str());
    reader->Update();
    cloud whole = originals[0];
    const cloud& last = originals[2];
    whole.positions.insert
    (
        whole.positions.end(), last.positions.begin(), last.positions.end()
    );
    for (std::size_t f = 0; f < whole.fields.size(); ++f)
    {
        std::vector<double>& to = whole.fields[f].values;
        const std::vector<double>& from = last.fields[f].values;
        to.insert(to.end(), from.begin(), from.end());
    }
    expectSame(*reader->GetOutput(), whole);
}


TEST_F(vtkFiles, selectionLeavesOtherFieldsOut)
{
    std::vector<cloud> pieces{sample(3)};
    const auto layout = layoutOf(pieces, {"U", "rho"}, false);
    ASSERT_EQ(layout.size(), 2u);
    EXPECT_EQ(layout[0].name, "rho");
    EXPECT_EQ(layout[1].name, "U");
}


TEST_F(vtkFiles, piecesThatDisagreeAreRefused)
{
    std::vector<cloud> pieces{sample(3), sample(2)};
    pieces[1].fields[0].cls = "labelField";
    EXPECT_THROW(layoutOf(pieces, {}, false), userError);

    pieces[1].fields.clear();
    const auto layout = layoutOf(pieces, {}, false);
    EXPECT_THROW(toPolyData(pieces[1], layout, false, 0), userError);
}


TEST_F(vtkFiles, seriesListsNamesAndTimesExactly)
{
    writeSeries
    (
        directory_/"a.vtp.series",
        {{"a_0.vtp", 0}, {"a_7.vtp", 0.1}}
    );
    EXPECT_EQ
    (
        contents(directory_/"a.vtp.series"),
        "{\n"
        "  \"file-series-version\" : \"1.0\",\n"
        "  \"files\" : [\n"
        "    { \"name\" : \"a_0.vtp\", \"time\" : 0 },\n"
        "    { \"name\" : \"a_7.vtp\", \"time\" : 0.1 }\n"
        "  ]\n"
        "}\n"
    );
}


TEST_F(vtkFiles, fileInTheWayOfADirectoryIsAUserError)
{
    std::ofstream(directory_/"taken") << "x";
    try
    {
        write(directory_/"taken/a.vtp", sample(1), vtkEncoding::binary);
        FAIL() << "nothing was thrown";
    }
    catch (const userError& error)
    {
        EXPECT_NE(std::string(error.what()).find("taken"), std::string::npos);
    }
    EXPECT_THROW
    (
        writeSeries(directory_/"taken/a.series", {}),
        userError
    );
}


TEST_F(vtkFiles, fullDiskIsAUserError)
{
    if (!fs::exists("/dev/full"))
    {
        GTEST_SKIP() << "no /dev/full here";
    }
    for (const char* name : {"a.vtp", "b.series"})
    {
        fs::create_symlink
        (
            "/dev/full",
            directory_/(std::string(name) + ".part")
        );
    }
    EXPECT_THROW
    (
        write(directory_/"a.vtp", sample(5000), vtkEncoding::binary),
        userError
    );
    EXPECT_THROW(writeSeries(directory_/"b.series", {}), userError);
    EXPECT_FALSE(fs::exists(directory_/"a.vtp"));
}
