# SPDX-License-Identifier: BSD-3-Clause
"""lakes: the hollows of a landscape, filled to their rims: lakes at several levels, from one mesh.

The terrain is the landscape around the Jacksboro fault (Examples/Data). Each hollow is filled to the lowest point of
its rim. vtkWaterLakes creates one water for each level of the largest lakes, and mirrors those in view that cover most
of the picture. All other lakes are one more water, which reflects only the sky.
"""

import argparse
import pathlib

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkStructuredGrid
from vtkmodules.vtkIOXML import vtkXMLImageDataReader
from vtkmodules.vtkRenderingCore import vtkPolyDataMapper
from vtkwater import vtkWaterLakes, vtkWaterSurfaceFilter
from vtkwater.errors import ending
from vtkwater.pictures import png_name
from vtkwater.readers import surface_of_heights
from vtkwater.scenes import Scene

TERRAIN = pathlib.Path(__file__).resolve().parents[1] / "Data/jacksboro.vti"
EXAGGERATION = 2.0  # heights are drawn this many times higher than they are
LEAST_DEPTH = 6.0  # m: shallower hollows stay dry
MIRRORS = 16
PLANES = 64


def read_heights():
    """Rows from the south-west, and the spacing, m."""
    reader = vtkXMLImageDataReader()
    reader.SetFileName(str(TERRAIN))
    reader.Update()
    image = reader.GetOutput()
    columns, rows, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(rows, columns).astype(float), image.GetSpacing()


def spread(values, choose):
    """The chosen one of each place's value and those of its four neighbours."""
    spread = values.copy()
    for axis in (0, 1):
        first, last = np.moveaxis(spread, axis, 0)[1:], np.moveaxis(spread, axis, 0)[:-1]
        near = np.moveaxis(values, axis, 0)
        choose(first, near[:-1], out=first)
        choose(last, near[1:], out=last)
    return spread


def filled(bed):
    """Levels of water that stands in every hollow, and the bed elsewhere.

    Source: Planchon and Darboux 2002, "A Fast, Simple and Versatile Algorithm to Fill the Depressions of Digital
    Elevation Models".
    """
    level = np.full_like(bed, np.inf)
    for border in (np.s_[0], np.s_[-1], np.s_[:, 0], np.s_[:, -1]):
        level[border] = bed[border]
    while True:
        lower = np.maximum(bed, spread(level, np.minimum))
        if (lower == level).all():
            return level
        level = lower


def deep(depth):
    """The depths of hollows that are deep enough somewhere."""
    deepest = depth
    while True:
        deeper = np.where(depth > 0, spread(deepest, np.maximum), 0.0)
        if (deeper == deepest).all():
            return np.where(deepest >= LEAST_DEPTH, depth, 0.0)
        deepest = deeper


def mesh_of(bed, depth, spacing):
    rows, columns = bed.shape
    y, x = np.mgrid[0:rows, 0:columns]
    places = np.stack([spacing[0] * x, spacing[1] * y, 0.0 * x], axis=-1)
    points = vtkPoints()
    points.SetData(numpy_to_vtk(places.reshape(-1, 3), deep=True))
    mesh = vtkStructuredGrid()
    mesh.SetDimensions(columns, rows, 1)
    mesh.SetPoints(points)
    for name, values in (("bed", bed), ("depth", depth)):
        array = numpy_to_vtk(values.ravel(), deep=True)
        array.SetName(name)
        mesh.GetPointData().AddArray(array)
    return mesh


def add_lakes(scene, mesh):
    surface = vtkWaterSurfaceFilter()
    surface.SetInputData(mesh)
    surface.SetDepthArrayName("depth")
    surface.SetBedArrayName("bed")
    surface.SetVerticalScale(EXAGGERATION)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(surface.GetOutputPort())
    mapper.ScalarVisibilityOff()
    lakes = vtkWaterLakes()
    lakes.SetMapper(mapper)
    lakes.SetMaximumNumberOfMirrors(MIRRORS)
    lakes.SetMaximumNumberOfPlanes(PLANES)
    look = lakes.GetWater().GetWaterProperty()
    look.SetPreset("lake")
    look.RemoveAllWaves()
    look.SeaOff()
    lakes.AddTo(scene.renderer)
    return lakes


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("picture", nargs="?", default="lakes.png", type=png_name, help="default: %(default)s")
    arguments = parser.parse_args()
    bed, spacing = read_heights()
    depth = deep(filled(bed) - bed)
    scene = Scene((1280, 720))
    scene.add_ground(surface_of_heights(bed, spacing), bed.min(), EXAGGERATION)
    lakes = add_lakes(scene, mesh_of(bed, depth, spacing))
    scene.set_sun(150.0, 32.0)
    scene.set_camera((26000.0, 3600.0, 1500.0), (21800.0, 9500.0, 640.0), 36.0)
    scene.write(arguments.picture)
    waters = [lakes.GetWater(i) for i in range(lakes.GetNumberOfWaters())]
    seen = [water for water in waters if water.GetReflectionPass().GetNumberOfReflectionRenders() > 0]
    levels = [water.GetLevel() / EXAGGERATION for water in waters]
    print(f"{arguments.picture}: {len(waters)} levels from {min(levels):.0f} to {max(levels):.0f} m, "
          f"{len(seen)} mirrored views")


if __name__ == "__main__":
    with ending("lakes"):
        main()
