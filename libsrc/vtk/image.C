#include "vtk/image.H"

#include "vtk/vtkFiles.H"

#include <vtkFreeTypeTools.h>
#include <vtkImageData.h>
#include <vtkPNGWriter.h>
#include <vtkStdString.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace gpuFsi
{

image::image(int width, int height)
:
    width_(width),
    height_(height),
    pixels_(static_cast<std::size_t>(width)*height, rgb{255, 255, 255})
{}


void image::fill(int x0, int y0, int x1, int y1, rgb colour)
{
    const int left = std::max(x0, 0), right = std::min(x1, width_);
    for (int y = std::max(y0, 0); y < std::min(y1, height_); ++y)
    {
        for (int x = left; x < right; ++x)
        {
            at(x, y) = colour;
        }
    }
}


void image::frame(int x0, int y0, int x1, int y1, rgb colour)
{
    fill(x0, y0, x1, y0 + 1, colour);
    fill(x0, y1 - 1, x1, y1, colour);
    fill(x0, y0, x0 + 1, y1, colour);
    fill(x1 - 1, y0, x1, y1, colour);
}


//- Letters in black with their coverage as alpha
static vtkSmartPointer<vtkImageData> letters
(
    const std::string& words,
    double size
)
{
    vtkNew<vtkTextProperty> property;
    property->SetFontFamilyToArial();
    property->SetFontSize(std::max(1, static_cast<int>(std::lround(size))));
    property->SetColor(0, 0, 0);
    vtkNew<vtkImageData> picture;
    vtkFreeTypeTools* tools = vtkFreeTypeTools::GetInstance();
    tools->ScaleToPowerTwoOff();
    constexpr int pixelsPerInch = 72;    // makes a point one pixel
    const bool drawn = tools->RenderString
    (
        property,
        vtkStdString(words),
        pixelsPerInch,
        picture
    );
    developerAssert(drawn, "FreeType draws with VTK's built-in font");
    return picture;
}


int image::textWidth(const std::string& words, double size)
{
    return letters(words, size)->GetDimensions()[0];
}


void image::text
(
    int x,
    int y,
    const std::string& words,
    double size,
    rgb colour,
    textAnchor anchor
)
{
    if (words.empty())
    {
        return;
    }
    const vtkSmartPointer<vtkImageData> drawn = letters(words, size);
    const int* extent = drawn->GetExtent();
    const int w = drawn->GetDimensions()[0], h = drawn->GetDimensions()[1];
    const int left = x - (anchor.across + 1)*w/2;

    // Row 0 of the letters is their bottom
    const int bottom = y + (anchor.up + 1)*h/2;
    for (int row = 0; row < h; ++row)
    {
        const int py = bottom - 1 - row;
        for (int column = 0; column < w; ++column)
        {
            const int px = left + column;
            if (px < 0 || py < 0 || px >= width_ || py >= height_)
            {
                continue;
            }
            const auto* ink = static_cast<const unsigned char*>
            (
                drawn->GetScalarPointer
                (
                    extent[0] + column,
                    extent[2] + row,
                    0
                )
            );
            const int alpha = ink[3];
            const auto blend = [alpha](unsigned char under, unsigned char over)
            {
                return static_cast<unsigned char>
                (
                    (under*(255 - alpha) + over*alpha + 127)/255
                );
            };
            rgb& pixel = at(px, py);
            pixel =
            {
                blend(pixel.r, colour.r),
                blend(pixel.g, colour.g),
                blend(pixel.b, colour.b)
            };
        }
    }
}


void image::writePng(const std::filesystem::path& file) const
{
    vtkNew<vtkImageData> data;
    data->SetDimensions(width_, height_, 1);
    data->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
    for (int y = 0; y < height_; ++y)
    {
        std::memcpy
        (
            data->GetScalarPointer(0, height_ - 1 - y, 0),
            pixels_.data() + index(0, y),
            3*static_cast<std::size_t>(width_)
        );
    }
    vtkNew<vtkPNGWriter> writer;
    writer->SetInputData(data);
    writer->WriteToMemoryOn();
    writer->SetCompressionLevel(9);
    writer->Write();
    vtkUnsignedCharArray* result = writer->GetResult();
    writeBytes
    (
        file,
        result->GetPointer(0),
        static_cast<std::size_t>(result->GetNumberOfValues())
    );
}

} // namespace gpuFsi
