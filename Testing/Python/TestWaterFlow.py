# SPDX-License-Identifier: BSD-3-Clause
"""A current carries the small waves over a mesh: their pictures move at its speed, where it changes it stretches them,
and where there is none they are as they were."""

import numpy as np
import pytest
import water_test as wt
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersCore import vtkTriangleFilter
from vtkmodules.vtkRenderingCore import vtkDataSetMapper, vtkPolyDataMapper
from vtkwater import vtkWaterActor, vtkWaterClearSkySource, vtkWaterLakes

SIZE = (96, 96)
LARGE = (270, 270)  # where speeds are measured
HALF = 6.0  # m, of the part in view
CELLS = 60
PERIOD = 4.0
STEP = 0.1  # s
PIXELS_PER_M = LARGE[1] / (2 * HALF)
MOST_OFF = 0.02  # of the speed


def mesh_of(current, bumps=0.0, of_cells=False, components=3):
    """A square of the water, larger than the view, with the current of a function of x and y."""
    side = np.linspace(-1.5 * HALF, 1.5 * HALF, CELLS + 1)
    x, y = (each.ravel() for each in np.meshgrid(side, side))
    z = bumps * np.sin(0.5 * x) * np.sin(0.4 * y)
    first = (np.arange(CELLS)[:, None] * (CELLS + 1) + np.arange(CELLS)).ravel()
    quads = np.stack([first, first + 1, first + CELLS + 2, first + CELLS + 1], axis=1)
    mesh, points, polygons = vtkPolyData(), vtkPoints(), vtkCellArray()
    points.SetDataTypeToDouble()
    points.SetData(numpy_to_vtk(np.column_stack([x, y, z]), deep=True))
    for quad in quads:
        polygons.InsertNextCell(4, quad.tolist())
    mesh.SetPoints(points)
    mesh.SetPolys(polygons)
    places = (x, y) if not of_cells else (x[quads].mean(axis=1), y[quads].mean(axis=1))
    u, v = np.broadcast_arrays(*(np.asarray(part, float) for part in current(*places)), places[0])[:2]
    array = numpy_to_vtk(np.column_stack([u, v, 0.0 * u])[:, :components].copy(), deep=True)
    array.SetName("velocity")
    (mesh.GetCellData() if of_cells else mesh.GetPointData()).AddArray(array)
    return mesh


class Scene:
    """Waves that do not move by themselves on a mesh, seen from above in parallel: the share that each pixel reflects."""

    def __init__(self, mesh, name="velocity", mapper=None, waves="map", size=SIZE):
        self.view = wt.View(size)
        self.water = vtkWaterActor()
        self.mapper = mapper or vtkPolyDataMapper()
        self.mapper.SetInputDataObject(mesh)
        self.water.SetMapper(self.mapper)
        self.look = self.water.GetWaterProperty()
        self.look.SetOutputToReflectance()
        if waves == "map":
            self.look.AddNormalMap(None, 3.0, 0.0, 0.0, 0.6)
        elif waves == "sea":
            self.look.SeaOn()
        self.errors = wt.errors_of(self.water)
        self.water.SetFlowPeriod(PERIOD)
        self.water.SetFlowArrayName(name)
        self.view.renderer.AddActor(self.water)
        camera = wt.place_camera(self.view.renderer, (0, -40, 40), (0, 0, 0), (1, 200))
        camera.ParallelProjectionOn()
        camera.SetParallelScale(HALF)

    def at(self, time):
        """What each pixel reflects, 16 bits; a row is a line along x, and rows are sin 45 degrees closer along y."""
        self.water.SetTime(time)
        return self.view.picture()[:, :, :2] @ (256.0, 1.0)


def moved_back(picture, shift):
    """A picture, moved by a part of a pixel: by the phases of its spectrum."""
    rows, columns = (np.fft.fftfreq(size) for size in picture.shape)
    phases = np.exp(2j * np.pi * (shift[1] * rows[:, None] + shift[0] * columns))
    return np.fft.ifft2(np.fft.fft2(picture) * phases).real


def shift_between(first, second):
    """Columns and rows that the second picture's pattern has moved by: the peak of their phase correlation (Kuglin and
    Hines 1975), by a parabola, which is exact where it is in the middle of a pixel."""
    window = np.hanning(first.shape[0])[:, None] * np.hanning(first.shape[1])
    rows, columns = (np.fft.fftfreq(size) for size in first.shape)
    smooth = np.exp(-0.5 * (rows[:, None]**2 + columns**2) / 0.06**2)  # the finest details are rounded
    first = first - first.mean()
    second = second - second.mean()
    total = np.zeros(2)
    for _ in range(3):
        spectra = [np.fft.fft2(picture * window) for picture in (first, moved_back(second, total))]
        both = spectra[1] * np.conj(spectra[0])
        found = np.fft.fftshift(np.fft.ifft2(smooth * both / (np.abs(both) + 1e-6 * np.abs(both).max())).real)
        row, column = np.unravel_index(found.argmax(), found.shape)
        column_part, row_part = (0.5 * (before - after) / (before - 2 * at + after) for before, at, after in
                                 (found[row, column - 1:column + 2], found[row - 1:row + 2, column]))
        total += (column + column_part - first.shape[1] // 2, row + row_part - first.shape[0] // 2)
    return total


def speed_of(scene, times):
    """m/s along x and y of what moves between pictures."""
    moves = [shift_between(scene.at(time), scene.at(time + STEP)) for time in times]
    return np.mean(moves, axis=0) / STEP / PIXELS_PER_M * (1.0, np.sqrt(2.0))


CURRENT = (1.9, -1.1)


def uniform(x, y):
    return CURRENT


def still(x, y):
    return 0.0, 0.0


@pytest.mark.parametrize("is_software, kind", ((1, "flat"), (1, "bumps"), (0, "flat"), (0, "bumps")))
def test_waves_move_at_the_currents_speed(kind, is_software, monkeypatch):
    """All over a period, in pictures a tenth of a second apart, within 2 % of the speed."""
    monkeypatch.setenv("VTK_WATER_SOFTWARE", str(is_software))
    scene = Scene(mesh_of(uniform, 0.02 if kind == "bumps" else 0.0), size=LARGE)
    found = speed_of(scene, np.arange(4) * PERIOD / 4 + 0.05)
    wt.save(scene.view.picture(), wt.output_folder() / f"flow_{kind.replace(' ', '_')}.png")
    off = np.hypot(*(found - CURRENT)) / np.hypot(*CURRENT)
    wt.check_at_most(f"{kind}: {found} m/s, off by", off, MOST_OFF)


def test_every_kind_of_array_carries_waves_alike():
    """Currents of cells, of 2 components and in a data set mapper show what that of points shows, pixel by pixel."""
    scene = Scene(mesh_of(uniform))
    others = {"cells": Scene(mesh_of(uniform, of_cells=True)), "2 components": Scene(mesh_of(uniform, components=2)),
              "data set mapper": Scene(mesh_of(uniform), mapper=vtkDataSetMapper())}
    for time in (0.05, 1.5, 3.1):
        picture = scene.at(time)
        for name, other in others.items():
            wt.check_equal(f"{name}, {time} s: pixels that differ", int((other.at(time) != picture).sum()), 0)


@pytest.mark.parametrize("waves, is_software", (("map", 1), ("sea", 1), ("sea", 0)))
def test_no_current_is_as_without(waves, is_software, monkeypatch):
    """Zeros, and velocities that are no numbers, leave every pixel as it is without a current."""
    monkeypatch.setenv("VTK_WATER_SOFTWARE", str(is_software))
    without = Scene(mesh_of(still), name="", waves=waves)
    nothing = Scene(mesh_of(lambda x, y: (0.0 * x + np.where(x < 0, np.nan, 9.97e36), 0.0 * x + np.inf)), waves=waves)
    zeros = Scene(mesh_of(still), waves=waves)
    moving = Scene(mesh_of(uniform), waves=waves)
    for time in (0.0, 7.9):
        picture = without.at(time)
        wt.check_at_least("reflectance varies", float(picture.std()), 20.0)
        wt.check_equal("pixels that differ with zeros", int((zeros.at(time) != picture).sum()), 0)
        wt.check_equal("pixels that differ with no numbers", int((nothing.at(time) != picture).sum()), 0)
        wt.check_at_least("pixels that a current changes", int((moving.at(time) != picture).sum()), 0.5 * picture.size)
    wt.check_equal("errors", zeros.errors + nothing.errors + moving.errors, [])


def test_an_accelerating_current_stretches_the_waves():
    """In the middle of its period a layer has gone u T / 2: what was at 1 - T / 2 du/dx of a place's x is there now."""
    gradient = 0.12  # 1/s
    even, stretched = (Scene(mesh_of(current), size=LARGE).at(0.5 * PERIOD)
                       for current in (uniform, lambda x, y: (1.9 + gradient * x, -1.1)))
    columns = np.arange(LARGE[0]) - 0.5 * (LARGE[0] - 1)
    shares = np.arange(0.5, 1.2, 0.01)
    likeness = []
    for share in shares:
        at = share * columns + 0.5 * (LARGE[0] - 1)
        resampled = np.stack([np.interp(at, np.arange(LARGE[0]), row) for row in even])[:, 45:-45]
        likeness.append(np.corrcoef(resampled.ravel(), stretched[:, 45:-45].ravel())[0, 1])
    found = float(shares[np.argmax(likeness)])
    wt.check_at_least("correlation there", max(likeness), 0.8)
    wt.check_at_most(f"waves are 1 / {found:.2f} times as long; the share is off by",
                     abs(found - (1.0 - 0.5 * PERIOD * gradient)), 0.015)


def test_the_variance_of_the_slopes_does_not_pulse():
    """While two layers share the weight the waves are as high as those of one."""
    scene = Scene(mesh_of(uniform), size=(160, 160))
    spread = [scene.at(time).std() for time in np.arange(8) * PERIOD / 8]
    wt.check_at_most("largest over smallest spread of the reflectance", max(spread) / min(spread), 1.15)


@pytest.mark.parametrize("speed, is_software", ((0.5, 1), (2.0, 1), (2.0, 0)))
def test_a_wind_seas_ripples_do_not_pulse(speed, is_software, monkeypatch):
    """Waves of all lengths: the short ones are unlike in the two layers, and the long ones alike. Over a period the
    variance stays within 20 % of its mean, where it would be halved."""
    monkeypatch.setenv("VTK_WATER_SOFTWARE", str(is_software))
    scene = Scene(mesh_of(lambda x, y: (speed, 0.0)), waves="none", size=(160, 160))
    scene.look.SeaOn()
    scene.look.SetWindSpeed(7.0)
    scene.look.SetMetresPerUnit(1.0)
    variances = np.mean([[scene.at(PERIOD * (4 + turn + part / 8)).var() for part in range(8)] for turn in range(3)],
                        axis=0)
    wt.check_at_most(f"{speed} m/s: largest change of the variance, of its mean",
                     float(np.abs(variances / variances.mean() - 1).max()), 0.2)


def test_the_picture_depends_on_the_time_alone():
    scene = Scene(mesh_of(uniform))
    first = scene.at(1.7)
    for time in (100.3, -4.2, 1e9):
        scene.at(time)
    wt.check_equal("pixels that differ", int((scene.at(1.7) != first).sum()), 0)
    wt.check_equal("of a new scene", int((Scene(mesh_of(uniform)).at(1.7) != first).sum()), 0)


def test_the_current_follows_its_array_and_the_actors_matrix():
    """New values are shown in the next frame; a turned actor turns its current, and a large one keeps its speed."""
    mesh = mesh_of(still)
    scene = Scene(mesh)
    before = scene.at(1.0)
    values = mesh_of(uniform).GetPointData().GetArray("velocity")
    mesh.GetPointData().AddArray(values)
    changed = scene.at(1.0)
    wt.check_equal("as a new scene", int((changed != Scene(mesh_of(uniform)).at(1.0)).sum()), 0)
    wt.check_at_least("pixels that changed", int((before != changed).sum()), 0.5 * before.size)
    scene = Scene(mesh_of(lambda x, y: (-1.1, -1.9)), size=LARGE)
    turn = vtkTransform()
    turn.RotateZ(90.0)
    turn.Scale(2.0, 2.0, 5.0)
    scene.water.SetUserTransform(turn)
    found = speed_of(scene, np.arange(4) * PERIOD / 4 + 0.05)
    off = np.hypot(*(found - (1.9, -1.1))) / np.hypot(1.9, 1.1)
    wt.check_at_most(f"turned: {found} m/s, off by", off, MOST_OFF)


@pytest.mark.parametrize("name, components, words", (
    ("speed", 3, ("no numeric array 'speed'", "velocity")), ("velocity", 1, ("1 component;", "2 or 3"))))
def test_a_wrong_array_is_an_error_once(name, components, words):
    """The picture is the one without a current, and a right array works after it."""
    mesh = mesh_of(uniform, components=components)
    scene = Scene(mesh, name=name)
    without = Scene(mesh, name="")
    for time in (0.4, 1.1):
        wt.check_equal("pixels that differ", int((scene.at(time) != without.at(time)).sum()), 0)
    wt.check_equal("errors", len(scene.errors), 1)
    for word in words:
        wt.check(f"'{word}' is in the error", word in scene.errors[0], True, word in scene.errors[0])
    mesh.GetPointData().AddArray(mesh_of(uniform).GetPointData().GetArray("velocity"))
    scene.water.SetFlowArrayName("velocity")
    wt.check_at_least("pixels that change", int((scene.at(1.1) != without.at(1.1)).sum()), 1000)
    wt.check_equal("errors after that", len(scene.errors), 1)


@pytest.mark.parametrize("of_cells", (False, True), ids=("points", "cells"))
@pytest.mark.parametrize("more", (-1, 1, None), ids=("one_too_few", "one_too_many", "none"))
def test_an_array_of_another_length_is_an_error(of_cells, more):
    """There is no current then."""
    mesh = mesh_of(uniform, of_cells=of_cells)
    array = (mesh.GetCellData() if of_cells else mesh.GetPointData()).GetArray("velocity")
    count = array.GetNumberOfTuples()
    array.SetNumberOfTuples(0 if more is None else count + more)
    scene, without = Scene(mesh), Scene(mesh_of(still), name="")
    wt.check_equal("pixels that differ", int((scene.at(0.4) != without.at(0.4)).sum()), 0)
    wt.check_equal("errors", len(scene.errors), 1)
    wt.check_equal("the last error is of the current", "no current" in scene.water.GetLastError(), True)
    for word in ("velocity", str(count), str(array.GetNumberOfTuples())):
        wt.check(f"'{word}' is in the error", word in scene.errors[0], True, word in scene.errors[0])


def test_settings_are_checked_copied_and_printed():
    water = vtkWaterActor()
    errors = wt.errors_of(water)
    for wrong in (0.0, -1.0, float("nan"), 1e7):
        water.SetFlowPeriod(wrong)
    wt.check_equal("errors", (len(errors), water.GetFlowPeriod()), (4, 4.0))
    water.SetFlowPeriod(2.5)
    water.SetFlowArrayName("u")
    copied = vtkWaterActor()
    copied.ShallowCopy(water)
    wt.check_equal("copied", (copied.GetFlowArrayName(), copied.GetFlowPeriod()), ("u", 2.5))
    wt.check("printed", "u and 2.5", "both", "FlowArrayName: u" in str(water) and "FlowPeriod: 2.5" in str(water))
    sheet = Scene(mesh_of(uniform))
    sheet.water.SetMapper(None)
    sheet.at(0.0)
    wt.check_equal("errors of a sheet without arrays", len(sheet.errors), 1)


def test_waters_of_one_mesh_flow_alike():
    """vtkWaterLakes gives its parts the current."""
    lakes = vtkWaterLakes()
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(mesh_of(uniform))
    lakes.SetMapper(mapper)
    water = lakes.GetWater()
    scene = Scene(mesh_of(uniform))
    alone = scene.at(1.0)
    scene.view.renderer.RemoveActor(scene.water)
    water.SetWaterProperty(scene.look)
    water.SetFlowArrayName("velocity")
    water.SetFlowPeriod(PERIOD)
    water.SetTime(1.0)
    lakes.AddTo(scene.view.renderer)
    shown = scene.view.picture()[:, :, :2] @ (256.0, 1.0)
    wt.check_equal("pixels that differ", int((shown != alone).sum()), 0)
