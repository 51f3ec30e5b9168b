# SPDX-License-Identifier: BSD-3-Clause
"""waves: a pier and buoys that float on waves."""

import argparse

from vtkmodules.vtkFiltersSources import (
    vtkConeSource,
    vtkCubeSource,
    vtkCylinderSource,
    vtkSphereSource,
)
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

# amplitude (m), wavelength (m), direction (degrees)
WAVES = ((0.030, 4.1, 20.0), (0.016, 2.3, 55.0), (0.009, 1.3, -15.0), (0.005, 0.8, 80.0), (0.003, 0.5, 35.0))
BUOYS = ((-2.4, 1.0), (0.3, -1.6), (2.6, 3.2))


def add(renderer, source, color, position=(0.0, 0.0, 0.0), upright=False):
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.SetPosition(position)
    if upright:  # VTK's cylinders lie along y
        actor.RotateX(90.0)
    actor.GetProperty().SetColor(color)
    actor.GetProperty().SetAmbient(0.25)
    actor.GetProperty().SetDiffuse(0.75)
    renderer.AddActor(actor)


def add_cylinder(renderer, radius, low, high, x, y, color):
    source = vtkCylinderSource()
    source.SetRadius(radius)
    source.SetHeight(high - low)
    source.SetResolution(32)
    add(renderer, source, color, (x, y, 0.5 * (low + high)), upright=True)


def add_pier(renderer):
    for x in range(-5, 0, 2):
        for y in (4.0, 6.0):
            add_cylinder(renderer, 0.14, -2.0, 1.3, x, y, (0.36, 0.26, 0.18))
    for i in range(13):
        plank = vtkCubeSource()
        plank.SetBounds(-6.3 + 0.45 * i, -5.9 + 0.45 * i, 3.6, 6.4, 1.0, 1.1)
        add(renderer, plank, (0.55 + 0.03 * (i % 3), 0.42, 0.28))


def add_lighthouse(renderer, x, y):
    for i in range(5):
        color = (0.80, 0.15, 0.12) if i % 2 else (0.93, 0.93, 0.90)
        add_cylinder(renderer, 0.75 - 0.05 * i, -0.5 + 1.1 * i, 0.6 + 1.1 * i, x, y, color)
    roof = vtkConeSource()
    roof.SetDirection(0.0, 0.0, 1.0)
    roof.SetRadius(0.7)
    roof.SetHeight(0.8)
    roof.SetResolution(32)
    add(renderer, roof, (0.25, 0.25, 0.28), (x, y, 5.4))


def add_buoy(renderer, x, y, height):
    float_ = vtkSphereSource()
    float_.SetRadius(0.35)
    float_.SetThetaResolution(48)
    float_.SetPhiResolution(48)
    add(renderer, float_, (0.90, 0.45, 0.05), (x, y, height + 0.05))
    add_cylinder(renderer, 0.04, height + 0.3, height + 1.0, x, y, (0.15, 0.15, 0.15))


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("picture", nargs="?", default="waves.png", type=png_name, help="default: %(default)s")
    parser.add_argument("time", nargs="?", type=float, default=0.0, help="of the waves, s; default: %(default)s")
    arguments = parser.parse_args()
    picture, time = arguments.picture, arguments.time

    water = vtkWaterActor()
    for amplitude, wavelength, direction in WAVES:
        water.GetWaterProperty().AddWave(amplitude, wavelength, direction)
    water.SetSheetBounds(-400.0, 400.0, -400.0, 400.0)
    water.SetTime(time)

    renderer = vtkRenderer()
    renderer.GradientBackgroundOn()
    renderer.SetBackground(0.80, 0.86, 0.90)
    renderer.SetBackground2(0.30, 0.50, 0.78)
    sun = vtkLight()
    sun.SetLightTypeToSceneLight()
    sun.SetPosition(-6.0, -8.0, 9.0)
    renderer.AddLight(sun)
    renderer.AddActor(water)
    add_pier(renderer)
    add_lighthouse(renderer, 3.2, 8.0)
    for x, y in BUOYS:
        add_buoy(renderer, x, y, water.GetWaveHeight(x, y))

    camera = renderer.GetActiveCamera()
    camera.SetPosition(0.6, -8.5, 1.7)
    camera.SetFocalPoint(0.0, 2.0, 0.7)
    camera.SetViewUp(0.0, 0.0, 1.0)
    camera.SetViewAngle(40.0)
    camera.SetClippingRange(0.5, 1000.0)
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(8)
    window.SetSize(960, 600)
    window.AddRenderer(renderer)

    write_png(window, picture)


if __name__ == "__main__":
    with ending("waves"):
        main()
