"""What vtkOpenFOAMReader sees of a case at its last time: a line a cloud with
its name, number of points and names of fields, then a line a particle: its
position and rho. Exit code 77: no VTK."""
import sys

try:
    from vtkmodules.vtkIOGeometry import vtkOpenFOAMReader
except ImportError:
    sys.exit(77)


def show(block):
    for i in range(block.GetNumberOfBlocks()):
        child = block.GetBlock(i)
        if child is None:
            continue
        if hasattr(child, "GetNumberOfBlocks"):
            show(child)
            continue
        data = child.GetPointData()
        rho = data.GetArray("rho")
        if rho is None:
            continue
        names = sorted(data.GetArrayName(a)
                       for a in range(data.GetNumberOfArrays()))
        name = block.GetMetaData(i).Get(block.NAME())
        print(name, child.GetNumberOfPoints(), ",".join(names))
        for p in range(child.GetNumberOfPoints()):
            print(*child.GetPoint(p), rho.GetValue(p))


reader = vtkOpenFOAMReader()
reader.SetFileName(sys.argv[1])
reader.UpdateInformation()
for i in range(reader.GetNumberOfPatchArrays()):
    reader.SetPatchArrayStatus(reader.GetPatchArrayName(i), 1)
times = reader.GetTimeValues()
reader.UpdateTimeStep(times.GetValue(times.GetNumberOfValues() - 1))
show(reader.GetOutput())
