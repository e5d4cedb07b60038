# SPDX-License-Identifier: MIT
"""Refine a raster in pieces, on any number of ranks, with ParaView and arete's plugin.

    mpiexec -n 4 pvbatch --sym examples/paraview_refine.py IN OUT [--scheme TEXT] [--levels N]
            [--boundary RULE] [--picture PNG] [--plugin FILE]

IN is a .vti or .pvti (arete refine --levels 0 IN.tif OUT.vti makes one of any raster); OUT is a .vti
(one rank) or a .pvti with one .vti a rank beside it. The numbers are the same to the last bit on any
number of ranks. Without --sym only rank 0 would run this script, which is the same to the result.
"""
import argparse
import os
import sys

from paraview import servermanager
from paraview.simple import (
    ColorBy, CreateView, GetActiveSource, GetColorTransferFunction, LoadPlugin, Render, SaveData,
    SaveScreenshot, Show, UpdatePipeline, XMLImageDataReader, XMLPartitionedImageDataReader)

BOUNDARIES = ("extrapolate", "clamp", "reflect", "periodic", "none")


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("input")
    parser.add_argument("output")
    parser.add_argument("--scheme", default="gentle", help="text form, as 'arete schemes' explains")
    parser.add_argument("--levels", type=int, default=2)
    parser.add_argument("--boundary", choices=BOUNDARIES, default="extrapolate")
    parser.add_argument("--picture", help="a PNG of the surface (needs a display: xvfb-run)")
    parser.add_argument("--exaggerate", type=float, default=2.0)
    parser.add_argument("--plugin", default=os.environ.get("ARETE_PARAVIEW_PLUGIN"),
                        help="AretePlugin.so (default: $ARETE_PARAVIEW_PLUGIN)")
    return parser.parse_args()


def heights_in(path):
    if not os.path.exists(path):
        sys.exit(f"{path}: there is no such file")
    if path.endswith(".pvti"):
        return XMLPartitionedImageDataReader(FileName=[path])
    return XMLImageDataReader(FileName=[path])


def picture(surface, array, path):
    view = CreateView("RenderView")
    view.ViewSize = [1000, 700]
    view.OrientationAxesVisibility = 0
    shown = Show(surface, view)
    ColorBy(shown, ("POINTS", array))
    colors = GetColorTransferFunction(array)
    colors.ApplyPreset("gist_earth", True)
    low, high = surface.PointData[array].GetRange()
    colors.RescaleTransferFunction(low, high)
    x0, x1, y0, y1, z0, z1 = surface.GetDataInformation().GetBounds()
    # The first picture of a view brings a camera of its own, so ours comes after it.
    Render(view)
    middle = [(x0 + x1) / 2, (y0 + y1) / 2, (z0 + z1) / 2]
    reach = max(x1 - x0, y1 - y0)
    view.CameraFocalPoint = middle
    view.CameraPosition = [middle[0], middle[1] - 0.75 * reach, middle[2] + 0.62 * reach]
    view.CameraViewUp = [0, 0, 1]
    Render(view)
    SaveScreenshot(path, view)


def main():
    a = arguments()
    if not a.plugin:
        sys.exit("give --plugin FILE or set ARETE_PARAVIEW_PLUGIN to the built AretePlugin.so")
    LoadPlugin(a.plugin, remote=False, ns=globals())
    ranks = servermanager.vtkProcessModule.GetProcessModule().GetNumberOfLocalPartitions()

    heights = heights_in(a.input)
    refined = AreteRefineImage(Input=heights)  # noqa: F821 (the plugin brings it)
    refined.Scheme = "text form"
    refined.Scheme.Text = a.scheme
    refined.Levels = a.levels
    refined.BoundaryX = refined.BoundaryY = a.boundary.capitalize()
    refined.Threads = 1 if ranks > 1 else 0
    SaveData(a.output, proxy=refined, DataMode="Appended", EncodeAppendedData=0,
             CompressorType="None")
    if a.picture:
        surface = AreteSurface(Input=refined)  # noqa: F821
        surface.Scheme = "text form"
        surface.Scheme.Text = a.scheme
        surface.ScaleFactor = a.exaggerate
        picture(surface, "height", a.picture)


main()
