# SPDX-License-Identifier: BSD-3-Clause
"""swell: a beacon, a buoy and a raft in waves that are displaced."""

import argparse
import math

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

# amplitude (m), wavelength (m), direction (degrees), phase (degrees), steepness
WAVES = (
    (0.42, 19.0, 75.0, 0.0, 0.8),
    (0.16, 9.0, 110.0, 40.0, 0.8),
    (0.07, 4.7, 50.0, 0.0, 0.6),
    (0.025, 2.1, 95.0, 0.0, 0.5),
    (0.010, 1.1, 20.0, 0.0, 0.0),
    (0.005, 0.6, 130.0, 0.0, 0.0),
)


def add(renderer, source, color):
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(color)
    actor.GetProperty().SetAmbient(0.3)
    actor.GetProperty().SetDiffuse(0.7)
    renderer.AddActor(actor)
    return actor


def add_cylinder(renderer, radius, low, high, x, y, color):
    source = vtkCylinderSource()
    source.SetRadius(radius)
    source.SetHeight(high - low)
    source.SetResolution(48)
    actor = add(renderer, source, color)
    actor.SetPosition(x, y, 0.5 * (low + high))
    actor.RotateX(90.0)  # VTK's cylinders lie along y


def add_beacon(renderer, x, y):
    add_cylinder(renderer, 0.55, -4.0, 1.6, x, y, (0.45, 0.46, 0.47))
    for i in range(4):
        color = (0.93, 0.93, 0.90) if i % 2 else (0.80, 0.15, 0.12)
        add_cylinder(renderer, 0.38, 1.6 + 0.9 * i, 2.5 + 0.9 * i, x, y, color)
    roof = vtkConeSource()
    roof.SetDirection(0.0, 0.0, 1.0)
    roof.SetRadius(0.55)
    roof.SetHeight(0.7)
    roof.SetResolution(48)
    add(renderer, roof, (0.25, 0.25, 0.28)).SetPosition(x, y, 5.55)


def float_on(actor, water, x, y, lift):
    """Puts an actor onto the waves, upright to them."""
    normal = [0.0, 0.0, 0.0]
    water.GetWaveNormal(x, y, normal)
    actor.SetPosition(x, y, water.GetWaveHeight(x, y) + lift)
    actor.RotateY(math.degrees(math.atan2(normal[0], normal[2])))
    actor.RotateX(math.degrees(math.asin(-normal[1])))


def add_buoy(renderer, water, x, y):
    source = vtkSphereSource()
    source.SetRadius(0.5)
    source.SetThetaResolution(64)
    source.SetPhiResolution(64)
    float_on(add(renderer, source, (0.92, 0.50, 0.05)), water, x, y, 0.1)


def add_raft(renderer, water, x, y):
    for bounds, color in (
        ((-1.6, 1.6, -0.9, 0.9, -0.25, 0.2), (0.50, 0.34, 0.20)),
        ((-0.6, 0.6, -0.5, 0.5, 0.2, 1.1), (0.88, 0.86, 0.78)),
        ((-0.7, 0.7, -0.6, 0.6, 1.1, 1.2), (0.20, 0.32, 0.45)),
    ):
        source = vtkCubeSource()
        source.SetBounds(bounds)
        float_on(add(renderer, source, color), water, x, y, 0.0)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("picture", nargs="?", default="swell.png", type=png_name, help="default: %(default)s")
    parser.add_argument("time", nargs="?", type=float, default=0.0, help="of the waves, s; default: %(default)s")
    arguments = parser.parse_args()
    picture, time = arguments.picture, arguments.time

    water = vtkWaterActor()
    look = water.GetWaterProperty()
    for wave in WAVES:
        look.AddWave(*wave)
    look.WaveGeometryOn()
    look.SetWaveGridSize(512)
    look.SetRayTraceQualityToHigh()
    water.SetSheetBounds(-500.0, 500.0, -500.0, 500.0)
    water.SetTime(time)

    renderer = vtkRenderer()
    renderer.GradientBackgroundOn()
    renderer.SetBackground(0.86, 0.88, 0.88)
    renderer.SetBackground2(0.36, 0.53, 0.74)
    sun = vtkLight()
    sun.SetLightTypeToSceneLight()
    sun.SetPosition(-8.0, -9.0, 9.0)
    renderer.AddLight(sun)
    renderer.AddActor(water)
    add_beacon(renderer, 1.8, 3.0)
    add_buoy(renderer, water, -2.8, -3.4)
    add_raft(renderer, water, -5.0, 7.0)

    camera = renderer.GetActiveCamera()
    camera.SetPosition(-1.2, -13.0, 2.3)
    camera.SetFocalPoint(-0.6, 4.0, 1.1)
    camera.SetViewUp(0.0, 0.0, 1.0)
    camera.SetViewAngle(38.0)
    camera.SetClippingRange(0.5, 1500.0)
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(8)
    window.SetSize(960, 600)
    window.AddRenderer(renderer)

    write_png(window, picture)


if __name__ == "__main__":
    with ending("swell"):
        main()
