# SPDX-License-Identifier: MIT
"""A picture of the terrain shows terrain: picture_test.py PNG. Pixels are not compared with a stored
picture, since drivers differ in some; the surface must fill the middle, in many shades."""
import sys

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

reader = vtkPNGReader()
reader.SetFileName(sys.argv[1])
reader.Update()
width, height, _ = reader.GetOutput().GetDimensions()
assert width >= 600 and height >= 400, (width, height)
pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).reshape(height, width, -1)
background = pixels[-2, 2, :3]
surface = (pixels[:, :, :3] != background).any(axis=2)
assert 0.2 < surface.mean() < 0.95, surface.mean()
middle = pixels[height // 3:2 * height // 3, width // 3:2 * width // 3, :3].reshape(-1, 3)
shades = len({tuple(pixel) for pixel in middle.tolist()})
assert shades > 1000, shades
print(f"{width} x {height}, {100 * surface.mean():.0f} % surface, {shades} shades in the middle")
