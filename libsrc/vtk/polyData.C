#include "vtk/polyData.H"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkIdTypeArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTypeInt32Array.h>
#include <vtkTypeInt64Array.h>

#include <algorithm>
#include <limits>
#include <numeric>

namespace gpuFsi
{

static bool fitsInt32(const std::vector<double>& values)
{
    using limits = std::numeric_limits<std::int32_t>;
    return std::all_of
    (
        values.begin(),
        values.end(),
        [](double v) { return v >= limits::min() && v <= limits::max(); }
    );
}


std::vector<arrayLayout> layoutOf
(
    const std::vector<cloud>& pieces,
    const std::set<std::string>& selected,
    bool single
)
{
    std::vector<arrayLayout> layout;
    for (const cloud& piece : pieces)
    {
        for (const cloudField& field : piece.fields)
        {
            if (!selected.empty() && !selected.count(field.name))
            {
                continue;
            }
            auto known = std::find_if
            (
                layout.begin(),
                layout.end(),
                [&](const arrayLayout& a) { return a.name == field.name; }
            );
            if (known == layout.end())
            {
                layout.push_back({field.name, field.cls, {}});
                known = layout.end() - 1;
                known->vtkType =
                    field.cls == "labelField" ? "Int32"
                  : single ? "Float32"
                  : "Float64";
            }
            if (known->cls != field.cls)
            {
                throw userError
                (
                    "Field " + field.name + " of cloud " + piece.name
                  + " is a " + known->cls + " on one processor and a "
                  + field.cls + " on another",
                    {},
                    "Write the cloud again with one program"
                );
            }
            if (known->vtkType == "Int32" && !fitsInt32(field.values))
            {
                known->vtkType = "Int64";
            }
        }
    }
    return layout;
}


std::vector<std::string> componentNames(const std::string& cls)
{
    if (cls == "vectorField")
    {
        return {"X", "Y", "Z"};
    }
    if (cls == "symmTensorField")
    {
        return {"XX", "YY", "ZZ", "XY", "YZ", "XZ"};
    }
    if (cls == "tensorField")
    {
        return {"XX", "XY", "XZ", "YX", "YY", "YZ", "ZX", "ZY", "ZZ"};
    }
    return {};
}


//- Files hold xx xy xz yy yz zz
static void toVtkOrder(std::vector<double>& values)
{
    for (std::size_t i = 0; i + 6 <= values.size(); i += 6)
    {
        double* v = values.data() + i;
        const double xy = v[1], xz = v[2];
        v[1] = v[3];
        v[2] = v[5];
        v[3] = xy;
        v[5] = xz;
    }
}


template<class Array>
static vtkSmartPointer<vtkDataArray> converted
(
    const double* values,
    std::size_t size,
    int nComponents
)
{
    vtkNew<Array> array;
    array->SetNumberOfComponents(nComponents);
    array->SetNumberOfTuples(static_cast<vtkIdType>(size/nComponents));
    using number = typename Array::ValueType;
    std::transform
    (
        values,
        values + size,
        array->GetPointer(0),
        [](double v) { return static_cast<number>(v); }
    );
    return array;
}


//- No copy: the values stay where they are
static vtkSmartPointer<vtkDataArray> borrowed
(
    double* values,
    std::size_t size,
    int nComponents
)
{
    vtkNew<vtkDoubleArray> array;
    array->SetNumberOfComponents(nComponents);
    array->SetArray(values, static_cast<vtkIdType>(size), 1);
    return array;
}


static vtkSmartPointer<vtkDataArray> toArray
(
    double* values,
    std::size_t size,
    int nComponents,
    const std::string& vtkType
)
{
    if (vtkType == "Int32")
    {
        return converted<vtkTypeInt32Array>(values, size, nComponents);
    }
    if (vtkType == "Int64")
    {
        return converted<vtkTypeInt64Array>(values, size, nComponents);
    }
    if (vtkType == "Float32")
    {
        return converted<vtkFloatArray>(values, size, nComponents);
    }
    return borrowed(values, size, nComponents);
}


//- 32-bit indices where they suffice: half the size of the file's topology
static vtkSmartPointer<vtkCellArray> vertexCells(std::size_t n)
{
    vtkNew<vtkCellArray> cells;
    const auto fill = [&](auto& offsets, auto& connectivity)
    {
        offsets->SetNumberOfValues(static_cast<vtkIdType>(n + 1));
        connectivity->SetNumberOfValues(static_cast<vtkIdType>(n));
        std::iota(offsets->GetPointer(0), offsets->GetPointer(0) + n + 1, 0);
        std::iota
        (
            connectivity->GetPointer(0),
            connectivity->GetPointer(0) + n,
            0
        );
        cells->SetData(offsets, connectivity);
    };
    if (n < static_cast<std::size_t>(std::numeric_limits<int>::max()))
    {
        vtkNew<vtkTypeInt32Array> offsets, connectivity;
        fill(offsets, connectivity);
    }
    else
    {
        vtkNew<vtkTypeInt64Array> offsets, connectivity;
        fill(offsets, connectivity);
    }
    return cells;
}


vtkSmartPointer<vtkPolyData> toPolyData
(
    cloud& piece,
    const std::vector<arrayLayout>& layout,
    bool single,
    double time
)
{
    static_assert(sizeof(vector) == 3*sizeof(double), "positions lie flat");
    const std::size_t n = piece.size();
    vtkNew<vtkPolyData> data;

    vtkNew<vtkPoints> points;
    double none = 0;
    points->SetData
    (
        toArray
        (
            n ? &piece.positions.front().x : &none,
            3*n,
            3,
            single ? "Float32" : "Float64"
        )
    );
    points->GetData()->SetName("Points");
    data->SetPoints(points);
    data->SetVerts(vertexCells(n));

    for (const arrayLayout& wanted : layout)
    {
        cloudField empty{wanted.cls, wanted.name, {}};
        cloudField* field = &empty;
        for (cloudField& candidate : piece.fields)
        {
            field = candidate.name == wanted.name ? &candidate : field;
        }
        if (field->size() != n)
        {
            throw userError
            (
                "Field " + wanted.name + " of cloud " + piece.name + " has "
              + std::to_string(field->size()) + " values for "
              + std::to_string(n) + " particles",
                {},
                "Write the time again, or leave the field out with -fields"
            );
        }
        if (wanted.cls == "symmTensorField")
        {
            toVtkOrder(field->values);
        }
        const vtkSmartPointer<vtkDataArray> array = toArray
        (
            field->values.data(),
            field->values.size(),
            field->nComponents(),
            wanted.vtkType
        );
        array->SetName(wanted.name.c_str());
        const std::vector<std::string> names = componentNames(wanted.cls);
        for (std::size_t c = 0; c < names.size(); ++c)
        {
            array->SetComponentName
            (
                static_cast<vtkIdType>(c),
                names[c].c_str()
            );
        }
        data->GetPointData()->AddArray(array);
    }

    vtkNew<vtkDoubleArray> timeValue;
    timeValue->SetName("TimeValue");
    timeValue->InsertNextValue(time);
    data->GetFieldData()->AddArray(timeValue);
    return data;
}

} // namespace gpuFsi
