# SPDX-License-Identifier: BSD-3-Clause
"""harbour: ten thousand boats that float on waves, drawn as glyphs of one mesh.

Each boat lies at the height of the water and leans with it.
"""

import argparse

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints, vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkAppendPolyData, vtkPolyDataNormals
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkCylinderSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkGlyph3DMapper
from vtkwater.errors import ending
from vtkwater.pictures import png_name
from vtkwater.readers import surface_of_heights
from vtkwater.scenes import Scene

BOATS = 10000
BERTH, LANE, ROW = 5.0, 26.0, 125  # m along a pontoon, m between pontoons, boats a row
WAVES = ((0.06, 9.0, 35.0), (0.04, 5.5, 80.0), (0.025, 3.1, 10.0))  # m, m, degrees
COLORS = ((240, 240, 236), (225, 228, 232), (190, 60, 45), (38, 70, 130), (235, 200, 90), (60, 110, 90))


def boat():
    """A hull along x with a cabin and a mast, 8 m long; z = 0 is its waterline."""
    share, height = np.meshgrid(np.linspace(0.0, 1.0, 17), np.linspace(0.0, 1.0, 5))
    half = 1.25 * (1.0 - share**3) * (0.35 + 0.65 * height)
    append = vtkAppendPolyData()
    for side in (-1.0, 1.0, 0.0):  # two sides and the deck
        data = surface_of_heights(half).data
        y = side * half if side else half[-1] * (2.0 * height - 1.0)
        z = -0.5 + 1.4 * height if side else np.full_like(height, 0.82)
        data.GetPoints().SetData(numpy_to_vtk(np.stack([8.0 * share - 4.0, y, z], axis=2).reshape(-1, 3), deep=True))
        append.AddInputData(data)
    cabin = vtkCubeSource()
    cabin.SetBounds(-2.4, 0.6, -0.8, 0.8, 0.8, 1.7)
    mast = vtkCubeSource()
    mast.SetBounds(-0.05, 0.05, -0.05, 0.05, 0.8, 9.5)
    append.AddInputConnection(cabin.GetOutputPort())
    append.AddInputConnection(mast.GetOutputPort())
    normals = vtkPolyDataNormals()
    normals.SetInputConnection(append.GetOutputPort())
    normals.SetFeatureAngle(35.0)
    return normals


def add_fleet(scene, water):
    random = np.random.default_rng(4)
    row, berth = np.divmod(np.arange(BOATS), ROW)
    pier, side = np.divmod(row, 2)
    x = BERTH * berth + random.uniform(-0.4, 0.4, BOATS)
    y = LANE * pier + np.where(side == 0, -6.0, 6.0) + random.uniform(-0.4, 0.4, BOATS)
    bow = np.where(side == 0, -1.0, 1.0)  # points along y, or against it
    points, slopes = np.empty((BOATS, 3)), np.empty((BOATS, 2))
    normal = [0.0, 0.0, 1.0]
    for i in range(BOATS):
        points[i] = x[i], y[i], water.GetWaveHeight(x[i], y[i])
        water.GetWaveNormal(x[i], y[i], normal)
        slopes[i] = -normal[0] / normal[2], -normal[1] / normal[2]
    # degrees about the boat's own axes, after it has been turned by the last: roll, pitch, heading
    rotations = np.degrees(np.stack([np.arctan(-bow * slopes[:, 0]), -np.arctan(bow * slopes[:, 1]),
                                     0.5 * np.pi * bow], axis=1))
    data = vtkPolyData()
    places = vtkPoints()
    places.SetData(numpy_to_vtk(points, deep=True))
    data.SetPoints(places)
    for name, values in (("rotation", rotations), ("size", random.uniform(0.7, 1.15, BOATS))):
        array = numpy_to_vtk(values, deep=True)
        array.SetName(name)
        data.GetPointData().AddArray(array)
    colors = vtkUnsignedCharArray()
    colors.SetNumberOfComponents(3)
    colors.SetName("color")
    for choice in random.integers(0, len(COLORS), BOATS):
        colors.InsertNextTuple3(*COLORS[choice])
    data.GetPointData().SetScalars(colors)
    hull = boat()
    mapper = vtkGlyph3DMapper()
    mapper.SetInputData(data)
    mapper.SetSourceConnection(hull.GetOutputPort())
    mapper.SetOrientationArray("rotation")
    mapper.SetOrientationModeToRotation()
    mapper.SetScaleArray("size")
    mapper.SetScaleModeToScaleByMagnitude()
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetAmbient(0.3)
    actor.GetProperty().SetDiffuse(0.9)
    scene.renderer.AddActor(actor)


def add_pontoons(scene):
    width, piers = BERTH * ROW, BOATS // (2 * ROW)
    for pier in range(piers):
        scene.add_box((-4.0, width, LANE * pier - 0.9, LANE * pier + 0.9, 0.1, 0.5), (0.50, 0.45, 0.38))
    scene.add_box((-14.0, -4.0, -40.0, LANE * piers + 20.0, -4.0, 1.6), (0.56, 0.55, 0.52))  # the quay
    light = vtkCylinderSource()
    light.SetRadius(3.0)
    light.SetHeight(24.0)
    light.SetResolution(24)
    tower = scene.add_mesh(light, (0.92, 0.90, 0.86))
    tower.RotateX(90.0)
    tower.SetPosition(-9.0, -30.0, 12.0)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("picture", nargs="?", default="harbour.png", type=png_name, help="default: %(default)s")
    parser.add_argument("time", nargs="?", type=float, default=0.0, help="of the waves, s; default: %(default)s")
    arguments = parser.parse_args()

    scene = Scene((1280, 720))
    water = scene.add_water(0.0)
    for wave in WAVES:
        water.GetWaterProperty().AddWave(*wave)
    water.SetTime(arguments.time)
    water.SetSheetBounds(-14.0, 3000.0, -600.0, 3000.0)
    add_fleet(scene, water)
    add_pontoons(scene)
    scene.set_sun(250.0, 30.0)
    scene.set_camera((118.0, -46.0, 10.0), (84.0, 30.0, 2.0), 38.0)
    scene.write(arguments.picture)


if __name__ == "__main__":
    with ending("harbour"):
        main()
