#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A VTK pipeline in Python: a raster's heights, refined x8, written as .vti.

    PYTHONPATH=build/release/lib/python3/dist-packages /usr/bin/python3 examples/vtk_refine.py \
        IN.vti OUT.vti [SCHEME]
"""
import sys

from vtkmodules.vtkIOXML import vtkXMLImageDataReader, vtkXMLImageDataWriter
from aretevtk.AreteFilters import vtkAreteRefineImage

source, target = sys.argv[1:3]
heights = vtkXMLImageDataReader()
heights.SetFileName(source)

refine = vtkAreteRefineImage()
refine.SetInputConnection(heights.GetOutputPort())
refine.SetScheme(sys.argv[3] if len(sys.argv) > 3 else "gentle")
refine.SetLevels(3)

writer = vtkXMLImageDataWriter()
writer.SetInputConnection(refine.GetOutputPort())
writer.SetFileName(target)
writer.SetDataModeToAppended()
writer.EncodeAppendedDataOff()
writer.SetCompressorTypeToNone()  # the default, zlib, is 50 times slower for a seventh of the size
writer.SetHeaderTypeToUInt64()
writer.SetNumberOfPieces(16)  # streams: only a piece of the result is in memory at a time
if writer.Write() != 1:
    sys.exit(1)
