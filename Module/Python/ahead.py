# SPDX-License-Identifier: BSD-3-Clause
"""Reads steps of a solver's file ahead, in a process of its own.

VTK's readers are not made for several threads: libraries below them (HDF5, netCDF) keep state for the whole process,
and an error of theirs goes to the one output window. So another process has a solution of its own, with the same
arguments, and sends its meshes as arrays. What it sends is what this process would have read. Where it fails, for
whatever reason, it sends nothing, and this process reads the step itself, when it is asked for it, with the error that
belongs to it.
"""
import json
import os
import pickle
import subprocess
import sys
import threading
import weakref

from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import VTK_POLYHEDRON, vtkCellArray, vtkPolyData, vtkUnstructuredGrid

__all__ = ["Ahead", "pack", "serve", "unpack"]

CODE = "import sys; sys.path[:] = {path!r}; from vtkwater.ahead import serve; serve()"
POLYGONS = ("Verts", "Lines", "Polys", "Strips")  # of vtkPolyData


class Ahead:
    """Another process that reads one step at a time.

    Parameters
    ----------
    *arguments
        Of Solution: the path, the names of the arrays, is_volume and is_lonlat.
    """

    def __init__(self, *arguments):
        self._arguments = arguments
        self._process = None
        self._thread = None
        self._number = None  # of the step that was asked for last
        self._found = []
        self._is_over = False

    def ask(self, number):
        """Begin to read a step, unless another one is still being read."""
        if self._is_over or (self._thread and self._thread.is_alive()):
            return
        if not self._process:
            self._start()
        if self._process:
            self._number, self._found = number, []
            self._thread = threading.Thread(target=exchange, args=(self._process, number, self._found), daemon=True)
            self._thread.start()

    def take(self, number):
        """The mesh of a step that was asked for, when it is there; None: read it yourself."""
        if self._number != number:
            return None
        self._thread.join()
        self._number = None
        if not self._found:
            self._is_over = True  # the process is gone
            return None
        packed = self._found.pop()
        return None if packed is None else unpack(packed)

    def _start(self):
        path, arrays, *rest = self._arguments
        try:
            self._process = subprocess.Popen(
                [sys.executable, "-c", CODE.format(path=sys.path)], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                stderr=subprocess.DEVNULL)  # what is wrong is said when the step is asked for
            self._process.stdin.write(json.dumps([os.path.abspath(path), list(arrays), *rest]).encode() + b"\n")
        except OSError:
            self._is_over = True
            return
        weakref.finalize(self, end, self._process)


def end(process):
    process.kill()
    process.wait()
    process.stdin.close()
    process.stdout.close()


def exchange(process, number, found):
    """Sends the number of a step, and adds what comes back; nothing if the process has ended."""
    try:
        process.stdin.write(b"%d\n" % number)
        process.stdin.flush()
        found.append(pickle.load(process.stdout))
    except (OSError, EOFError, ValueError, pickle.UnpicklingError):
        pass


def serve():
    """The other process: steps by their numbers from standard input, until it ends."""
    from .solutions import Solution

    answers = os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)  # what libraries print is no answer
    solution = None
    path, arrays, is_volume, is_lonlat = json.loads(sys.stdin.readline())
    for line in sys.stdin:
        packed = None
        try:
            solution = solution or Solution(path, arrays, is_volume, is_lonlat)
            packed = pack(solution.step(int(line)))
        except Exception:  # whatever it is: the other process will meet it, too, and say it
            pass
        pickle.dump(packed, answers, protocol=5)
        answers.flush()


def pack(mesh):
    """A mesh as arrays of NumPy; None if they do not hold all of it."""
    cells = {}
    if mesh.IsA("vtkPolyData"):
        for name in POLYGONS:
            of_name = getattr(mesh, f"Get{name}")()
            if of_name.GetNumberOfCells():
                cells[name] = cells_of(of_name)
    else:
        types = mesh.GetCellTypes() if hasattr(mesh, "GetDistinctCellTypes") else mesh.GetCellTypesArray()  # VTK 9.6
        kinds = vtk_to_numpy(types)
        if (kinds == VTK_POLYHEDRON).any():
            return None
        cells["Cells"] = cells_of(mesh.GetCells())
        cells["types"] = kinds
    arrays = [(of_cells, data.GetArrayName(i), vtk_to_numpy(data.GetArray(i)))
              for of_cells, data in ((False, mesh.GetPointData()), (True, mesh.GetCellData()))
              for i in range(data.GetNumberOfArrays())]
    return mesh.GetClassName(), vtk_to_numpy(mesh.GetPoints().GetData()), cells, arrays


def cells_of(cells):
    cells.ConvertTo64BitStorage()
    return vtk_to_numpy(cells.GetOffsetsArray()), vtk_to_numpy(cells.GetConnectivityArray())


def unpack(packed):
    """The mesh of pack. It has copies: VTK's shallow copies of NumPy's memory would outlive it."""
    kind, places, cells, arrays = packed
    mesh = vtkPolyData() if kind == "vtkPolyData" else vtkUnstructuredGrid()
    points = vtkPoints()
    points.SetData(numpy_to_vtk(places, deep=True))
    mesh.SetPoints(points)
    for name, stored in cells.items():
        if name == "types":
            continue
        made = vtkCellArray()
        made.SetData(*(numpy_to_vtkIdTypeArray(part, deep=True) for part in stored))
        if name == "Cells":
            mesh.SetCells(numpy_to_vtk(cells["types"], deep=True), made)
        else:
            getattr(mesh, f"Set{name}")(made)
    for of_cells, name, values in arrays:
        array = numpy_to_vtk(values, deep=True)
        array.SetName(name)
        (mesh.GetCellData() if of_cells else mesh.GetPointData()).AddArray(array)
    return mesh
