# SPDX-License-Identifier: BSD-3-Clause
"""Reads steps of a solver's file ahead, in a separate process.

VTK's readers are not safe in several threads: their libraries (HDF5, netCDF) keep state for the whole process, and
report errors to the one output window. Therefore another process opens the same solution, with the same arguments, and
sends its meshes as arrays, each with the number of its step. It sends exactly what this process would have read. If it
fails for any reason, it sends no mesh: this process then reads the step itself when the step is requested, and reports
the error, if there is one.
"""
import contextlib
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

# What is imported may print: only this process's own answers go to its first standard output.
CODE = """import os, sys
answers = os.dup(1)
os.dup2(2, 1)
sys.path[:] = {path!r}
from vtkwater.ahead import serve
serve(answers)"""
MARK = b"vtkwater: a step\n"  # a line before each answer: a sitecustomize module may have printed before CODE runs
LIMIT_S = 60.0  # for an answer; a reader that takes longer is ended
END_S = 5.0  # for the end of a process that was killed; longer only while the system does not answer its reads
POLYGONS = ("Verts", "Lines", "Polys", "Strips")  # of vtkPolyData


class Ahead:
    """Another process that reads one step at a time.

    Several threads may use it. A process created by os.fork() gets no meshes from it, and reads its steps itself.

    Parameters
    ----------
    *arguments
        Those of Solution: the path, the names of the arrays, is_volume and is_lonlat.
    """

    def __init__(self, *arguments):
        self._arguments = arguments
        self._file = states_of([arguments[0]])  # the other process opens it later: it must be the same until then
        self._owner = os.getpid()
        self._lock = threading.Lock()
        self._process = None
        self._finish = None  # ends the process
        self._thread = None
        self._number = None  # of the step that was asked for last
        self._states = None  # of its files when it was asked for
        self._found = []
        self._is_over = not is_python(sys.executable)

    def ask(self, number, files=()):
        """Begin to read a step unless one is still being read; files: those of the step besides the solution's own."""
        if os.getpid() != self._owner:  # of a fork: the pipes are not its own, and the lock may be held for ever
            return
        with self._lock:
            if self._is_over or (self._thread and self._thread.is_alive()) or self._has_changed():
                return
            if not self._process:
                self._start()
            if self._process:
                self._number, self._states, self._found = number, (files, states_of(files)), []
                arguments = self._process, number, self._found
                self._thread = threading.Thread(target=exchange, args=arguments, daemon=True)
                self._thread.start()

    def take(self, number):
        """Wait for the step that was requested and return its mesh; None if the caller must read the step itself.

        The caller must do so if another step was requested, if a file of the step has changed since, or if the other
        process sends no mesh or does not answer within LIMIT_S seconds.
        """
        if os.getpid() != self._owner:
            return None
        with self._lock:
            if self._number != number:
                return None
            self._thread.join(LIMIT_S)
            self._number = None
            answered, packed = self._found.pop() if self._found else (None, None)
            if answered != number:  # it has ended, or does not answer, or answers another question
                self._is_over = True
                self._finish()
                return None
            files, states = self._states
            if packed is None or self._has_changed() or states_of(files) != states:
                return None
            return unpack(packed)

    def _has_changed(self):
        return states_of([self._arguments[0]]) != self._file

    def _start(self):
        path, arrays, *rest = self._arguments
        try:
            self._process = subprocess.Popen(
                [sys.executable, "-c", CODE.format(path=sys.path)], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                stderr=subprocess.DEVNULL)  # what is wrong is said when the step is asked for
            self._finish = weakref.finalize(self, end, self._process, self._owner)
            self._process.stdin.write(json.dumps([os.path.abspath(path), list(arrays), *rest]).encode() + b"\n")
        except OSError:
            self._is_over = True
            if self._finish:
                self._finish()
            self._process = None


def is_python(program):
    """Whether a program accepts Python's arguments: sys.executable may be empty, or embed Python."""
    name = os.path.basename(program or "").lower()
    return ("python" in name or "pypy" in name) and not getattr(sys, "frozen", False)


def states_of(files):
    """Modification time, size and inode number of each file; None for a file that does not exist."""
    states = []
    for file in files:
        try:
            found = os.stat(file)
            states.append((found.st_mtime_ns, found.st_size, found.st_ino))
        except OSError:
            states.append(None)
    return states


def end(process, owner):
    """Ends the process, unless it is called in a fork of the process that started it."""
    if os.getpid() != owner:
        return
    process.kill()
    with contextlib.suppress(OSError):  # a request that nobody reads any more
        process.stdin.close()
    try:
        process.wait(END_S)
    except subprocess.TimeoutExpired:
        return  # a thread still waits for it in stdout
    process.stdout.close()


def exchange(process, number, found):
    """Sends the number of a step and appends the answer, (number, packed), to found, unless the process has ended."""
    try:
        process.stdin.write(b"%d\n" % number)
        process.stdin.flush()
        line = process.stdout.readline()
        while line and line != MARK:
            line = process.stdout.readline()
        if line:
            found.append(pickle.load(process.stdout))
    except Exception:  # whatever it is, of a pipe that was closed or an answer that was cut: there is no mesh
        pass


def serve(descriptor):
    """Run the other process: read numbers of steps from standard input until it ends; answer to a file descriptor."""
    from .solutions import Solution

    answers = os.fdopen(descriptor, "wb")
    solution = None
    path, arrays, is_volume, is_lonlat = json.loads(sys.stdin.readline())
    for line in sys.stdin:
        packed = None
        try:
            solution = solution or Solution(path, arrays, is_volume, is_lonlat)
            packed = pack(solution.step(int(line)))
            solution.forget()  # its file may have changed when it is asked for again
        except Exception:  # whatever it is: the other process will meet it, too, and say it
            pass
        answers.write(b"\n" + MARK)
        pickle.dump((int(line), packed), answers, protocol=5)
        answers.flush()


def pack(mesh):
    """A mesh as NumPy arrays; None if they cannot hold all of it."""
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
    arrays = [(of_cells, data.GetArrayName(i), vtk_to_numpy(data.GetArray(i)), components_of(data.GetArray(i)))
              for of_cells, data in ((False, mesh.GetPointData()), (True, mesh.GetCellData()))
              for i in range(data.GetNumberOfArrays())]
    return mesh.GetClassName(), vtk_to_numpy(mesh.GetPoints().GetData()), cells, arrays


def components_of(array):
    """The names of an array's components; None for one without a name."""
    return [array.GetComponentName(i) for i in range(array.GetNumberOfComponents())]


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
    for of_cells, name, values, components in arrays:
        array = numpy_to_vtk(values, deep=True)
        array.SetName(name)
        for i, component in enumerate(components):
            if component is not None:
                array.SetComponentName(i, component)
        (mesh.GetCellData() if of_cells else mesh.GetPointData()).AddArray(array)
    return mesh
