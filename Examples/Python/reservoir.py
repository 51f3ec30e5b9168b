# SPDX-License-Identifier: BSD-3-Clause
"""reservoir: a plume of dye in a reservoir, as the colour of the water.

The plume is a depth-averaged concentration, as an advection-diffusion solver gives it; a Gaussian puff train stands in
for the solver. The lookup table's opacity grows with the concentration: clear water shows where there is no dye.
"""

import argparse

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersGeometry import vtkImageDataGeometryFilter
from vtkmodules.vtkRenderingCore import vtkPolyDataMapper
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
    """The reservoir's surface, with the depth-averaged concentration, in [0, 1], of puffs that drift down it and spread."""
    spacing = 4.0
    y, x = np.mgrid[SOUTH:NORTH:spacing, WEST:985.0:spacing]
    concentration = np.zeros_like(x)
    for at in np.arange(190.0, 860.0, 11.0):
        age = (at - 190.0) / 670.0
        width = 10.0 + 26.0 * age
        middle = 500.0 + 90.0 * np.sin(at / 170.0) + 9.0 * np.sin(at / 31.0)
        concentration += (1.0 - 0.75 * age) / width * np.exp(-(((x - at) / width) ** 2) - ((y - middle) / width) ** 2)
    image = vtkImageData()
    image.SetDimensions(x.shape[1], x.shape[0], 1)
    image.SetSpacing(spacing, spacing, 1.0)
    image.SetOrigin(WEST, SOUTH, LEVEL)
    scalars = numpy_to_vtk((concentration / concentration.max()).astype(np.float32).ravel(), deep=True)
    scalars.SetName("concentration")
    image.GetPointData().SetScalars(scalars)
    surface = vtkImageDataGeometryFilter()
    surface.SetInputData(image)
    surface.Update()
    return surface.GetOutput()


def colors():
    """Of concentrations; the dye's opacity grows with it, as Beer and Lambert's law has it."""
    table = vtkLookupTable()
    table.SetNumberOfTableValues(256)
    thin, thick = np.array((0.98, 0.62, 0.16)), np.array((0.70, 0.10, 0.05))
    for i, share in enumerate(np.linspace(0.0, 1.0, 256)):
        table.SetTableValue(i, *(thin + share * (thick - thin)), 1.0 - np.exp(-3.0 * share))
    table.SetRange(0.0, 1.0)
    return table


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("picture", nargs="?", default="reservoir.png", type=png_name, help="default: %(default)s")
    arguments = parser.parse_args()

    scene = Scene((1280, 720))
    scene.add_ground(surface_of_heights(valley(), (SPACING, SPACING), (WEST, SOUTH)), LEVEL)
    scene.add_box((985.0, 995.0, 180.0, 860.0, -45.0, 6.0), (0.70, 0.69, 0.66))  # the dam
    water = scene.add_water(LEVEL)
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(plume())
    mapper.SetLookupTable(colors())
    mapper.UseLookupTableScalarRangeOn()
    water.SetMapper(mapper)
    look = water.GetWaterProperty()
    look.SetDeepColor(0.02, 0.15, 0.22)
    for amplitude, wavelength, direction in ((0.03, 17.0, 20.0), (0.02, 11.0, 55.0), (0.012, 7.0, -25.0)):
        look.AddWave(amplitude, wavelength, direction)
    look.SetSlopeVariance(0.0004, 0.0004)  # ripples on these: without them each wave mirrors a hard piece of a hill
    scene.set_sun(140.0, 42.0)
    # from over the dam: low, so that the water mirrors the shores
    scene.set_camera((1010.0, 425.0, 58.0), (300.0, 500.0, -4.0), 40.0)
    scene.write(arguments.picture)


if __name__ == "__main__":
    with ending("reservoir"):
        main()
