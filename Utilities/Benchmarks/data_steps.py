# SPDX-License-Identifier: BSD-3-Clause
"""data_steps: a tide in a basin as solvers write it, drawn as VTK's plain surface or as water, step by step.

    data_steps.py KIND --cells 1000000 --steps 100   memory of each step, in bytes, as JSON
    data_steps.py KIND FILE.vtp                             seconds to the first picture of a file

benchmark's section `data` runs it, for processes of their own. KIND is one of KINDS.
"""

import argparse
import ctypes
import json
import pathlib
import time

import numpy as np
import pyvista as pv
import vtkwater.pyvista  # noqa: F401  gives the plotter add_water
from data_tide import EYE, RANGE, TARGET, Tide
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkwater.solutions import Solution

SIZE = (800, 600)
PLAIN, COLOURED, CLEAR = "plain", "coloured", "clear"
KINDS = (PLAIN, COLOURED, CLEAR)
POLYGONS, CELLS, ROWS = "vtkPolyData", "vtkUnstructuredGrid", "vtkStructuredGrid"


def mesh_of(tide, heights, data=POLYGONS):
    places = tide.points(heights)
    if data == ROWS:
        mesh = pv.StructuredGrid()
        mesh.points = places
        mesh.dimensions = tide.side, tide.side, 1
        return mesh
    quads = tide.quads()
    cells = np.column_stack([np.full(len(quads), 4), quads]).ravel()
    if data == CELLS:
        return pv.UnstructuredGrid(cells, np.full(len(quads), pv.CellType.QUAD, dtype=np.uint8), places)
    return pv.PolyData(places, cells)


class View:
    """A window with the bed and the surface of one kind."""

    def __init__(self, kind, tide, mesh=None, size=SIZE, data=POLYGONS):
        self.kind, self.tide = kind, tide
        self.mesh = mesh_of(tide, tide.bed, data) if mesh is None else mesh
        self.plotter = pv.Plotter(off_screen=True, window_size=size)
        if mesh is None:
            self.mesh["zb"] = tide.bed
            self.choose(0)
            self.plotter.add_mesh(mesh_of(tide, tide.bed), color="tan")
        if kind == PLAIN:
            self.plotter.add_mesh(self.mesh, scalars="h", clim=RANGE)
        else:
            colours = {"color_by": "h", "clim": RANGE} if kind == COLOURED else {}
            self.plotter.add_water(self.mesh, level="zeta", depth="h", bed="zb", **colours)
        self.plotter.camera_position = [EYE, TARGET, (0, 0, 1)]
        self.plotter.show(auto_close=False)
        self.window = self.plotter.render_window

    def choose(self, number):
        """New arrays, as a solver's next step has them; a plain surface has them as its points, too."""
        level, depth = self.tide.step(number)
        self.mesh["h"] = depth
        if self.kind == PLAIN:
            self.mesh.points = self.tide.points(level)
        else:
            self.mesh["zeta"] = level

    def render(self):
        self.window.Render()
        self.window.WaitForCompletion()


def write_file(path, cells):
    """One step of the tide, its points at the level, without compression."""
    tide = Tide(cells)
    level, depth = tide.step(0)
    mesh = mesh_of(tide, level)
    mesh["h"], mesh["zeta"], mesh["zb"] = depth, level, tide.bed
    mesh.save(path)


class MallocInfo(ctypes.Structure):
    """mallinfo2 of glibc 2.33 and later."""

    _fields_ = [(name, ctypes.c_size_t) for name in ("arena", "ordblks", "smblks", "hblks", "hblkhd", "usmblks",
                                                     "fsmblks", "uordblks", "fordblks", "keepcost")]


def allocated():
    """Bytes that are allocated in this process. The system's count also has what malloc keeps of memory that is free,
    which goes up and down by some arrays' size."""
    ask = ctypes.CDLL(None).mallinfo2
    ask.restype = MallocInfo
    info = ask()
    return info.uordblks + info.hblkhd


def memory_of(kind, cells, steps):
    """Bytes that are allocated after each step."""
    view = View(kind, Tide(cells))
    for number in range(1, steps + 1):
        view.choose(number)
        view.render()
        yield allocated()


def write_series(folder, cells, steps):
    """Steps of the tide as VTK writes them by default, which is compressed, and a collection of them."""
    tide = Tide(cells)
    entries = []
    for number in range(steps):
        mesh = mesh_of(tide, tide.bed)
        mesh["zeta"], mesh["h"] = tide.step(number)
        mesh["zb"] = tide.bed
        mesh.save(folder / f"{number}.vtp")
        entries.append(f'<DataSet timestep="{number}" file="{number}.vtp"/>')
    path = folder / "tide.pvd"
    path.write_text(f'<VTKFile type="Collection"><Collection>{"".join(entries)}</Collection></VTKFile>')
    return path


def play(path, cells, read_ahead):
    """Seconds that a step of a series takes, read and drawn; a median."""
    view = View(COLOURED, Tide(cells))
    solution = Solution(path, ["zeta", "h"], read_ahead=read_ahead)
    times = []
    for number in range(1, len(solution.times)):
        begin = time.perf_counter()
        arrays = solution.step(number).GetPointData()
        for name in ("zeta", "h"):
            view.mesh[name] = vtk_to_numpy(arrays.GetArray(name))
        view.render()
        times.append(time.perf_counter() - begin)
    view.plotter.close()
    return float(np.median(times[1:]))  # the first one is not read ahead, nor is the process started


def first_picture(kind, path):
    """(seconds, seconds of the processor) from the file's name to the picture"""
    begin, work = time.perf_counter(), time.process_time()
    View(kind, None, pv.read(path)).render()
    return time.perf_counter() - begin, time.process_time() - work


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("kind", choices=KINDS)
    parser.add_argument("file", nargs="?", type=pathlib.Path)
    parser.add_argument("--cells", type=int, default=1_000_000)
    parser.add_argument("--steps", type=int, default=100)
    arguments = parser.parse_args()
    if arguments.file:
        View(arguments.kind, Tide(100)).render()  # libraries, and the shaders of both
        print(json.dumps(first_picture(arguments.kind, arguments.file)))
    else:
        print(json.dumps(list(memory_of(arguments.kind, arguments.cells, arguments.steps))))


if __name__ == "__main__":
    main()
