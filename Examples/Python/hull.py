# SPDX-License-Identifier: BSD-3-Clause
"""hull: the free surface of a ship's flow, as a solver gives it, is the water.

The mesh brings the heights, and its normals the slopes that turn the reflection. --surface takes a file of yours (.vtp
and others: a height over each x and y); without it Kelvin's waves behind a Wigley hull stand for one.
"""

import argparse

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkPlane
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals
from vtkmodules.vtkRenderingCore import vtkPolyDataMapper
from vtkwater.errors import ending
from vtkwater.pictures import png_name
from vtkwater.readers import calm_around, read, surface_of_heights
from vtkwater.scenes import Scene

LENGTH, BEAM, DRAUGHT, FREEBOARD = 40.0, 6.0, 2.5, 2.2  # m
SPEED, GRAVITY = 7.0, 9.81
SIZE, POINTS = 320.0, 1024  # m of water around the ship, and points along a side
HORIZON = 10e3  # m: calm water goes on to there
WIND = 1.0  # m/s: ripples on the waves


def kelvin_waves():
    """Heights of the steady waves of a moving bow and stern: Newman 1977, "Marine Hydrodynamics", section 6.10."""
    places = np.linspace(-0.5 * SIZE, 0.5 * SIZE, POINTS)
    angles = np.linspace(-1.45, 1.45, 1201)  # of the wave's way to the ship's
    number = GRAVITY / (SPEED * np.cos(angles)) ** 2
    damping = np.exp(-((0.9 * number) ** 2))  # a blunt end makes no short waves
    across = np.exp(1j * np.outer(number * np.sin(angles), places))
    heights = np.zeros((POINTS, POINTS))
    for end, strength in ((0.45 * LENGTH, 1.0), (-0.45 * LENGTH, -0.8)):
        along = np.exp(1j * np.outer(number * np.cos(angles), end - places)) * (damping / np.cos(angles))[:, None]
        waves = (across.T @ along).imag * (angles[1] - angles[0])
        heights += 0.6 * strength * waves / (1.0 + np.exp((places - end) / 1.5))  # none ahead
    edge = np.clip((0.5 * SIZE - np.abs(places)) / (0.15 * SIZE), 0.0, 1.0)  # they end in calm water
    return heights * np.outer(edge, edge)


def add_ship(scene):
    """A Wigley hull with straight sides above the water, a deckhouse and a mast."""
    x, z = np.meshgrid(np.linspace(-0.5, 0.5, 81), np.linspace(-1.0, 1.0, 21))
    half = 0.5 * BEAM * (1.0 - (2.0 * x) ** 2) * (1.0 - np.clip(-z, 0.0, 1.0) ** 2)
    hull = surface_of_heights(half).data
    for side in (-1.0, 1.0):
        data = hull.NewInstance()
        data.DeepCopy(hull)
        height = np.where(z < 0.0, DRAUGHT * z, FREEBOARD * z * (1.0 + 0.5 * x))
        points = np.stack([LENGTH * x, side * half, height], axis=2).reshape(-1, 3)
        data.GetPoints().SetData(numpy_to_vtk(points, deep=True))
        scene.add_mesh(data, (0.62, 0.13, 0.10))
    share, side = np.meshgrid(np.linspace(-0.5, 0.5, 81), [-1.0, 1.0])
    deck = surface_of_heights(side).data
    points = np.stack([LENGTH * share, side * 0.5 * BEAM * (1.0 - (2.0 * share) ** 2),
                       0.85 * FREEBOARD * (1.0 + 0.5 * share)], axis=2).reshape(-1, 3)
    deck.GetPoints().SetData(numpy_to_vtk(points, deep=True))
    scene.add_mesh(deck, (0.55, 0.50, 0.42))
    scene.add_box((-13.0, -5.0, -1.7, 1.7, 1.9, 5.2), (0.92, 0.92, 0.89))
    scene.add_box((-11.5, -6.0, -1.5, 1.5, 5.2, 7.0), (0.92, 0.92, 0.89))
    scene.add_box((-9.2, -8.8, -0.2, 0.2, 7.0, 12.0), (0.80, 0.30, 0.15))


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("picture", nargs="?", default="hull.png", type=png_name, help="default: %(default)s")
    parser.add_argument("--surface", help="the free surface: a mesh with z over x and y, the ship at the origin")
    arguments = parser.parse_args()
    surface = read(arguments.surface).data if arguments.surface else None
    spacing = SIZE / (POINTS - 1)
    mesh = surface or surface_of_heights(kelvin_waves(), (spacing, spacing), (-0.5 * SIZE, -0.5 * SIZE)).data
    normals = vtkPolyDataNormals()
    normals.SetInputData(mesh)
    normals.SplittingOff()
    normals.Update()

    scene = Scene((1280, 720))
    add_ship(scene)
    for sheet in (normals.GetOutput(), calm_around(mesh.GetBounds(), HORIZON)):
        water = scene.add_water(0.0, wind=WIND)
        plane = vtkPlane()
        plane.SetNormal(0.0, 0.0, 1.0)
        water.SetPlane(plane)
        mapper = vtkPolyDataMapper()
        mapper.SetInputData(sheet)
        mapper.ScalarVisibilityOff()
        water.SetMapper(mapper)
    scene.set_sun(172.0, 30.0)
    scene.set_camera((42.0, -40.0, 10.0), (-10.0, 4.0, 0.0), 38.0)
    scene.renderer.GetActiveCamera().SetClippingRange(1.0, 2.0 * HORIZON)
    scene.write(arguments.picture)


if __name__ == "__main__":
    with ending("hull"):
        main()
