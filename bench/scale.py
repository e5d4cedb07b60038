#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""How time and memory of refinement grow with size, pieces and ranks; prints Markdown.

    bench/scale.py [BUILD [FOLDER]]      (default build/release and a temporary folder)

Every run writes raw .vti pieces. Memory is the largest resident set of any rank; seconds are wall
time with start-up of the ranks, the smaller of two runs.
"""
import datetime
import os
import platform
import subprocess
import sys
import tempfile

build = os.path.realpath(sys.argv[1] if len(sys.argv) > 1 else "build/release")
root = os.path.realpath(os.path.join(os.path.dirname(__file__), ".."))
SCHEME = "gentle"
COARSE = (403, 344)


def run(command, folder):
    """Seconds and megabytes of a command, measured in a process of its own."""
    code = ("import resource, subprocess, sys, time; t = time.time(); "
            "subprocess.run(sys.argv[1:], check=True, stdout=subprocess.DEVNULL, timeout=600); "
            "print(time.time() - t, resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024)")
    out = subprocess.run([sys.executable, "-c", code, *command], cwd=folder, check=True,
                         capture_output=True, text=True).stdout.split()
    return float(out[-2]), float(out[-1])


def best(command, folder):
    runs = [run(command, folder) for _ in range(2)]
    return min(r[0] for r in runs), max(r[1] for r in runs)


def ranks(n, levels):
    return ["mpiexec", "--allow-run-as-root", "--oversubscribe", "-n", str(n),
            f"{build}/bin/example_vtk_refine_mpi", "dem.vti", "out.pvti", SCHEME, str(levels)]


def size(levels):
    return tuple((n - 1) * 2 ** levels + 1 for n in COARSE)


def machine():
    with open("/proc/cpuinfo") as file:
        model = next(line.split(":")[1].strip() for line in file if line.startswith("model name"))
    return f"{model}, {os.cpu_count()} cores, load {os.getloadavg()[0]:.1f}"


def main(folder):
    subprocess.run([f"{build}/bin/arete", "refine", f"{root}/data/jacksboro_srtm3.tif", "dem.vti",
                    "--scheme", SCHEME, "--levels", "0", "--overwrite"], cwd=folder, check=True,
                   stdout=subprocess.DEVNULL)
    print(f"{datetime.date.today()}, {machine()}, {platform.system()}; `bench/scale.py`\n")
    print("| levels | result | MB | ranks | seconds | Msamples/s | MB of a rank |")
    print("|---|---|---|---|---|---|---|")
    for levels in (3, 4, 5):
        cols, rows = size(levels)
        for n in (1, 2, 4):
            seconds, memory = best(ranks(n, levels), folder)
            print(f"| {levels} | {cols} x {rows} | {cols * rows * 4 / 1e6:.0f} | {n} | "
                  f"{seconds:.1f} | {cols * rows / seconds / 1e6:.0f} | {memory:.0f} |", flush=True)
    print("\nStreamed by one process, `SetNumberOfPieces` (examples/vtk_refine.py's way):\n")
    print("| pieces | seconds | MB |\n|---|---|---|")
    for pieces in (1, 4, 16, 64):
        command = ["/usr/bin/python3", "-c", STREAM, str(pieces)]
        seconds, memory = best(command, folder)
        print(f"| {pieces} | {seconds:.1f} | {memory:.0f} |", flush=True)


STREAM = f"""
import sys
sys.path.insert(0, "{build}/lib/python3/dist-packages")
from vtkmodules.vtkIOXML import vtkXMLImageDataReader, vtkXMLImageDataWriter
from aretevtk.AreteFilters import vtkAreteRefineImage
heights = vtkXMLImageDataReader()
heights.SetFileName("dem.vti")
refine = vtkAreteRefineImage()
refine.SetInputConnection(heights.GetOutputPort())
refine.SetScheme("{SCHEME}")
refine.SetLevels(5)
writer = vtkXMLImageDataWriter()
writer.SetInputConnection(refine.GetOutputPort())
writer.SetFileName("streamed.vti")
writer.SetDataModeToAppended()
writer.EncodeAppendedDataOff()
writer.SetCompressorTypeToNone()
writer.SetHeaderTypeToUInt64()
writer.SetNumberOfPieces(int(sys.argv[1]))
sys.exit(0 if writer.Write() else 1)
"""

if len(sys.argv) > 2:
    main(sys.argv[2])
else:
    with tempfile.TemporaryDirectory() as temporary:
        main(temporary)
