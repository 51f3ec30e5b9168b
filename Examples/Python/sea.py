# SPDX-License-Identifier: BSD-3-Clause
"""sea: a ship and buoys on a wind sea, under a clear sky."""

import argparse

from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkFiltersSources import vtkConeSource, vtkCubeSource, vtkCylinderSource
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

SUN = (245.0, 36.0)  # azimuth and elevation, degrees
BUOYS = ((-13.0, 6.0), (-7.5, -9.0), (9.5, -4.0))


def actor_of(data, color):
    mapper = vtkPolyDataMapper()
    mapper.SetInputDataObject(data)
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(color)
    actor.GetProperty().SetAmbient(0.25)
    actor.GetProperty().SetDiffuse(0.75)
    return actor


def output_of(source):
    source.Update()
    return source.GetOutput()


def box(bounds):
    source = vtkCubeSource()
    source.SetBounds(bounds)
    return output_of(source)


def hull():
    """Keel, deck and bow: a box that narrows downwards and comes to a point forward."""
    outline = ((-15.0, -3.4), (9.0, -3.4), (17.0, 0.0), (9.0, 3.4), (-15.0, 3.4))
    points = vtkPoints()
    for share, z in ((0.75, -2.0), (1.0, 3.2)):
        for x, y in outline:
            points.InsertNextPoint(share * x, share * y, z)
    faces = vtkCellArray()
    count = len(outline)
    for i in range(count):
        j = (i + 1) % count
        faces.InsertNextCell(4, (i, j, j + count, i + count))
    faces.InsertNextCell(count, range(count, 2 * count))
    data = vtkPolyData()
    data.SetPoints(points)
    data.SetPolys(faces)
    return data


def add_ship(renderer, x, y, lift):
    parts = (
        (hull(), (0.62, 0.12, 0.10)),
        (box((-13.0, -4.5, -2.4, 2.4, 3.2, 6.4)), (0.93, 0.93, 0.90)),
        (box((-12.0, -6.0, -2.8, 2.8, 6.4, 8.4)), (0.93, 0.93, 0.90)),
        (box((-10.5, -8.0, -1.0, 1.0, 8.4, 11.5)), (0.95, 0.62, 0.10)),
        (box((-3.0, 2.0, -2.3, 2.3, 3.2, 5.2)), (0.20, 0.42, 0.55)),
        (box((2.4, 7.4, -2.3, 2.3, 3.2, 5.2)), (0.75, 0.55, 0.20)),
    )
    for data, color in parts:
        actor = actor_of(data, color)
        actor.SetPosition(x, y, lift)
        actor.RotateZ(152.0)
        renderer.AddActor(actor)


def add_buoy(renderer, water, x, y):
    """It floats at the sea's height and leans with its slope."""
    z = water.GetWaveHeight(x, y)
    normal = [0.0, 0.0, 0.0]
    water.GetWaveNormal(x, y, normal)
    float_ = vtkCylinderSource()
    float_.SetRadius(0.6)
    float_.SetHeight(0.8)
    float_.SetResolution(48)
    mast = vtkConeSource()
    mast.SetDirection(0.0, 1.0, 0.0)
    mast.SetCenter(0.0, 1.2, 0.0)
    mast.SetHeight(1.6)
    mast.SetRadius(0.42)
    mast.SetResolution(48)
    for source, color in ((float_, (0.15, 0.15, 0.15)), (mast, (0.95, 0.45, 0.05))):
        actor = actor_of(output_of(source), color)
        actor.SetPosition(x, y, z)
        # VTK's cylinders lie along y: that is turned to the normal
        actor.RotateWXYZ(180.0, normal[0], normal[1] + 1.0, normal[2])
        renderer.AddActor(actor)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("picture", nargs="?", default="sea.png", type=png_name, help="default: %(default)s")
    parser.add_argument("time", nargs="?", type=float, default=0.0, help="of the waves, s; default: %(default)s")
    arguments = parser.parse_args()
    picture, time = arguments.picture, arguments.time

    water = vtkWaterActor()
    look = water.GetWaterProperty()
    look.SeaOn()
    look.SetWindSpeed(8.0)
    look.SetWindDirection(35.0)
    look.SetFetch(60e3)
    look.SetSeaCascades(3)
    look.WaveGeometryOn()
    look.WhitecapsOn()
    look.SetRayTraceQualityToHigh()  # rays also find what is behind the nearest objects
    water.SetSheetToHorizon()
    water.SetTime(time)

    renderer = vtkRenderer()
    sky = vtkWaterClearSkySource()
    sky.SetAzimuth(SUN[0])
    sky.SetElevation(SUN[1])
    sky.SetTurbidity(2.0)
    skybox = vtkSkybox()
    sky.ConfigureSkybox(skybox, renderer)
    renderer.SetBackground(sky.GetMeanColor())
    sun = vtkLight()
    sun.SetLightTypeToSceneLight()
    sun.SetPosition(sky.GetSunDirection())
    sun.SetColor(sky.GetSunColor())
    renderer.AddLight(sun)
    renderer.AddActor(skybox)
    renderer.AddActor(water)
    add_ship(renderer, 3.0, 16.0, 0.0)
    for x, y in BUOYS:
        add_buoy(renderer, water, x, y)

    camera = renderer.GetActiveCamera()
    camera.SetPosition(-3.0, -32.0, 5.0)
    camera.SetFocalPoint(0.0, 10.0, 2.2)
    camera.SetViewUp(0.0, 0.0, 1.0)
    camera.SetViewAngle(38.0)
    camera.SetClippingRange(1.0, 12000.0)
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(8)
    window.SetSize(960, 600)
    window.AddRenderer(renderer)

    write_png(window, picture)


if __name__ == "__main__":
    with ending("sea"):
        main()
