# SPDX-License-Identifier: MIT
"""The wrapped filters: classes, setters, errors, an exact value. Run with PYTHONPATH set."""
import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from aretevtk.AreteFilters import (
    vtkAreteCoarsen, vtkAreteFilter, vtkAreteRefineGrid, vtkAreteRefineImage, vtkAreteRestore,
    vtkAreteScheme, vtkAreteSurface)

image = vtkImageData()
image.SetDimensions(6, 5, 1)
heights = numpy.arange(30, dtype=numpy.float64) ** 2 / 8
array = numpy_to_vtk(heights, deep=True)
array.SetName("height")
image.GetPointData().SetScalars(array)

refine = vtkAreteRefineImage()
refine.SetInputData(image)
refine.SetScheme("four-point")
refine.SetLevels(1)
refine.SetBoundary(vtkAreteFilter.EXTRAPOLATE)
refine.Update()
fine = vtk_to_numpy(refine.GetOutput().GetPointData().GetScalars()).reshape(9, 11)
coarse = heights.reshape(5, 6)
assert (fine[::2, ::2] == coarse).all(), "four-point interpolates"
between = (-coarse[2, 1] + 9 * coarse[2, 2] + 9 * coarse[2, 3] - coarse[2, 4]) / 16
assert fine[4, 5] == between

scheme = vtkAreteScheme()
families = {vtkAreteScheme.GetFamilyName(i) for i in range(vtkAreteScheme.GetNumberOfFamilies())}
assert {"gentle", "craggy", "b-spline"} <= families
scheme.SetFamily("b-spline")
scheme.SetParameter("degree", 3)
assert scheme.GetText() == "b-spline:degree=3"
refine.SetSchemeObject(scheme)
refine.Update()
assert not (vtk_to_numpy(refine.GetOutput().GetPointData().GetScalars()).reshape(9, 11)[::2, ::2]
            == coarse).all()

messages = []
refine.SetSchemeObject(None)
refine.SetScheme("gentel")


def remember(caller, event, text):
    messages.append(text)


remember.CallDataType = "string0"
refine.AddObserver("ErrorEvent", remember)
refine.GetExecutive().AddObserver("ErrorEvent", remember)
refine.Update()
assert any("gentle" in message for message in messages), messages

surface = vtkAreteSurface()
surface.SetInputData(image)
surface.Update()
assert surface.GetOutput().GetNumberOfCells() == 20
assert surface.GetOutput().GetPointData().GetNormals() is not None

grid = vtkAreteRefineGrid()
grid.SetInputConnection(surface.GetOutputPort())
grid.Update()
assert grid.GetOutput().GetNumberOfPoints() == 99

coarsen = vtkAreteCoarsen()
coarsen.SetInputData(image)
coarsen.SetScheme("chaikin")
restore = vtkAreteRestore()
restore.SetInputConnection(coarsen.GetOutputPort())
restore.Update()
back = vtk_to_numpy(restore.GetOutput().GetPointData().GetArray("height"))
assert abs(back - heights).max() < 1e-10
print("all right")
