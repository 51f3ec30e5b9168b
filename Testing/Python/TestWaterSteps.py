# SPDX-License-Identifier: BSD-3-Clause
"""Steps of a solver's data that use what the last ones made: no step shows in another one."""

import ctypes
import resource

import numpy as np
import pytest
import TestWaterShoreCut as cut
import water_test as wt
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkIdList, vtkPoints, vtkSMPTools
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkwater import vtkWaterLakes

PAGE = 4096  # bytes
M_MMAP_THRESHOLD = -3  # of malloc.h


@pytest.fixture(autouse=True)
def _rules_of_hardware(monkeypatch):
    monkeypatch.setenv("VTK_WATER_SOFTWARE", "0")


def drawn_mesh(lakes, number=0):
    """What is drawn: with land, cut by the graphics card. None: there is no water."""
    algorithm = lakes.GetWater(number).GetMapper().GetInputAlgorithm()
    return algorithm.GetInputDataObject(0, 0) if algorithm.GetNumberOfInputPorts() else None


def tide_of(depth_of=cut.tide_depth, **others):
    made = cut.Tide(vtkWaterLakes.CUT_WHILE_DRAWN, depth_of, **others)
    made.view.picture()
    assert made.water.GetIsShoreCutWhileDrawn()
    return made


def values_of(mesh):
    points = mesh.GetPointData()
    return [vtk_to_numpy(mesh.GetPoints().GetData()).copy(),
            *(vtk_to_numpy(points.GetArray(name)).copy() for name in ("WaterLevel", "WaterDepth", "Normals")
              if points.GetArray(name))]


def shallow_copy(mesh):
    copy = vtkPolyData()
    copy.ShallowCopy(mesh)
    return copy


def shared_memory(mesh):
    """The points' array as another array with the same memory."""
    array, points, copy = vtkDoubleArray(), vtkPoints(), vtkPolyData()
    array.ShallowCopy(mesh.GetPoints().GetData())
    points.SetData(array)
    copy.SetPoints(points)
    return copy


@pytest.mark.parametrize("hold", (lambda mesh: mesh, shallow_copy, shared_memory), ids=("itself", "shallow", "memory"))
def test_a_held_step_stays_as_it_is(hold):
    tide = tide_of()
    held = hold(drawn_mesh(tide.water))
    before = values_of(held)
    for step in range(1, 8):
        tide.set_step(step)
        tide.view.picture()
    moved = np.abs(values_of(drawn_mesh(tide.water))[0] - before[0]).max()
    wt.check_at_least("what the tide moves points by", moved, 0.1)
    off = max(np.abs(one - other).max() for one, other in zip(values_of(held), before))
    wt.check_equal("held step: what its values change by", off, 0.0)


def test_a_held_numpy_view_stays_as_it_is():
    tide = tide_of()
    views = [vtk_to_numpy(array) for array in (drawn_mesh(tide.water).GetPoints().GetData(),
                                               drawn_mesh(tide.water).GetPointData().GetArray("WaterDepth"))]
    before = [view.copy() for view in views]
    for step in range(1, 8):
        tide.set_step(step)
        tide.view.picture()
    for view, kept in zip(views, before):
        wt.check_equal("held view: values that changed", int((view != kept).sum()), 0)


def check_same(name, tide, fresh):
    """Every number of what is drawn, and every pixel, as of water that has had no other step."""
    picture, expected = tide.view.picture().astype(int), fresh.view.picture().astype(int)
    waters = fresh.water.GetNumberOfWaters()
    wt.check_equal(f"{name}: waters", tide.water.GetNumberOfWaters(), waters)
    for number in range(waters):
        one, other = drawn_mesh(tide.water, number), drawn_mesh(fresh.water, number)
        if one is None or other is None:
            assert one is other
            continue
        for ours, theirs in zip(values_of(one), values_of(other)):
            assert np.array_equal(ours, theirs), name
    wt.check_equal(f"{name}: pixels off", int((picture != expected).any(axis=2).sum()), 0)


def wave_depth(bed, step):
    """Lakes that join and part: none, some, all of it wet, and back."""
    x = np.linspace(0, 40, len(bed))
    return 3.5 * np.sin(0.7 * step) + np.sin(x + step) - bed


def dry_depth(bed, step):
    return np.full(len(bed), -1.0) if step % 3 == 0 else cut.tide_depth(bed, step)


@pytest.mark.parametrize("areas_have_quads", (False, True))
@pytest.mark.parametrize("depth_of", (cut.tide_depth, cut.ponds_depth, wave_depth, dry_depth))
def test_steps_do_not_depend_on_steps_before(depth_of, areas_have_quads):
    tide = cut.Tide(vtkWaterLakes.CUT_WHILE_DRAWN, depth_of, areas_have_quads=areas_have_quads)
    for step in (1, 2, 3, 9, 4, 2, 2):
        fresh = cut.Tide(vtkWaterLakes.CUT_WHILE_DRAWN, depth_of, areas_have_quads=areas_have_quads)
        for each in (tide, fresh):
            each.set_step(step)
        check_same(f"{depth_of.__name__} {step}", tide, fresh)


def shuffled(cells):
    """The same polygons in another order."""
    made, corners = vtkCellArray(), vtkIdList()
    for cell in np.random.default_rng(4).permutation(cells.GetNumberOfCells()).tolist():
        cells.GetCellAtId(cell, corners)
        made.InsertNextCell(corners)
    return made


def test_a_new_mesh_is_seen():
    """Other polygons, half of them, also in place, and points that have moved, after steps in which they were the same."""
    tide = tide_of(cut.ponds_depth)
    for step in (1, 2):  # what is kept of a mesh is made when it comes again
        tide.set_step(step)
        tide.view.picture()
    for change in ("in place", "quads", "order", "points"):
        fresh = cut.Tide(vtkWaterLakes.CUT_WHILE_DRAWN, cut.ponds_depth)
        for each in (tide, fresh):
            if change == "in place":  # every second triangle becomes a point; the time of the cells stays
                ids = each.mesh.GetPolys().GetConnectivityArray()
                corners = vtk_to_numpy(ids).reshape(-1, 3)
                corners[::2] = corners[::2, :1]
                ids.Modified()
            elif change == "order":
                each.mesh.SetPolys(shuffled(cut.quads()))
            elif change == "quads":
                each.mesh.SetPolys(cut.quads())
            else:
                each.mesh.SetPolys(cut.quads())
                places = vtk_to_numpy(each.mesh.GetPoints().GetData())
                places[:, 0] = each.places[:, 0] * 0.8
                each.mesh.GetPoints().GetData().Modified()
                each.mesh.GetPoints().Modified()
        for step in (3, 4, 5):
            for each in (tide, fresh):
                each.set_step(step)
            check_same(f"{change} {step}", tide, fresh)


def test_land_that_is_flooded_is_drawn():
    """Its triangles were none, all in one place, when the mesh came first: they must not be left out of VTK's list."""
    tide = tide_of(lambda bed, step: (-2.0 if step == 0 else 2.0) - bed)
    before = tide.view.picture().astype(int)
    tide.set_step(1)
    after = tide.view.picture().astype(int)
    fresh = tide_of(lambda bed, step: 2.0 - bed)
    wt.check_at_least("flooded: pixels that change, %", 100 * (before != after).any(axis=2).mean(), 20)
    wt.check_equal("flooded: pixels off", int((after != fresh.view.picture()).any(axis=2).sum()), 0)


class Basin:
    """Water of a mesh of many quads, without a picture after the first."""

    def __init__(self, side):
        self.x, self.y = (each.ravel() for each in np.meshgrid(*2 * [np.linspace(-10, 10, side)]))
        self.bed = 0.06 * (self.x**2 + self.y**2) - 3.0
        first = (np.arange(side - 1)[:, None] * side + np.arange(side - 1)).ravel()
        quads = np.stack([first, first + 1, first + side + 1, first + side], axis=1)
        self.mesh, cells, points = vtkPolyData(), vtkCellArray(), vtkPoints()
        cells.SetData(*(numpy_to_vtkIdTypeArray(part, deep=True)
                        for part in (4 * np.arange(len(quads) + 1), quads.ravel())))
        points.SetData(numpy_to_vtk(np.column_stack([self.x, self.y, self.bed]), deep=True))
        self.mesh.SetPoints(points)
        self.mesh.SetPolys(cells)
        cut.tide.add(self.mesh, "zb", self.bed)
        self.source = cut.vtkTrivialProducer()
        self.source.SetOutput(self.mesh)
        self.view = wt.View((64, 48), (0.2, 0.3, 0.5))
        self.set_step(0)
        self.water = vtkWaterLakes()
        self.water.SetData(self.source.GetOutputPort(), "", "h", "zb")
        self.water.SetShoreCut(vtkWaterLakes.CUT_WHILE_DRAWN)
        self.water.AddTo(self.view.renderer)
        self.view.renderer.GetActiveCamera().SetPosition(0, -22, 14)
        self.view.picture()
        assert self.water.GetIsShoreCutWhileDrawn()

    def set_step(self, step):
        level = 0.3 * np.sin(0.3 * step) + 0.2 * np.sin(2 * self.x + step)
        cut.tide.add(self.mesh, "h", level - self.bed)
        self.mesh.Modified()
        self.source.Modified()


@pytest.fixture
def _threads_as_before():
    backend = vtkSMPTools.GetBackend()
    yield
    vtkSMPTools.SetBackend(backend)


def test_threads_make_the_same(_threads_as_before):
    """Several blocks of cells, whose points are shared."""
    made = []
    for backend in ("Sequential", "STDThread"):
        if not vtkSMPTools.SetBackend(backend):
            pytest.skip(f"this VTK has no {backend}")
        basin = Basin(400)
        for step in (1, 2, 3):
            basin.set_step(step)
            basin.water.Update()
        made.append(values_of(drawn_mesh(basin.water)))
    wt.check_equal("arrays", [len(arrays) for arrays in made], [4, 4])
    for one, other in zip(*made):
        wt.check_equal("threads: values off", int((one != other).sum()), 0)


def test_memory_is_used_again():
    """The system gives a process no new memory for a step, and the process does not grow."""
    if not hasattr(ctypes.CDLL(None), "mallopt"):
        pytest.skip("this C library has no mallopt")
    ctypes.CDLL(None).mallopt(M_MMAP_THRESHOLD, 1 << 20)  # large arrays come from the system, and go back to it
    basin = Basin(700)
    faults, sizes = [], []
    for step in range(1, 101):
        basin.set_step(step)
        before = resource.getrusage(resource.RUSAGE_SELF).ru_minflt
        basin.water.Update()
        faults.append(resource.getrusage(resource.RUSAGE_SELF).ru_minflt - before)
        with open("/proc/self/statm", encoding="ascii") as file:
            sizes.append(int(file.read().split()[1]) * PAGE / 2**20)
    own = 8 * basin.mesh.GetNumberOfPoints() / PAGE  # pages of an array of a step
    wt.check_at_most("memory: new pages of a step, of an array's", float(np.median(faults[5:])) / own, 0.5)
    wt.check_at_most("memory: growth over the last 50 steps, MB", max(sizes[50:]) - min(sizes[50:]), 16)
