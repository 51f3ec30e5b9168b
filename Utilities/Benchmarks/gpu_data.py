# SPDX-License-Identifier: BSD-3-Clause
"""gpu_data: a solver's mesh with new arrays in every frame: as VTK's plain surface, and as water. A frame's time
includes giving the arrays to VTK: a plain surface needs points at the level, which the water's filter makes itself.

    VTK_WATER_SOFTWARE=0 gpu_data.py --cells 1000000 --steps 30   ms that the filters take in a step: one thread's work
                                                                  without a picture, the shore cut while drawn

What PyVista's add_water makes of it, by VTK's classes alone: a GPU's machine may have no PyVista.
"""

import argparse
import time

import numpy as np
from data_tide import EYE, RANGE, TARGET, Tide
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkLookupTable, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow
from vtkwater import vtkWaterLakes, vtkWaterSurfaceFilter
from vtkwater.words import set_look

SURFACE, COLOURED, CLEAR = "plain surface", "coloured data", "clear data"
KINDS = (SURFACE, COLOURED, CLEAR)
STEPS = "steps"  # the motion: a step of the solver in every frame
TEXTS = {
    SURFACE: "VTK's surface of the data: points at the level, coloured by depth",
    COLOURED: "water of the same data, coloured by depth",
    CLEAR: "clear water of the same data",
}


def mesh_of(tide, heights):
    mesh, cells = vtkPolyData(), vtkCellArray()
    quads = tide.quads()
    cells.SetData(*(numpy_to_vtkIdTypeArray(part.astype(np.int64), deep=True)
                    for part in (4 * np.arange(len(quads) + 1), quads.ravel())))
    mesh.SetPolys(cells)
    set_heights(mesh, tide, heights)
    return mesh


def set_heights(mesh, tide, heights):
    points = vtkPoints()
    points.SetData(numpy_to_vtk(tide.points(heights)))  # VTK keeps numpy's memory, as in PyVista
    mesh.SetPoints(points)


def set_array(mesh, name, values):
    array = numpy_to_vtk(values)
    array.SetName(name)
    mesh.GetPointData().AddArray(array)


def color(mapper):
    """By depth."""
    table = vtkLookupTable()
    table.SetRange(RANGE)
    mapper.SetLookupTable(table)
    mapper.UseLookupTableScalarRangeOn()
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectColorArray("h")
    mapper.SetInterpolateScalarsBeforeMapping(True)


class Data:
    """A kind's own mesh, and the actor that shows it; water is None for the plain surface."""

    def __init__(self, name, tide, renderer):
        self.name, self.tide = name, tide
        self.mesh = mesh_of(tide, tide.bed)
        self.water, self.props = None, ()
        self.solve(0)
        self.show()
        if name == SURFACE:
            self._add_surface(renderer)
        else:
            self._add_water(renderer)

    def solve(self, number):
        """What a solver does: new arrays of level and depth."""
        self._step = self.tide.step(number)

    def show(self):
        """Gives VTK the arrays; a plain surface has the level as its points."""
        level, depth = self._step
        set_array(self.mesh, "h", depth)
        if self.name == SURFACE:
            set_heights(self.mesh, self.tide, level)
        else:
            set_array(self.mesh, "zeta", level)
        self.mesh.Modified()

    def _add_surface(self, renderer):
        mapper, actor = vtkPolyDataMapper(), vtkActor()
        mapper.SetInputData(self.mesh)
        color(mapper)
        actor.SetMapper(mapper)
        renderer.AddActor(actor)
        self.props = (actor,)

    def _add_water(self, renderer):
        set_array(self.mesh, "zb", self.tide.bed)
        surface = vtkWaterSurfaceFilter()
        surface.SetInputData(self.mesh)
        surface.SetLevelArrayName("zeta")
        surface.SetDepthArrayName("h")
        surface.SetBedArrayName("zb")
        mapper = vtkPolyDataMapper()
        mapper.SetInputConnection(surface.GetOutputPort())
        if self.name == COLOURED:
            color(mapper)
        else:
            mapper.ScalarVisibilityOff()
        self.lakes = vtkWaterLakes()
        self.lakes.SetMapper(mapper)
        self.lakes.Update()
        self.water = self.lakes.GetWater()
        set_look(self.water.GetWaterProperty(), refraction=False if self.name == COLOURED else None)
        renderer.AddActor(self.water)
        self.lakes.AddTo(renderer)


def filters_of(name, cells, steps):
    """Milliseconds of this thread that each step takes, from the solver's arrays to what is drawn."""
    window, renderer = vtkRenderWindow(), vtkRenderer()
    window.OffScreenRenderingOn()
    window.SetSize(160, 120)
    window.AddRenderer(renderer)
    tide = Tide(cells)
    data = Data(name, tide, renderer)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(*EYE)
    camera.SetFocalPoint(*TARGET)
    camera.SetViewUp(0, 0, 1)
    window.Render()  # only a renderer knows who cuts
    if not data.lakes.GetIsShoreCutWhileDrawn():
        print(f"{name}: the filter cuts the shore; set VTK_WATER_SOFTWARE=0")
    for number in range(1, steps + 1):
        data.solve(number)
        begin = time.thread_time()
        data.show()
        data.lakes.Update()
        yield 1000 * (time.thread_time() - begin)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--cells", type=int, default=1_000_000)
    parser.add_argument("--steps", type=int, default=30)
    arguments = parser.parse_args()
    for name in (COLOURED, CLEAR):
        times = list(filters_of(name, arguments.cells, arguments.steps))
        print(f"{name}: median {np.median(times):.1f} ms, least {min(times):.1f} ms")


if __name__ == "__main__":
    main()
