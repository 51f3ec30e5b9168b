# SPDX-License-Identifier: BSD-3-Clause
"""wind_farm: offshore wind turbines on a wind sea with whitecaps, under a low sun."""

import argparse
import math

from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkAppendPolyData, vtkPolyDataNormals
from vtkmodules.vtkFiltersModeling import vtkRotationalExtrusionFilter
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkSphereSource
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkLight,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
    vtkSkybox,
)
from vtkmodules.vtkRenderingOpenGL2 import vtkOpenGLSkybox  # noqa: F401  what draws a skybox
from vtkwater import vtkWaterActor, vtkWaterClearSkySource
from vtkwater.errors import ending
from vtkwater.pictures import png_name, write_png

SUN = (338.0, 8.0)  # azimuth and elevation, degrees: low, in the picture, so that the sea glitters
EXPOSURE = 0.013  # of the sky: a picture taken towards the sun is exposed for it
SUN_INTENSITY = 0.03  # the same of the sun's light
WIND = 14.0  # m/s
WIND_DIRECTION = 250.0  # degrees: the direction in which it blows
HUB = 92.0  # m above the sea
BLADE = 61.0  # m
WHITE = (0.90, 0.91, 0.92)
YELLOW = (0.95, 0.74, 0.10)
FARM = [(70.0 + 640.0 * column - 160.0 * row, 250.0 + 760.0 * row)
        for row in range(5) for column in range(-2, 4) if row > 0 or column == 0]


def revolved(profile):
    """The body that a profile of (radius, height) describes around the z axis."""
    points, line = vtkPoints(), vtkCellArray()
    for radius, height in profile:
        points.InsertNextPoint(radius, 0.0, height)
    line.InsertNextCell(len(profile), range(len(profile)))
    data = vtkPolyData()
    data.SetPoints(points)
    data.SetLines(line)
    body = vtkRotationalExtrusionFilter()
    body.SetInputData(data)
    body.SetResolution(64)
    normals = vtkPolyDataNormals()
    normals.SetInputConnection(body.GetOutputPort())
    normals.SetFeatureAngle(40.0)
    normals.Update()
    return normals.GetOutput()


def blade(angle):
    """A blade in the rotor's plane, at an angle from up in degrees: a cylinder that becomes a flat profile."""
    points, faces = vtkPoints(), vtkCellArray()
    stations, around = 24, 24
    cosine, sine = math.cos(math.radians(angle)), math.sin(math.radians(angle))
    for i in range(stations + 1):
        share = i / stations
        root = min(1.0, share / 0.18)
        chord = (1.2 + 1.2 * math.sin(0.5 * math.pi * root)) * (1.0 - 0.8 * share ** 1.4) * (1.0 - 0.7 * share ** 24)
        thick = chord * (1.0 - 0.8 * root) + 0.2 * root * chord
        twist = math.radians(18.0) * (1.0 - share) * root
        for k in range(around):
            turn = 2.0 * math.pi * k / around
            along, across = chord * math.cos(turn), thick * math.sin(turn)
            u = along * math.cos(twist) - across * math.sin(twist)
            v = along * math.sin(twist) + across * math.cos(twist)
            z = 1.0 + BLADE * share
            points.InsertNextPoint(u * cosine + z * sine, v, z * cosine - u * sine)
    for i in range(stations):
        for k in range(around):
            a, b = i * around + k, i * around + (k + 1) % around
            faces.InsertNextCell(4, (a, b, b + around, a + around))
    faces.InsertNextCell(around, range(stations * around, (stations + 1) * around))
    data = vtkPolyData()
    data.SetPoints(points)
    data.SetPolys(faces)
    normals = vtkPolyDataNormals()
    normals.SetInputData(data)
    normals.Update()
    return normals.GetOutput()


def joined(parts):
    together = vtkAppendPolyData()
    for part in parts:
        together.AddInputData(part)
    together.Update()
    return together.GetOutput()


def output_of(source):
    source.Update()
    return source.GetOutput()


def box(bounds):
    source = vtkCubeSource()
    source.SetBounds(bounds)
    return output_of(source)


def add(renderer, data, color, x, y, z=0.0):
    mapper = vtkPolyDataMapper()
    mapper.SetInputDataObject(data)
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.SetPosition(x, y, z)
    actor.RotateZ(WIND_DIRECTION - 90.0)  # y is downwind
    actor.GetProperty().SetColor(color)
    actor.GetProperty().SetAmbient(0.35)
    actor.GetProperty().SetDiffuse(0.75)
    renderer.AddActor(actor)


def add_turbine(renderer, parts, x, y, angle):
    pile, tower, nacelle = parts
    hub = vtkSphereSource()
    hub.SetRadius(2.1)
    hub.SetThetaResolution(32)
    hub.SetPhiResolution(32)
    rotor = joined([*(blade(angle + 120.0 * i) for i in range(3)), output_of(hub)])
    add(renderer, pile, YELLOW, x, y)
    for data in (tower, nacelle):
        add(renderer, data, WHITE, x, y)
    upwind = math.radians(WIND_DIRECTION + 180.0)
    add(renderer, rotor, WHITE, x + 6.0 * math.cos(upwind), y + 6.0 * math.sin(upwind), HUB)


def turbine_parts():
    """Pile with a ladder and a platform with its railing; tower; nacelle."""
    rail = [revolved(((4.6, z), (4.75, z), (4.75, z + 0.12), (4.6, z + 0.12))) for z in (17.9, 18.5)]
    posts = [box((4.6 * math.cos(a) - 0.06, 4.6 * math.cos(a) + 0.06, 4.6 * math.sin(a) - 0.06,
                  4.6 * math.sin(a) + 0.06, 17.3, 18.6)) for a in (2.0 * math.pi * i / 16 for i in range(16))]
    ladder = [box((-0.6 + 1.1 * i, -0.5 + 1.1 * i, -3.6, -3.4, -3.0, 17.0)) for i in range(2)]
    ladder += [box((-0.6, 0.6, -3.55, -3.45, 0.5 * z, 0.5 * z + 0.08)) for z in range(-4, 34)]
    pile = revolved(((3.1, -30.0), (3.1, 17.0), (4.8, 17.0), (4.8, 17.3), (2.7, 17.3), (2.7, 18.5)))
    tower = revolved(((2.6, 18.5), (1.7, HUB - 1.5)))
    nacelle = box((-1.9, 1.9, -4.8, 8.0, HUB - 1.8, HUB + 2.2))
    return joined([pile, *rail, *posts, *ladder]), tower, nacelle


def make_water(time):
    water = vtkWaterActor()
    look = water.GetWaterProperty()
    look.SetPreset("ocean wind 10")
    look.SetWindSpeed(WIND)
    look.SetWindDirection(WIND_DIRECTION)
    look.SetFetch(40e3)
    look.SetSeaCascades(3)
    look.WaveGeometryOn()
    look.WhitecapsOn()
    water.SetSheetToHorizon()
    water.SetTime(time)
    return water


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("picture", nargs="?", default="wind_farm.png", type=png_name, help="default: %(default)s")
    parser.add_argument("time", nargs="?", type=float, default=0.0, help="of the waves, s; default: %(default)s")
    arguments = parser.parse_args()

    renderer = vtkRenderer()
    sky = vtkWaterClearSkySource()
    sky.SetAzimuth(SUN[0])
    sky.SetElevation(SUN[1])
    sky.SetTurbidity(2.0)
    sky.SetExposure(EXPOSURE)
    skybox = vtkSkybox()
    sky.ConfigureSkybox(skybox, renderer)
    renderer.SetBackground(sky.GetMeanColor())
    sun = vtkLight()
    sun.SetLightTypeToSceneLight()
    sun.SetPosition(sky.GetSunDirection())
    sun.SetColor(sky.GetSunColor())
    sun.SetIntensity(SUN_INTENSITY)
    renderer.AddLight(sun)
    renderer.AddActor(skybox)
    renderer.AddActor(make_water(arguments.time))
    parts = turbine_parts()
    for i, (x, y) in enumerate(FARM):
        add_turbine(renderer, parts, x, y, 8.0 + 37.0 * i)

    camera = renderer.GetActiveCamera()
    camera.SetPosition(0.0, 0.0, 8.0)
    camera.SetFocalPoint(4.0, 200.0, 38.0)
    camera.SetViewUp(0.0, 0.0, 1.0)
    camera.SetViewAngle(45.0)
    camera.SetClippingRange(2.0, 20000.0)
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(8)
    window.SetSize(960, 600)
    window.AddRenderer(renderer)
    write_png(window, arguments.picture)


if __name__ == "__main__":
    with ending("wind_farm"):
        main()
