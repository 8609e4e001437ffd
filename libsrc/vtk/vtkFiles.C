#include "vtk/vtkFiles.H"

#include <fmt/format.h>

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkExecutive.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

#include <cerrno>
#include <cstring>
#include <fstream>

namespace gpuFsi
{

namespace fs = std::filesystem;

static userError cannotWrite(const fs::path& file, const std::string& why)
{
    return userError
    (
        "Cannot write " + file.string() + (why.empty() ? "" : ": " + why),
        {},
        "Check the permissions of its directory and the space left there"
    );
}


static fs::path besides(const fs::path& file)
{
    std::error_code failed;
    if (file.has_parent_path())
    {
        fs::create_directories(file.parent_path(), failed);
    }
    if (failed)
    {
        throw cannotWrite(file, failed.message());
    }
    return file.string() + ".part";
}


static void takeName(const fs::path& part, const fs::path& file)
{
    std::error_code failed;
    fs::rename(part, file, failed);
    if (failed)
    {
        const std::string why = failed.message();
        fs::remove(part, failed);
        throw cannotWrite(file, why);
    }
}


//- VTK reports through events; without an observer it prints them. The first
//  message is the cause of those after it.
static void keepMessage(vtkObject*, unsigned long, void* kept, void* message)
{
    std::string& text = *static_cast<std::string*>(kept);
    text = text.empty() ? static_cast<const char*>(message) : text;
}


void writeVtp
(
    const fs::path& file,
    vtkPolyData& data,
    vtkEncoding encoding
)
{
    const fs::path part = besides(file);

    // VTK's own message does not say why the file does not open
    if (!std::ofstream(part))
    {
        throw cannotWrite(file, std::strerror(errno));
    }
    vtkNew<vtkXMLPolyDataWriter> writer;
    std::string message;
    vtkNew<vtkCallbackCommand> observer;
    observer->SetCallback(keepMessage);
    observer->SetClientData(&message);
    writer->AddObserver(vtkCommand::ErrorEvent, observer);
    writer->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, observer);
    writer->SetFileName(part.c_str());
    writer->SetInputData(&data);
    writer->SetHeaderTypeToUInt64();
    if (encoding == vtkEncoding::ascii)
    {
        writer->SetDataModeToAscii();
    }
    else
    {
        writer->SetDataModeToAppended();
        writer->EncodeAppendedDataOff();
    }
    if (encoding == vtkEncoding::compressed)
    {
        writer->SetCompressorTypeToZLib();
        writer->SetCompressionLevel(1);
    }
    else
    {
        writer->SetCompressorTypeToNone();
    }
    if (!writer->Write() || writer->GetErrorCode() || !message.empty())
    {
        std::error_code ignored;
        fs::remove(part, ignored);
        throw cannotWrite(file, message.substr(0, message.find('\n')));
    }
    takeName(part, file);
}


void writeBytes(const fs::path& file, const void* bytes, std::size_t size)
{
    const fs::path part = besides(file);
    errno = 0;
    std::ofstream out(part, std::ios::binary);
    out.write
    (
        static_cast<const char*>(bytes),
        static_cast<std::streamsize>(size)
    );
    out.close();
    if (!out)
    {
        const std::string why = std::strerror(errno);
        std::error_code ignored;
        fs::remove(part, ignored);
        throw cannotWrite(file, why);
    }
    takeName(part, file);
}


static std::string escaped(const std::string& text)
{
    std::string safe;
    for (const char c : text)
    {
        safe +=
            c == '&' ? "&amp;"
          : c == '<' ? "&lt;"
          : c == '>' ? "&gt;"
          : c == '"' ? "&quot;"
          : std::string(1, c);
    }
    return safe;
}


void writePvtp
(
    const fs::path& file,
    const std::vector<std::string>& pieces,
    const std::vector<arrayLayout>& layout,
    bool single
)
{
    std::string text =
        "<?xml version=\"1.0\"?>\n"
        "<VTKFile type=\"PPolyData\" version=\"1.0\""
        " byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
        "  <PPolyData GhostLevel=\"0\">\n"
        "    <PPointData>\n";
    for (const arrayLayout& array : layout)
    {
        const std::vector<std::string> names = componentNames(array.cls);
        text += fmt::format
        (
            "      <PDataArray type=\"{}\" Name=\"{}\"",
            array.vtkType,
            escaped(array.name)
        );
        if (!names.empty())
        {
            text += fmt::format(" NumberOfComponents=\"{}\"", names.size());
        }
        for (std::size_t c = 0; c < names.size(); ++c)
        {
            text += fmt::format(" ComponentName{}=\"{}\"", c, names[c]);
        }
        text += "/>\n";
    }
    text += fmt::format
    (
        "    </PPointData>\n"
        "    <PPoints>\n"
        "      <PDataArray type=\"{}\" Name=\"Points\""
        " NumberOfComponents=\"3\"/>\n"
        "    </PPoints>\n",
        single ? "Float32" : "Float64"
    );
    for (const std::string& piece : pieces)
    {
        text += "    <Piece Source=\"" + escaped(piece) + "\"/>\n";
    }
    text += "  </PPolyData>\n</VTKFile>\n";
    writeBytes(file, text.data(), text.size());
}


void writeSeries
(
    const fs::path& file,
    const std::vector<seriesEntry>& entries
)
{
    std::string text =
        "{\n  \"file-series-version\" : \"1.0\",\n  \"files\" : [\n";
    for (std::size_t i = 0; i < entries.size(); ++i)
    {
        text += fmt::format
        (
            "    {{ \"name\" : \"{}\", \"time\" : {} }}{}\n",
            entries[i].name,
            entries[i].time,
            i + 1 < entries.size() ? "," : ""
        );
    }
    text += "  ]\n}\n";
    writeBytes(file, text.data(), text.size());
}

} // namespace gpuFsi
