# SPDX-License-Identifier: BSD-3-Clause
"""data_waters: a level mesh of water over a level bed, with arrays of points or cells."""

import numpy as np
import water_test as wt
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkRenderingCore import vtkPolyDataMapper
from vtkwater import vtkWaterActor

CELLS = 40
SIZE = (160, 120)


def mesh_of(name, values_at, half=20.0, of_cells=False, components=1):
    """A square of the water at level 0 with an array, of a function of x and y; None: without one."""
    side = np.linspace(-half, half, CELLS + 1)
    x, y = (each.ravel() for each in np.meshgrid(side, side))
    first = (np.arange(CELLS)[:, None] * (CELLS + 1) + np.arange(CELLS)).ravel()
    quads = np.stack([first, first + 1, first + CELLS + 2, first + CELLS + 1], axis=1)
    mesh, points, polygons = vtkPolyData(), vtkPoints(), vtkCellArray()
    points.SetDataTypeToDouble()
    points.SetData(numpy_to_vtk(np.column_stack([x, y, 0.0 * x]), deep=True))
    for quad in quads:
        polygons.InsertNextCell(4, quad.tolist())
    mesh.SetPoints(points)
    mesh.SetPolys(polygons)
    if values_at is not None:
        places = (x, y) if not of_cells else (x[quads].mean(axis=1), y[quads].mean(axis=1))
        values = np.broadcast_to(np.asarray(values_at(*places), float), places[0].shape)
        array = numpy_to_vtk(np.repeat(values[:, None], components, axis=1).copy(), deep=True)
        array.SetName(name)
        (mesh.GetCellData() if of_cells else mesh.GetPointData()).AddArray(array)
    return mesh


def warnings_of(thing):
    """A list that the texts of an object's warnings will be put into."""
    texts = []

    def remember(caller, event, text):
        texts.append(text)

    remember.CallDataType = "string0"
    thing.AddObserver("WarningEvent", remember)
    return texts


class Scene:
    """Water of a mesh that reflects nothing, over a bed without light."""

    def __init__(self, mesh, depth=2.0, bed=(1, 1, 1), samples=0):
        self.view = wt.View(SIZE, (0, 0, 0), samples=samples)
        wt.add_actor(self.view.renderer, wt.box((0, 0, -depth - 0.5), (398, 398, 1)), bed, lit=False)
        self.water = vtkWaterActor()
        self.mapper = vtkPolyDataMapper()
        self.mapper.SetInputDataObject(mesh)
        self.mapper.ScalarVisibilityOff()
        self.water.SetMapper(self.mapper)
        self.look = self.water.GetWaterProperty()
        self.look.SetReflectanceModeToConstant()
        self.look.SetReflectance(0.0)
        self.look.GlitterOff()
        self.look.RefractionOn()
        self.errors, self.warnings = wt.errors_of(self.water), warnings_of(self.water)
        self.view.renderer.AddActor(self.water)

    def look_from(self, position, parallel=0.0):
        camera = wt.place_camera(self.view.renderer, position, (0, 0, 0), (0.1, 400), (0, 1, 0))
        camera.SetViewAngle(30)
        camera.SetParallelProjection(parallel > 0)
        if parallel:
            camera.SetParallelScale(parallel)
        return camera

    def picture(self):
        return self.view.picture().astype(int)
