# SPDX-License-Identifier: BSD-3-Clause
"""Steps that another process reads ahead are those that this one would have read, and so are their errors."""

import gc
import time

import numpy as np
import pytest
import water_test as wt
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkIdList, vtkPoints
from vtkmodules.vtkCommonDataModel import VTK_POLYHEDRON, VTK_TETRA, vtkUnstructuredGrid
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter, vtkXMLUnstructuredGridWriter
from vtkwater import ahead, solutions
from vtkwater.readers import FileError

STEPS = 6


def add_array(data, name, values):
    array = numpy_to_vtk(values, deep=True)
    array.SetName(name)
    data.AddArray(array)


def flood(step):
    """A plane whose points, depths and speeds change from step to step, in single and double precision."""
    source = vtkPlaneSource()
    source.SetResolution(8, 8)
    source.Update()
    mesh = source.GetOutput()
    places = vtk_to_numpy(mesh.GetPoints().GetData()).astype(float)
    places[:, 2] = 0.1 * step
    points = vtkPoints()
    points.SetData(numpy_to_vtk(places, deep=True))
    mesh.SetPoints(points)
    add_array(mesh.GetPointData(), "h", np.float32(places[:, 0] + step))
    add_array(mesh.GetCellData(), "v", np.full((64, 3), float(step)))
    add_array(mesh.GetCellData(), "unused", np.zeros(64))
    return mesh


def grid(step):
    """A tetrahedron."""
    mesh = vtkUnstructuredGrid()
    points = vtkPoints()
    for place in ((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)):
        points.InsertNextPoint(place)
    mesh.SetPoints(points)
    mesh.InsertNextCell(VTK_TETRA, 4, [0, 1, 2, 3])
    add_array(mesh.GetPointData(), "h", np.arange(4.0) + step)
    return mesh


def write_series(folder, mesh_of=flood, kind="vtp"):
    writer = vtkXMLPolyDataWriter() if kind == "vtp" else vtkXMLUnstructuredGridWriter()
    entries = []
    for step in range(STEPS):
        writer.SetFileName(str(folder / f"{step}.{kind}"))
        writer.SetInputData(mesh_of(step))
        writer.Write()
        entries.append(f'<DataSet timestep="{10.0 * step}" file="{step}.{kind}"/>')
    path = folder / "series.pvd"
    path.write_text(f'<VTKFile type="Collection"><Collection>{"".join(entries)}</Collection></VTKFile>')
    return path


def contents(mesh):
    """All of a mesh, for a comparison."""
    cells = mesh.GetPolys() if mesh.IsA("vtkPolyData") else mesh.GetCells()
    made = [mesh.GetClassName(), vtk_to_numpy(mesh.GetPoints().GetData()), vtk_to_numpy(cells.GetOffsetsArray()),
            vtk_to_numpy(cells.GetConnectivityArray())]
    for data in (mesh.GetPointData(), mesh.GetCellData()):
        for i in range(data.GetNumberOfArrays()):
            made += [data.GetArrayName(i), vtk_to_numpy(data.GetArray(i))]
    return made


def are_equal(one, other):
    one, other = contents(one), contents(other)
    return len(one) == len(other) and all(
        np.array_equal(a, b) and getattr(a, "dtype", None) == getattr(b, "dtype", None) for a, b in zip(one, other))


def read_here(monkeypatch):
    """The numbers of the steps that are read in this process from now on."""
    numbers, made = [], solutions.Solution._made

    def remember(self, i):
        numbers.append(i)
        return made(self, i)

    monkeypatch.setattr(solutions.Solution, "_made", remember)
    return numbers


@pytest.mark.parametrize("mesh_of, kind, arrays, is_volume", (
    (flood, "vtp", ["h", "v"], False), (grid, "vtu", ["h"], True)), ids=("surface", "volume"))
def test_a_time_has_the_same_mesh_whatever_was_read_ahead(tmp_path, mesh_of, kind, arrays, is_volume):
    """Forwards, backwards, and in leaps; at steps, and between them."""
    path = write_series(tmp_path, mesh_of, kind)
    times = np.concatenate([np.linspace(0, 50, 11), np.linspace(50, 0, 11),
                            np.random.default_rng(1).uniform(0, 50, 12)])
    plain = solutions.Solution(path, arrays, is_volume)
    with_ahead = solutions.Solution(path, arrays, is_volume, read_ahead=True)
    wt.check_equal("times with the same mesh",
                   sum(are_equal(plain.at(at), with_ahead.at(at)) for at in times), len(times))


def test_the_next_step_comes_from_the_other_process(tmp_path, monkeypatch):
    """Played forwards all but the first steps do, and backwards all but the last."""
    solution = solutions.Solution(write_series(tmp_path), ["h"], read_ahead=True)
    numbers = read_here(monkeypatch)
    for step in range(STEPS):
        solution.step(step)
    wt.check_equal("steps read here", numbers, [1])  # 0 when it was opened, and nothing was ahead yet
    for step in reversed(range(STEPS)):
        solution.step(step)
    wt.check_equal("steps read here, and backwards", numbers, [1, STEPS - 3])


def test_an_error_is_raised_when_its_step_is_asked_for(tmp_path):
    """And again each time, with the text that it has without reading ahead; the steps around it are well."""
    path = write_series(tmp_path)
    (tmp_path / "3.vtp").write_text("damaged")
    plain, texts = solutions.Solution(path, ["h"]), []
    with pytest.raises(FileError) as caught:
        plain.step(3)
    solution = solutions.Solution(path, ["h"], read_ahead=True)
    for step in (0, 1, 2, 3, 4, 5, 3):
        try:
            solution.step(step)
        except FileError as error:
            texts.append((step, str(error)))
    wt.check_equal("errors", texts, [(3, str(caught.value)), (3, str(caught.value))])


def test_steps_are_read_without_the_other_process(tmp_path, monkeypatch):
    """When it has been ended, and where it cannot be started."""
    path = write_series(tmp_path)
    solution = solutions.Solution(path, ["h"], read_ahead=True)
    solution.step(1)
    solution._ahead._process.kill()
    numbers = read_here(monkeypatch)
    for step in range(2, STEPS):
        wt.check_equal(f"h of step {step}", float(vtk_to_numpy(solution.step(step).GetPointData().GetArray("h"))[0]),
                       step - 0.5)
    wt.check_at_least("steps read here", len(numbers), STEPS - 3)
    monkeypatch.setattr(ahead.sys, "executable", str(tmp_path / "none"))
    other = solutions.Solution(path, ["h"], read_ahead=True)
    wt.check_equal("h", [float(vtk_to_numpy(other.step(step).GetPointData().GetArray("h"))[0])
                         for step in range(STEPS)], [step - 0.5 for step in range(STEPS)])


def test_the_other_process_ends_with_the_solution(tmp_path):
    solution = solutions.Solution(write_series(tmp_path), ["h"], read_ahead=True)
    solution.step(1)
    process = solution._ahead._process
    wt.check_equal("runs", process.poll() is None, True)
    del solution
    gc.collect()
    begin = time.monotonic()
    while process.poll() is None and time.monotonic() - begin < 10:
        time.sleep(0.05)
    wt.check_equal("has ended", process.poll() is not None, True)


def test_short_series_need_no_other_process(tmp_path):
    path = write_series(tmp_path)
    solution = solutions.Solution(tmp_path / "0.vtp", ["h"], read_ahead=True)
    wt.check_equal("one step", solution._ahead, None)
    wt.check_equal("by default", solutions.Solution(path, ["h"])._ahead, None)


def test_what_arrays_do_not_hold_is_not_sent():
    mesh = grid(0)
    wt.check_equal("a tetrahedron", ahead.pack(mesh) is not None, True)
    faces = [4, 3, 0, 1, 2, 3, 0, 1, 3, 3, 1, 2, 3, 3, 0, 2, 3]
    ids = vtkIdList()
    for value in faces:
        ids.InsertNextId(value)
    mesh.InsertNextCell(VTK_POLYHEDRON, ids)
    wt.check_equal("a polyhedron", ahead.pack(mesh), None)
