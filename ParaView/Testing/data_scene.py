# SPDX-License-Identifier: BSD-3-Clause
"""Results of a solver, made up: a lake that rises in a round basin with an island, and a current around it.

They are images of 2 dimensions, which a reader splits over ranks, in a ParaView collection with 3 times.
"""
import os

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkDataSetAttributes, vtkImageData, vtkPolyData, vtkStructuredGrid
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter

import water_scene
from water_scene import pv

LEVELS = {0.0: 0.2, 1.0: 0.4, 2.0: 0.6}  # at these times
COUNT = 97  # points along an axis


def make_steps():
    """Writes the files, once for all ranks to read. Returns the collection's name."""
    x, y = numpy.meshgrid(numpy.linspace(-4.0, 4.0, COUNT), numpy.linspace(-4.0, 4.0, COUNT))
    bed = 0.12 * (x * x + y * y) - 0.8 + 1.5 * numpy.exp(-4.0 * ((x + 1.0) ** 2 + y * y))
    names = []
    for step, (time, level) in enumerate(LEVELS.items()):
        image = vtkImageData()
        image.SetDimensions(COUNT, COUNT, 1)
        image.SetOrigin(-4.0, -4.0, 0.0)
        image.SetSpacing(8.0 / (COUNT - 1), 8.0 / (COUNT - 1), 1.0)
        current = numpy.stack([-y, x, 0.0 * x], axis=2).reshape(-1, 3)
        for name, values in (("zb", bed.ravel()), ("h", numpy.maximum(level - bed, 0.0).ravel()),
                             ("zeta", numpy.full(bed.size, level)), ("distance", numpy.hypot(x, y).ravel()),
                             ("current", current)):
            array = numpy_to_vtk(numpy.ascontiguousarray(values), deep=True)
            array.SetName(name)
            image.GetPointData().AddArray(array)
        names.append((time, "basin-%d.vti" % step))
        writer = vtkXMLImageDataWriter()
        writer.SetFileName(water_scene.path(names[-1][1]))
        writer.SetInputData(image)
        writer.Write()
    collection = water_scene.path("basin.pvd")
    with open(collection, "w", encoding="utf-8") as stream:
        stream.write('<VTKFile type="Collection" version="0.1"><Collection>\n')
        for time, name in names:
            stream.write('<DataSet timestep="%g" file="%s"/>\n' % (time, name))
        stream.write("</Collection></VTKFile>\n")
    return collection


def open_steps(view, has_land=True):
    """The reader of the collection; the bed is shown as land."""
    reader = pv.PVDReader(FileName=water_scene.path("basin.pvd"))
    reader.UpdatePipeline(0.0)
    if has_land:
        land = pv.WarpByScalar(Input=reader, Scalars=["POINTS", "zb"])
        shown = pv.Show(water_scene.add_normals(pv.ExtractSurface(Input=land)), view)
        shown.ColorArrayName = [None, ""]
        shown.DiffuseColor = shown.AmbientColor = [0.55, 0.5, 0.35]
    return reader


def surface_of(reader, **arrays):
    return pv.WaterSurface(Input=reader, **(arrays or {"DepthArray": "h", "BedArray": "zb"}))


HIDDEN = 60, 80, 20, 50  # first and last column and row of the points that tilted gives a fill value


def tilted(marked, form="mesh"):
    """A tilted surface with a hole, where the points have a fill value for a height.

    marked: the hole's "cells" or "points" are hidden; "none": it has no cells; None: and no fill value. form: a "grid"
    or a "mesh" of polygons.
    """
    x, y = numpy.meshgrid(numpy.linspace(-4.0, 4.0, COUNT), numpy.linspace(-4.0, 4.0, COUNT))
    z = 0.3 + 0.02 * x - 0.01 * y  # even: whichever diagonal halves a cell
    column, row = numpy.meshgrid(numpy.arange(COUNT), numpy.arange(COUNT))
    is_filled = (column >= HIDDEN[0]) & (column <= HIDDEN[1]) & (row >= HIDDEN[2]) & (row <= HIDDEN[3])
    if marked:
        z[is_filled] = 40.0
    points = vtkPoints()
    points.SetData(numpy_to_vtk(numpy.stack([x, y, z], axis=2).reshape(-1, 3).astype(numpy.float32), deep=True))
    is_hole = is_filled[1:, 1:] | is_filled[:-1, 1:] | is_filled[1:, :-1] | is_filled[:-1, :-1]
    first = (column[:-1, :-1] + COUNT * row[:-1, :-1])
    corners = numpy.stack([first, first + 1, first + COUNT + 1, first + COUNT], axis=2)
    if form == "grid":
        data = vtkStructuredGrid()
        data.SetDimensions(COUNT, COUNT, 1)
    else:
        corners = corners.reshape(-1, 4) if marked in ("cells", "points") else corners[~is_hole]
        cells = vtkCellArray()
        for quad in corners.tolist():
            cells.InsertNextCell(4, quad)
        data = vtkPolyData()
        data.SetPolys(cells)
        data.BuildCells()
    data.SetPoints(points)
    if marked in ("cells", "points"):
        of_cells = marked == "cells"
        bit = vtkDataSetAttributes.HIDDENCELL if of_cells else vtkDataSetAttributes.HIDDENPOINT
        marks = numpy_to_vtk((bit * (is_hole if of_cells else is_filled)).astype(numpy.uint8).ravel(), deep=True)
        marks.SetName(vtkDataSetAttributes.GhostArrayName())
        (data.GetCellData() if of_cells else data.GetPointData()).AddArray(marks)
    return data
