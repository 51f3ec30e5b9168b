# SPDX-License-Identifier: BSD-3-Clause
"""cove: a shore with clear water: refraction, absorption, foam, glitter, shadows and caustics."""

import argparse
import math

from vtkmodules.vtkCommonCore import vtkMinimalStandardRandomSequence, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkStructuredGrid
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals
from vtkmodules.vtkFiltersGeometry import vtkGeometryFilter
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkCylinderSource, vtkSphereSource
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkLight,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
)
from vtkwater import vtkWaterActor
from vtkwater.errors import ending
from vtkwater.pictures import png_name, write_png

SIZE = 120.0  # m, half of the land's width
NEAR = -30.0  # where it begins, behind the eye


def add(renderer, source, color, position=(0.0, 0.0, 0.0), scale=(1.0, 1.0, 1.0), upright=False):
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.SetPosition(position)
    actor.SetScale(scale)
    if upright:  # VTK's cylinders lie along y
        actor.RotateX(90.0)
    actor.GetProperty().SetColor(color)
    actor.GetProperty().SetAmbient(0.3)
    actor.GetProperty().SetDiffuse(0.7)
    renderer.AddActor(actor)


def ground(x, y):
    """Height of the sand, m: a beach to the left that falls to 4 m under the water, and farther out to the deep."""
    beach = -0.16 * (x + 9.0 + 3.0 * math.sin(0.16 * y + 0.6))
    ripples = 0.03 * math.sin(2.1 * x + 0.7 * math.sin(1.3 * y))
    shelf = -4.0 - 0.012 * max(x - 14.0, 0.0) ** 2 - 0.012 * max(y - 20.0, 0.0) ** 2
    return max(min(beach, 0.3 * beach + 1.2), shelf) + ripples + 0.25 * math.sin(0.4 * x) * math.cos(0.33 * y)


def add_sand(renderer, steps=480):
    points = vtkPoints()
    for j in range(steps + 1):
        for i in range(steps + 1):
            x, y = SIZE * (2.0 * i / steps - 1.0), NEAR + 2.0 * SIZE * j / steps
            points.InsertNextPoint(x, y, ground(x, y))
    grid = vtkStructuredGrid()
    grid.SetDimensions(steps + 1, steps + 1, 1)
    grid.SetPoints(points)
    surface = vtkGeometryFilter()
    surface.SetInputData(grid)
    normals = vtkPolyDataNormals()
    normals.SetInputConnection(surface.GetOutputPort())
    add(renderer, normals, (0.86, 0.78, 0.60))


def add_rocks(renderer):
    random = vtkMinimalStandardRandomSequence()
    random.SetSeed(7)

    def roll(low, high):
        random.Next()
        return random.GetRangeValue(low, high)

    for _ in range(26):
        x, y, size = roll(-13.0, 8.0), roll(-9.0, 16.0), roll(0.25, 1.1)
        rock = vtkSphereSource()
        rock.SetRadius(size)
        rock.SetThetaResolution(11)
        rock.SetPhiResolution(7)
        shade = roll(0.25, 0.45)
        add(renderer, rock, (shade, 0.95 * shade, 0.88 * shade), (x, y, ground(x, y) + 0.2 * size),
            (roll(0.8, 1.5), roll(0.8, 1.4), roll(0.5, 0.9)))


def add_jetty(renderer):
    for i in range(8):
        for y in (5.0, 6.6):
            post = vtkCylinderSource()
            post.SetRadius(0.12)
            post.SetHeight(6.0)
            post.SetResolution(20)
            add(renderer, post, (0.33, 0.24, 0.16), (-9.0 + 1.8 * i, y, -1.9), upright=True)
    for i in range(32):
        plank = vtkCubeSource()
        plank.SetBounds(-10.2 + 0.46 * i, -9.8 + 0.46 * i, 4.7, 6.9, 1.05, 1.15)
        add(renderer, plank, (0.55 + 0.03 * (i % 3), 0.43, 0.29))


def add_ball(renderer, x, y, height):
    ball = vtkSphereSource()
    ball.SetRadius(0.45)
    ball.SetThetaResolution(48)
    ball.SetPhiResolution(48)
    add(renderer, ball, (0.90, 0.25, 0.10), (x, y, height + 0.15))


def make_water(time):
    water = vtkWaterActor()
    look = water.GetWaterProperty()
    look.SetPreset("clear tropical")
    look.SeaOff()  # waves of its own
    # down to 12 cm: near the eye a pixel shows a centimetre, and what glitters there has the shape of ripples
    for amplitude, wavelength, direction in ((0.035, 5.0, 165.0), (0.016, 2.3, 205.0), (0.010, 1.4, 130.0),
                                             (0.006, 0.9, 230.0), (0.003, 0.5, 170.0), (0.0011, 0.37, 120.0),
                                             (0.0008, 0.26, 215.0), (0.00055, 0.18, 160.0), (0.0004, 0.12, 250.0)):
        look.AddWave(amplitude, wavelength, direction)
    look.SetSlopeVariance(0.0003, 0.0003)
    look.SetFoamDepth(0.25)
    look.ShadowsOn()
    look.SetCaustics(0.5)
    water.SetSheetToHorizon()
    water.SetTime(time)
    return water


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("picture", nargs="?", default="cove.png", type=png_name, help="default: %(default)s")
    parser.add_argument("time", nargs="?", type=float, default=0.0, help="of the waves, s; default: %(default)s")
    parser.add_argument("eye", nargs="?", default="above", choices=("above", "below", "split"),
                        help="default: %(default)s; split: half above and half under water")
    arguments = parser.parse_args()
    picture, time, eye = arguments.picture, arguments.time, arguments.eye

    renderer = vtkRenderer()
    renderer.GradientBackgroundOn()
    renderer.SetBackground(0.78, 0.86, 0.92)
    renderer.SetBackground2(0.25, 0.47, 0.78)
    sun = vtkLight()
    sun.SetLightTypeToSceneLight()
    sun.SetPosition(6.0, 14.0, 12.0)
    renderer.AddLight(sun)
    water = make_water(time)
    renderer.AddActor(water)
    add_sand(renderer)
    add_rocks(renderer)
    add_jetty(renderer)
    add_ball(renderer, 1.5, 0.5, water.GetWaveHeight(1.5, 0.5))

    camera = renderer.GetActiveCamera()
    if eye == "split":
        look = water.GetWaterProperty()
        look.WaveGeometryOn()
        look.SetFoamDepth(0.08)
        look.SetDomePortRadius(0.3)
        height = water.GetWaveHeight(7.2, 2.4) + 0.03
        camera.SetPosition(7.2, 2.4, height)
        camera.SetFocalPoint(-3.0, 2.9, height + 0.1)
        camera.SetViewAngle(62.0)
    elif eye == "below":
        water.GetWaterProperty().SetLightShafts(0.6)
        camera.SetPosition(4.0, -7.0, -1.7)
        camera.SetFocalPoint(-1.0, 3.0, 1.2)  # up to Snell's window, which begins 41 degrees over the horizon
        camera.SetViewAngle(75.0)
    else:
        camera.SetPosition(1.0, -12.0, 4.2)
        camera.SetFocalPoint(-2.0, 1.0, 0.0)
        camera.SetViewAngle(48.0)
    camera.SetViewUp(0.0, 0.0, 1.0)
    camera.SetClippingRange(0.2, 200.0)
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(8)
    window.SetSize(960, 600)
    window.AddRenderer(renderer)

    write_png(window, picture)


if __name__ == "__main__":
    with ending("cove"):
        main()
