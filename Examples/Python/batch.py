# SPDX-License-Identifier: BSD-3-Clause
"""batch: a picture of every file of a time series of VTK files, in water; from the command line.

    batch.py --out pictures run/step_*.vtp
    batch.py --out pictures --make 12        first writes a series of its own: a barge that heaves in a swell

A file's time is its field "TimeValue" (s), as ParaView writes it, else its number. The camera is that of the first
file. Files that cannot be read are named and left out; Ctrl-C stops and keeps the pictures that are done.
"""

import argparse
import math
import pathlib
import sys

from vtkmodules.vtkCommonCore import vtkDoubleArray
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersCore import vtkAppendPolyData
from vtkmodules.vtkFiltersGeneral import vtkTransformPolyDataFilter
from vtkmodules.vtkFiltersSources import vtkCubeSource
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter
from vtkwater import movies, vtkWaterActor
from vtkwater.errors import ending
from vtkwater.readers import FileError, read
from vtkwater.scenes import Scene

try:
    from tqdm import tqdm
except ImportError:  # without a bar
    tqdm = iter

SWELL = ((0.5, 40.0, 20.0), (0.2, 19.0, -30.0))  # m, m, degrees
STEP_S = 0.5


def add_swell(water):
    for wave in SWELL:
        water.GetWaterProperty().AddWave(*wave)


def make_series(folder, count):
    """Writes step_000.vtp and so on; returns their names."""
    barge = vtkAppendPolyData()
    for bounds in ((-9, 9, -3.5, 3.5, -1.2, 1.4), (-8, -4, -2.5, 2.5, 1.4, 4.5), (2, 2.6, -0.3, 0.3, 1.4, 9.0)):
        box = vtkCubeSource()
        box.SetBounds(bounds)
        barge.AddInputConnection(box.GetOutputPort())
    water = vtkWaterActor()
    add_swell(water)
    files = []
    for i in range(count):
        water.SetTime(STEP_S * i)
        heights = [water.GetWaveHeight(x, 0.0) for x in (-9.0, 0.0, 9.0)]
        transform = vtkTransform()
        transform.Translate(0.0, 0.0, sum(heights) / 3.0)
        transform.RotateY(-math.degrees(math.atan2(heights[2] - heights[0], 18.0)))
        moved = vtkTransformPolyDataFilter()
        moved.SetTransform(transform)
        moved.SetInputConnection(barge.GetOutputPort())
        moved.Update()
        time = vtkDoubleArray()
        time.SetName("TimeValue")
        time.InsertNextValue(STEP_S * i)
        moved.GetOutput().GetFieldData().AddArray(time)
        files.append(folder / f"step_{i:03d}.vtp")
        writer = vtkXMLPolyDataWriter()
        writer.SetFileName(str(files[-1]))
        writer.SetInputData(moved.GetOutput())
        writer.Write()
    return files


def render(files, folder, is_stopped):
    """A picture for each file; returns how many, and how many files were left out."""
    done = failed = 0
    scene = None
    for i, file in enumerate(tqdm(files)):
        if is_stopped():
            break
        try:
            surface = read(file)
        except FileError as error:
            print(f"batch: {error}", file=sys.stderr)
            failed += 1
            continue
        if scene is None:
            scene = Scene((800, 500))
            ground = scene.add_ground(surface, 0.0)
            add_swell(scene.add_water(0.0))
            scene.water.SetSheetToHorizon()
            scene.look(azimuth=215.0, height=14.0)
        ground.GetMapper().SetInputData(surface.data)
        time = surface.data.GetFieldData().GetArray("TimeValue")
        scene.water.SetTime(time.GetTuple1(0) if time else float(i))
        scene.write(folder / f"{pathlib.Path(file).stem}.png")
        done += 1
    return done, failed


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("files", nargs="*", help=".vtp, .vtu, .stl and others, in the order of time")
    parser.add_argument("--out", type=pathlib.Path, default="pictures", help="a folder; default: %(default)s")
    parser.add_argument("--make", type=int, metavar="N", help="a series of N files to try it with")
    arguments = parser.parse_args()
    if bool(arguments.files) == bool(arguments.make):
        parser.error("give FILES or --make N")

    arguments.out.mkdir(parents=True, exist_ok=True)
    files = arguments.files or make_series(arguments.out, arguments.make)
    with movies.interrupts() as is_stopped:
        done, failed = render(files, arguments.out, is_stopped)
    print(f"{arguments.out}: {done} pictures of {len(files)} files")
    return 130 if is_stopped() else 1 if failed else 0


if __name__ == "__main__":
    with ending("batch"):
        sys.exit(main())
