"""Print what vtkOpenFOAMReader sees of a case: for every time the number of
particles, then x y z U rho id of every particle. Exit code 77: no VTK."""
import sys

try:
    from vtkmodules.vtkIOGeometry import vtkOpenFOAMReader
except ImportError:
    sys.exit(77)


def find_cloud(block, name):
    for i in range(block.GetNumberOfBlocks()):
        child = block.GetBlock(i)
        if child is None:
            continue
        if hasattr(child, "GetNumberOfBlocks"):
            found = find_cloud(child, name)
            if found is not None:
                return found
        elif block.GetMetaData(i).Get(block.NAME()) == name:
            return child
    return None


reader = vtkOpenFOAMReader()
reader.SetFileName(sys.argv[1])
reader.SkipZeroTimeOff()
reader.UpdateInformation()
for i in range(reader.GetNumberOfPatchArrays()):
    reader.SetPatchArrayStatus(reader.GetPatchArrayName(i), 1)
times = reader.GetTimeValues()
for i in range(times.GetNumberOfValues()):
    reader.UpdateTimeStep(times.GetValue(i))
    cloud = find_cloud(reader.GetOutput(), sys.argv[2])
    print(times.GetValue(i), cloud.GetNumberOfPoints())
    data = cloud.GetPointData()
    for p in range(cloud.GetNumberOfPoints()):
        print(*cloud.GetPoint(p), *data.GetArray("U").GetTuple(p),
              data.GetArray("rho").GetValue(p),
              data.GetArray("id").GetValue(p))
