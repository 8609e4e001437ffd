"""Points that ParaView's readers find at the last time of a decomposed case:
CASE.foam as `Decomposed Case`, then a .pvtp file; a line each with the number
of points and the sum of origId. Exit code 77: no VTK."""
import sys

try:
    from vtkmodules.vtkIOParallel import vtkPOpenFOAMReader
    from vtkmodules.vtkParallelCore import vtkDummyController
    from vtkmodules.vtkIOXML import vtkXMLPPolyDataReader
except ImportError:
    sys.exit(77)


def clouds(block, name):
    for i in range(block.GetNumberOfBlocks()):
        child = block.GetBlock(i)
        if hasattr(child, "GetNumberOfBlocks"):
            yield from clouds(child, name)
        elif child and block.GetMetaData(i).Get(block.NAME()) == name:
            yield child


def show(pieces):
    points, ids = 0, 0
    for piece in pieces:
        points += piece.GetNumberOfPoints()
        array = piece.GetPointData().GetArray("origId")
        for p in range(piece.GetNumberOfPoints()):
            ids += int(array.GetTuple1(p))
    print(points, ids)


case, pvtp = sys.argv[1:]
reader = vtkPOpenFOAMReader()
reader.SetController(vtkDummyController())
reader.SetFileName(case)
reader.SkipZeroTimeOff()
reader.SetCaseType(vtkPOpenFOAMReader.DECOMPOSED_CASE)
reader.UpdateInformation()
for i in range(reader.GetNumberOfPatchArrays()):
    reader.SetPatchArrayStatus(reader.GetPatchArrayName(i), 1)
times = reader.GetTimeValues()
reader.UpdateTimeStep(times.GetValue(times.GetNumberOfValues() - 1))
show(clouds(reader.GetOutput(), "fluid"))

reader = vtkXMLPPolyDataReader()
reader.SetFileName(pvtp)
reader.Update()
show([reader.GetOutput()])
