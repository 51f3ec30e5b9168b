#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""lake: floods a real elevation model, renders it off-screen and prints what was reflected.

The same picture as Examples/Cxx/Lake. Flow: read -> refine -> colour and tile -> flood -> render.
"""

import argparse
import math
import statistics
import sys
import time
from pathlib import Path

from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersCore import (
    vtkArrayCalculator,
    vtkAssignAttribute,
    vtkPolyDataNormals,
    vtkTriangleFilter,
)
from vtkmodules.vtkFiltersGeneral import vtkWarpScalar
from vtkmodules.vtkFiltersGeometry import vtkImageDataGeometryFilter
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOXML import vtkXMLImageDataReader
from vtkmodules.vtkImagingCore import vtkExtractVOI, vtkImageCast, vtkImageResample
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkColorTransferFunction,
    vtkLight,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
    vtkWindowToImageFilter,
)

import vtkwater

DEFAULT_FILE = Path(__file__).resolve().parents[1] / "Data" / "jacksboro.vti"
DEFAULT_LEVEL = 384.0  # metres
EXAGGERATION = 2.0  # heights are drawn this many times higher than they are
REFINEMENT = 2  # points drawn per point of the elevation model, along each axis
TILES = 4  # the terrain is drawn in TILES x TILES props, so that those out of view cost nothing
SIZE = (1280, 720)
SAMPLES = 8
FRAMES = 3  # timed, of each kind

# The camera stands over the lake: fractions of the map's extent, east and north, and metres drawn.
EYE = (0.831, 0.233)
TARGET = (0.530, 0.122)
EYE_HEIGHT = 150.0  # above the water, or above the ground where that is higher
TARGET_HEIGHT = 200.0  # above the water
VIEW_ANGLE_DEG = 32.0
SUN_AZIMUTH_DEG, SUN_ELEVATION_DEG = 120.0, 24.0

# Ground colours by height in metres; steep ground counts as up to STEEPNESS metres higher, which
# brings the rock out. Sand, meadow, forest, grass, rock, snow.
STEEPNESS = 500.0
COLORS = (
    (200.0, 0.40, 0.36, 0.27),
    (398.0, 0.42, 0.38, 0.28),
    (412.0, 0.30, 0.34, 0.19),
    (600.0, 0.25, 0.32, 0.18),
    (750.0, 0.31, 0.32, 0.19),
    (880.0, 0.45, 0.41, 0.34),
    (1000.0, 0.66, 0.64, 0.61),
    (1100.0, 0.90, 0.90, 0.91),
)
SKY_AT_BOTTOM, SKY_AT_TOP = (1.00, 0.97, 0.90), (0.24, 0.46, 0.74)


def read_elevation(file):
    """The elevation model, heights in metres; ends the program when there is none."""
    if Path(file).is_dir():
        raise SystemExit(f"lake: {file}: is a folder, not a file; the folder for the picture comes second")
    if Path(file).suffix.lower() in (".png", ".jpg", ".jpeg"):
        raise SystemExit(f"lake: {file}: the first argument is an elevation model (.vti), the second the folder for lake.png")
    if not Path(file).is_file():
        raise SystemExit(f"lake: {file}: no such file")
    reader = vtkXMLImageDataReader()
    if not reader.CanReadFile(str(file)):
        raise SystemExit(f"lake: {file}: not a VTK image (.vti)")
    reader.SetFileName(str(file))
    reader.Update()
    image = reader.GetOutput()
    if image.GetNumberOfPoints() < 4 or not image.GetPointData().GetScalars():
        raise SystemExit(f"lake: {file}: holds no elevations")
    return image


def refine(elevation):
    """The same heights on a finer grid, smoothly, with the normals and colours of the ground."""
    cast = vtkImageCast()
    cast.SetOutputScalarTypeToFloat()
    cast.SetInputData(elevation)
    resample = vtkImageResample()
    resample.SetInputConnection(cast.GetOutputPort())
    resample.SetInterpolationModeToCubic()
    resample.SetAxisMagnificationFactor(0, REFINEMENT)
    resample.SetAxisMagnificationFactor(1, REFINEMENT)

    surface = surface_of(resample)
    normals = vtkPolyDataNormals()
    normals.SetInputConnection(surface.GetOutputPort())
    normals.SplittingOff()  # keeps the points, and their order
    cover = vtkArrayCalculator()
    cover.SetInputConnection(normals.GetOutputPort())
    cover.AddCoordinateScalarVariable("z", 2)
    cover.AddScalarVariable("up", "Normals", 2)
    cover.SetFunction(f"z / {EXAGGERATION:f} + {STEEPNESS:f} * (1 - up)")
    cover.SetResultArrayName("cover")
    cover.Update()

    image = vtkImageData()
    image.ShallowCopy(resample.GetOutput())
    for name in ("Normals", "cover"):
        image.GetPointData().AddArray(cover.GetOutput().GetPointData().GetArray(name))
    return image


def surface_of(source):
    """Triangles over the heights that the filter source yields."""
    geometry = vtkImageDataGeometryFilter()
    geometry.SetInputConnection(source.GetOutputPort())
    warp = vtkWarpScalar()
    warp.SetInputConnection(geometry.GetOutputPort())
    warp.SetNormal(0.0, 0.0, 1.0)
    warp.UseNormalOn()  # this one, not the ground's
    warp.SetScaleFactor(EXAGGERATION)
    triangles = vtkTriangleFilter()
    triangles.SetInputConnection(warp.GetOutputPort())
    return triangles


def make_terrain(image):
    """The ground: an actor a tile."""
    colors = vtkColorTransferFunction()
    for stop in COLORS:
        colors.AddRGBPoint(*stop)
    width, height, _ = image.GetDimensions()
    actors = []
    for row in range(TILES):
        for column in range(TILES):
            tile = vtkExtractVOI()
            tile.SetInputData(image)
            tile.SetVOI(
                (width - 1) * column // TILES,
                (width - 1) * (column + 1) // TILES,
                (height - 1) * row // TILES,
                (height - 1) * (row + 1) // TILES,
                0,
                0,
            )
            surface = surface_of(tile)
            shading = vtkAssignAttribute()  # warping does not keep normals as such
            shading.SetInputConnection(surface.GetOutputPort())
            shading.Assign("Normals", "NORMALS", "POINT_DATA")
            mapper = vtkPolyDataMapper()
            mapper.SetInputConnection(shading.GetOutputPort())
            mapper.SetScalarModeToUsePointFieldData()
            mapper.SelectColorArray("cover")
            mapper.SetLookupTable(colors)
            mapper.UseLookupTableScalarRangeOn()
            actor = vtkActor()
            actor.SetMapper(mapper)
            actor.GetProperty().SetAmbient(0.25)
            actor.GetProperty().SetDiffuse(1.0)
            actors.append(actor)
    return actors


def make_sun():
    azimuth, elevation = math.radians(SUN_AZIMUTH_DEG), math.radians(SUN_ELEVATION_DEG)
    sun = vtkLight()
    sun.SetLightTypeToSceneLight()
    sun.SetPosition(
        math.sin(azimuth) * math.cos(elevation),
        math.cos(azimuth) * math.cos(elevation),
        math.sin(elevation),
    )
    sun.SetFocalPoint(0.0, 0.0, 0.0)
    sun.SetColor(1.0, 0.95, 0.86)
    return sun


def place_camera(renderer, elevation, level):
    def at(fraction):
        bounds = elevation.GetBounds()
        return (
            bounds[0] + fraction[0] * (bounds[1] - bounds[0]),
            bounds[2] + fraction[1] * (bounds[3] - bounds[2]),
        )

    eye, target = at(EYE), at(TARGET)
    ground = elevation.GetPointData().GetScalars().GetTuple1(
        elevation.FindPoint(eye[0], eye[1], elevation.GetOrigin()[2])
    )
    camera = renderer.GetActiveCamera()
    camera.SetPosition(*eye, EXAGGERATION * max(level, ground) + EYE_HEIGHT)
    camera.SetFocalPoint(*target, EXAGGERATION * level + TARGET_HEIGHT)
    camera.SetViewUp(0.0, 0.0, 1.0)
    camera.SetViewAngle(VIEW_ANGLE_DEG)
    renderer.ResetCameraClippingRange()
    # VTK's choice for such a wide scene would cut the nearest water away.
    camera.SetClippingRange(0.25 * EYE_HEIGHT, camera.GetClippingRange()[1])


def frame_ms(window):
    """Median time of a frame in milliseconds; the first, which sets things up, does not count."""
    times = []
    for _ in range(FRAMES + 1):
        start = time.perf_counter()
        window.Render()
        window.WaitForCompletion()
        times.append(1000.0 * (time.perf_counter() - start))
    return statistics.median(times[1:])


def write_png(window, file):
    capture = vtkWindowToImageFilter()
    capture.SetInput(window)
    capture.ReadFrontBufferOff()
    capture.ShouldRerenderOff()
    writer = vtkPNGWriter()
    writer.SetFileName(str(file))
    writer.SetInputConnection(capture.GetOutputPort())
    writer.Write()
    if writer.GetErrorCode() or not file.is_file():
        raise SystemExit(f"lake: {file}: cannot write")


def describe_fates(reflection):
    """What was reflected and what was left out, with the reasons."""
    fates = [
        f"{reflection.GetFateCount(fate)} {reflection.GetFateAsString(fate)}"
        for fate in range(reflection.NUMBER_OF_FATES)
        if reflection.GetFateCount(fate)
    ]
    return ", ".join(fates) or "none"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("elevation", nargs="?", default=DEFAULT_FILE,
                        help="elevation model, a .vti file with heights in metres (%(default)s)")
    parser.add_argument("folder", nargs="?", default=".", type=Path,
                        help="where lake.png goes; made when missing (%(default)s)")
    parser.add_argument("level", nargs="?", default=DEFAULT_LEVEL, type=float,
                        help="water level in metres (%(default)s)")
    arguments = parser.parse_args()

    elevation = read_elevation(arguments.elevation)
    lowest, highest = elevation.GetScalarRange()
    level = arguments.level
    if not lowest < level < highest:
        raise SystemExit(f"lake: level {level:g} m is outside the terrain, "
                         f"which reaches from {lowest:g} to {highest:g} m")
    try:
        arguments.folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise SystemExit(f"lake: {arguments.folder}: {error.strerror}") from None

    renderer = vtkRenderer()
    renderer.SetBackground(SKY_AT_BOTTOM)
    renderer.SetBackground2(SKY_AT_TOP)
    renderer.GradientBackgroundOn()
    renderer.AutomaticLightCreationOff()
    renderer.AddLight(make_sun())
    terrain = make_terrain(refine(elevation))
    for actor in terrain:
        renderer.AddActor(actor)

    water = vtkwater.vtkWaterActor()
    water.SetLevel(EXAGGERATION * level)
    renderer.AddActor(water)
    place_camera(renderer, elevation, level)

    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(SAMPLES)
    window.SetSize(SIZE)
    window.AddRenderer(renderer)

    water.VisibilityOff()
    plain_ms = frame_ms(window)
    water.VisibilityOn()
    water_ms = frame_ms(window)
    picture = arguments.folder / "lake.png"
    write_png(window, picture)

    reflection = water.GetReflectionPass()
    width, height, _ = elevation.GetDimensions()
    print(f"terrain     {arguments.elevation}: {width} x {height} points, {lowest:g} to {highest:g} m, "
          f"drawn {EXAGGERATION:g} times higher, in {len(terrain)} tiles")
    print(f"water       level {level:g} m")
    print(f"props       {describe_fates(reflection)}")
    print(f"reflection  {reflection.GetDecisionAsString()}, "
          f"{reflection.GetNumberOfReflectionRenders()} times in {FRAMES + 1} frames")
    print(f"frame       {plain_ms:.0f} ms plain, {water_ms:.0f} ms with water (medians of {FRAMES})")
    print(f"picture     {picture} ({SIZE[0]} x {SIZE[1]})")
    if water.GetLastError():
        raise SystemExit(f"lake: {water.GetLastError()}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
