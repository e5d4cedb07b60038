# SPDX-License-Identifier: MIT
"""Compare refined images: compare_pieces.py [--within D] WHOLE PIECES.pvti ...

Equal means to the last bit, or with --within no farther from each other than D.

Every piece file of a .pvti is held against its part of the whole, and every point
must be covered.
"""
import os
import sys
import xml.etree.ElementTree as xml

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLImageDataReader


def image(path):
    reader = vtkXMLImageDataReader()
    reader.SetFileName(path)
    reader.Update()
    data = reader.GetOutput()
    if data.GetNumberOfPoints() == 0:
        sys.exit(f"{path}: no points")
    return data


def grid(data, name):
    e = data.GetExtent()
    return vtk_to_numpy(data.GetPointData().GetArray(name)).reshape(e[3] - e[2] + 1,
                                                                    e[1] - e[0] + 1)


def pieces(path):
    """The image files that make up a .vti or .pvti."""
    if path.endswith(".vti"):
        return [path]
    folder = os.path.dirname(path)
    root = xml.parse(path).getroot()
    return [os.path.join(folder, piece.get("Source")) for piece in root.iter("Piece")]


arguments = sys.argv[1:]
within = None
if arguments[0] == "--within":
    within = float(arguments[1])
    arguments = arguments[2:]
first = pieces(arguments[0])
if len(first) != 1:
    sys.exit(f"{arguments[0]} is in {len(first)} pieces; the whole must be one")
whole = image(first[0])
w = whole.GetExtent()
for path in arguments[1:]:
    files = pieces(path)
    for i in range(whole.GetPointData().GetNumberOfArrays()):
        name = whole.GetPointData().GetArrayName(i)
        expected = grid(whole, name)
        covered = numpy.zeros(expected.shape, bool)
        differing = 0
        for file in files:
            part = image(file)
            if (part.GetOrigin(), part.GetSpacing()) != (whole.GetOrigin(), whole.GetSpacing()):
                sys.exit(f"{file}: lies elsewhere")
            e = part.GetExtent()
            rows = slice(e[2] - w[2], e[3] - w[2] + 1)
            cols = slice(e[0] - w[0], e[1] - w[0] + 1)
            values = grid(part, name)
            if values.dtype != expected.dtype:
                sys.exit(f"{file}: {name} is {values.dtype}, not {expected.dtype}")
            wanted = numpy.ascontiguousarray(expected[rows, cols])
            if within is not None:
                differing += int((~(abs(values - wanted) <= within)).sum())
            elif values.tobytes() != wanted.tobytes():
                differing += int((values != wanted).sum()) or 1
            covered[rows, cols] = True
        print(f"{path}: {len(files)} pieces, {name}: {differing} of {expected.size} differ")
        if differing or not covered.all():
            sys.exit(1)
