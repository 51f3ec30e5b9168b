# SPDX-License-Identifier: BSD-3-Clause
"""reservoir: a plume in a reservoir, volume rendered under the water.

The plume is a concentration on a grid, as an advection-diffusion solver gives it; a Gaussian puff train stands for
one. What is seen through water's refraction are surfaces; a volume wants water of an opacity below 1.
"""

import argparse

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
import vtkmodules.vtkRenderingVolumeOpenGL2  # noqa: F401
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPiecewiseFunction
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction, vtkVolume, vtkVolumeProperty
from vtkmodules.vtkRenderingVolume import vtkGPUVolumeRayCastMapper
from vtkwater.errors import ending
from vtkwater.pictures import png_name
from vtkwater.readers import surface_of_heights
from vtkwater.scenes import Scene

LEVEL, SPACING = 0.0, 5.0  # m
WEST, SOUTH, EAST, NORTH = -800.0, -500.0, 1000.0, 1500.0  # m: the land


def valley():
    """Heights of a flooded valley that falls to a dam in the east."""
    y, x = np.mgrid[SOUTH:NORTH:SPACING, WEST:EAST:SPACING]
    axis = 500.0 + 90.0 * np.sin(x / 170.0)
    floor = -38.0 + 90.0 * np.exp(-np.maximum(x - WEST, 0.0) / 450.0)
    walls = 210.0 * (1.0 - np.exp(-(((y - axis) / 330.0) ** 2)))
    ridges = 0.25 * walls * np.sin(x / 130.0 + y / 300.0) * np.sin(y / 210.0 + 1.0)
    return floor + walls + ridges + 3.0 * np.sin(x / 37.0) * np.sin(y / 45.0)


def plume():
    """Concentration in [0, 1] of puffs that drift down the valley, rise and spread."""
    spacing = (8.0, 5.0, 1.5)
    z, y, x = np.meshgrid(np.arange(-34.0, -0.5, spacing[2]), np.arange(330.0, 720.0, spacing[1]),
                          np.arange(120.0, 980.0, spacing[0]), indexing="ij")
    concentration = np.zeros_like(x)
    for at in np.arange(190.0, 860.0, 22.0):
        age = (at - 190.0) / 670.0
        width = 10.0 + 26.0 * age
        center = 500.0 + 90.0 * np.sin(at / 170.0) + 9.0 * np.sin(at / 31.0)
        concentration += (1.0 - 0.75 * age) * np.exp(
            -(((x - at) / width) ** 2) - ((y - center) / width) ** 2 - ((z + 13.0 - 5.0 * age) / (4.0 + 3.0 * age)) ** 2)
    image = vtkImageData()
    image.SetDimensions(*concentration.shape[::-1])
    image.SetSpacing(spacing)
    image.SetOrigin(120.0, 330.0, -34.0)
    image.GetPointData().SetScalars(
        numpy_to_vtk((concentration / concentration.max()).astype(np.float32).ravel(), deep=True))
    return image


def add_volume(scene, image):
    mapper = vtkGPUVolumeRayCastMapper()
    mapper.SetInputData(image)
    colors, opacity = vtkColorTransferFunction(), vtkPiecewiseFunction()
    for share, red, green, blue, alpha in ((0.0, 1.0, 0.9, 0.3, 0.0), (0.08, 1.0, 0.85, 0.25, 0.0),
                                           (0.35, 1.0, 0.55, 0.10, 0.2), (1.0, 0.75, 0.08, 0.05, 0.7)):
        colors.AddRGBPoint(share, red, green, blue)
        opacity.AddPoint(share, alpha)
    look = vtkVolumeProperty()
    look.SetColor(colors)
    look.SetScalarOpacity(opacity)
    look.SetScalarOpacityUnitDistance(20.0)
    look.SetInterpolationTypeToLinear()
    volume = vtkVolume()
    volume.SetMapper(mapper)
    volume.SetProperty(look)
    scene.renderer.AddVolume(volume)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("picture", nargs="?", default="reservoir.png", type=png_name, help="default: %(default)s")
    arguments = parser.parse_args()

    scene = Scene((1280, 720))
    scene.add_ground(surface_of_heights(valley(), (SPACING, SPACING), (WEST, SOUTH)), LEVEL)
    scene.add_box((985.0, 995.0, 180.0, 860.0, -45.0, 6.0), (0.70, 0.69, 0.66))  # the dam
    add_volume(scene, plume())
    water = scene.add_water(LEVEL)
    look = water.GetWaterProperty()
    look.SetOpacity(0.6)
    look.SetDeepColor(0.02, 0.15, 0.22)
    for amplitude, wavelength, direction in ((0.03, 17.0, 20.0), (0.02, 11.0, 55.0), (0.012, 7.0, -25.0)):
        look.AddWave(amplitude, wavelength, direction)
    scene.set_sun(140.0, 42.0)
    # from over the dam: low, so that the water mirrors the shores
    scene.set_camera((1010.0, 425.0, 58.0), (300.0, 500.0, -4.0), 40.0)
    scene.write(arguments.picture)


if __name__ == "__main__":
    with ending("reservoir"):
        main()
