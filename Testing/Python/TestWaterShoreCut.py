# SPDX-License-Identifier: BSD-3-Clause
"""A shore that the renderer cuts while it draws is the one that the filter cuts."""

import numpy as np
import pytest
import TestWaterShoreline as tide
import water_test as wt
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkCommonExecutionModel import vtkTrivialProducer
from vtkwater import vtkWaterLakes

STEPS = (0, 3, 7)
SIZE = (320, 240)


@pytest.fixture(autouse=True)
def _rules_of_hardware(monkeypatch):
    monkeypatch.setenv("VTK_WATER_SOFTWARE", "0")


def quads():
    cells, row = vtkCellArray(), tide.CELLS + 1
    for j in range(tide.CELLS):
        for i in range(tide.CELLS):
            first = j * row + i
            cells.InsertNextCell(4, [first, first + 1, first + row + 1, first + row])
    return cells


class Tide:
    """Water of a mesh over its bed, which rises out of it, with a ball; the depth is what a function of bed and step says."""

    def __init__(self, cut, depth_of, areas_have_quads=False, refracts=False, samples=0):
        self.mesh, self.places = tide.grid()
        if areas_have_quads:
            self.mesh.SetPolys(quads())
        self.depth_of = depth_of
        self.view = wt.View(SIZE, (0.2, 0.3, 0.5), samples=samples)
        wt.add_actor(self.view.renderer, self.mesh, (0.8, 0.4, 0.1), lit=False)
        wt.add_actor(self.view.renderer, wt.sphere((2, 3, 2), 1.5), (0.9, 0.1, 0.1))
        self.source = vtkTrivialProducer()
        self.source.SetOutput(self.mesh)
        self.set_step(0)
        self.water = vtkWaterLakes()
        self.water.SetData(self.source.GetOutputPort(), "", "h", "zb")
        self.water.SetShoreCut(cut)
        self.water.GetWater().GetWaterProperty().SetRefraction(refracts)
        self.water.AddTo(self.view.renderer)
        camera = self.view.renderer.GetActiveCamera()
        camera.SetPosition(0, -22, 14)
        camera.SetFocalPoint(0, 0, 0)
        camera.SetViewUp(0, 0, 1)
        camera.SetViewAngle(40)

    def set_step(self, step):
        tide.add(self.mesh, "h", self.depth_of(self.places[:, 2], step))
        self.mesh.Modified()
        self.source.Modified()

    def pictures(self):
        made = []
        for step in STEPS:
            self.set_step(step)
            made.append(self.view.picture().astype(int))
        return made


def tide_depth(bed, step):
    return tide.level_of(step) - bed


def ponds_depth(bed, step):
    """Water at two levels, with dry land between."""
    return np.where(bed < 0, -1.0 - bed, 2.5 + 0.1 * step - bed)


def both(depth_of, **others):
    """The same pictures, cut in the filter and while they are drawn; and whether the latter were."""
    in_filter = Tide(vtkWaterLakes.CUT_IN_FILTER, depth_of, **others)
    drawn = Tide(vtkWaterLakes.CUT_WHILE_DRAWN, depth_of, **others)
    pairs = list(zip(in_filter.pictures(), drawn.pictures()))
    assert not in_filter.water.GetIsShoreCutWhileDrawn()
    return pairs, drawn


def worst_of(pairs, by=1):
    return max(100 * (np.abs(one - other).max(axis=2) > by).mean() for one, other in pairs)


@pytest.mark.parametrize("samples", (0, 4))
@pytest.mark.parametrize("refracts", (False, True))
@pytest.mark.parametrize("areas_have_quads", (False, True))
def test_pictures_are_those_of_the_filter(areas_have_quads, refracts, samples):
    """In quads the shore has a bend on the diagonal; samples of pixels at the shore may differ."""
    pairs, drawn = both(tide_depth, areas_have_quads=areas_have_quads, refracts=refracts, samples=samples)
    assert drawn.water.GetIsShoreCutWhileDrawn()
    name = f"{'quads' if areas_have_quads else 'triangles'}, {'clear' if refracts else 'opaque'}, {samples} samples"
    limit = 0.02 if not areas_have_quads and samples == 0 else 0.05
    wt.check_at_most(f"{name}: pixels off by more than 1 of 255, %", worst_of(pairs), limit)
    steps = [picture for _, picture in pairs]
    wt.check_at_least(f"{name}: pixels that the tide changes, %", worst_of([steps[:2]]), 5)


class Basin:
    """Water of 10,000 quads over a bed that curves, from straight above; it is all that is dark."""

    PICTURE, SIDE, HALF = (400, 300), 101, 500.0

    def __init__(self, cut, place=(0.0, 0.0)):
        self.mesh, points, cells = vtkPolyData(), vtkPoints(), vtkCellArray()
        self.x, self.y = (part.ravel() for part in np.meshgrid(*2 * [np.linspace(-self.HALF, self.HALF, self.SIDE)]))
        first = (np.arange(self.SIDE - 1)[:, None] * self.SIDE + np.arange(self.SIDE - 1)).ravel()
        for quad in np.stack([first, first + 1, first + self.SIDE + 1, first + self.SIDE], axis=1).tolist():
            cells.InsertNextCell(4, quad)
        points.SetData(numpy_to_vtk(np.column_stack([self.x + place[0], self.y + place[1], 0 * self.x]), deep=True))
        self.mesh.SetPoints(points)
        self.mesh.SetPolys(cells)
        tide.add(self.mesh, "zb", self.bed_at(self.x, self.y))
        self.source, self.water = vtkTrivialProducer(), vtkWaterLakes()
        self.source.SetOutput(self.mesh)
        self.view = wt.View(self.PICTURE, (1, 1, 1))
        self.set_step(0)
        self.water.SetData(self.source.GetOutputPort(), "", "h", "zb")
        self.water.SetShoreCut(cut)
        look = self.water.GetWater().GetWaterProperty()
        look.SetReflectanceModeToConstant()
        look.SetReflectance(0.0)
        look.SetDeepColor(0, 0, 0)
        self.water.AddTo(self.view.renderer)
        camera = wt.place_camera(self.view.renderer, (*place, 900), (*place, 0), (100, 2000), (0, 1, 0))
        camera.ParallelProjectionOn()
        camera.SetParallelScale(0.9 * self.HALF)

    @staticmethod
    def bed_at(x, y):
        return -8 + 10 * (np.hypot(x, y) / 500) ** 2 + 1.5 * np.sin(x / 60) * np.cos(y / 45)

    def depth_at(self, x, y, step):
        return 0.3 * np.sin(0.3 * step) + 0.05 * np.sin(x / 30 - 0.5 * step) - self.bed_at(x, y)

    def set_step(self, step):
        tide.add(self.mesh, "h", self.depth_at(self.x, self.y, step))
        self.mesh.Modified()
        self.source.Modified()

    def is_wet(self, step):
        self.set_step(step)
        return self.view.picture()[:, :, 0] < 128

    def shore_distance(self, step):
        """Pixels from each pixel to the zero of the depth, which is bilinear in a quad; positive where it is wet."""
        columns, rows = self.PICTURE
        scale = 2 * 0.9 * self.HALF / rows
        x, y = (np.arange(columns) + 0.5 - columns / 2) * scale, (np.arange(rows)[:, None] + 0.5 - rows / 2) * scale
        depth = self.depth_at(self.x, self.y, step).reshape(self.SIDE, self.SIDE)
        (i, u), (j, v) = (np.divmod(np.clip((place + self.HALF) / (2 * self.HALF) * (self.SIDE - 1), 0,
                                            self.SIDE - 1 - 1e-9), 1) for place in (x, y))
        i, j = i.astype(int), j.astype(int)
        found = ((1 - v) * ((1 - u) * depth[j, i] + u * depth[j, i + 1])
                 + v * ((1 - u) * depth[j + 1, i] + u * depth[j + 1, i + 1]))
        found[:, np.abs(x) > self.HALF] = np.nan
        return found / np.hypot(*np.gradient(found))


@pytest.mark.parametrize("cut", (vtkWaterLakes.CUT_IN_FILTER, vtkWaterLakes.CUT_WHILE_DRAWN), ids=("filter", "drawn"))
def test_the_shore_of_quads_is_within_half_a_pixel(cut):
    """Both ways to cut are exact to half a pixel, so where they differ, neither is wrong by more."""
    basin = Basin(cut)
    for step in (1, 4, 9):
        wet, distance = basin.is_wet(step), basin.shore_distance(step)
        wrong = np.isfinite(distance) & (wet != (distance > 0))
        wt.check_equal(f"step {step}: wrong pixels, over half a pixel off", int((np.abs(distance[wrong]) > 0.5).sum()), 0)
        wt.check_at_least(f"step {step}: pixels on the shore", int((np.abs(distance) < 1).sum()), 200)
        wt.check_at_least(f"step {step}: % that is wet", 100 * float(wet.mean()), 30)
    wt.check_equal("cut while drawn", basin.water.GetIsShoreCutWhileDrawn(), cut == vtkWaterLakes.CUT_WHILE_DRAWN)


@pytest.mark.parametrize("cut", (vtkWaterLakes.CUT_IN_FILTER, vtkWaterLakes.CUT_WHILE_DRAWN), ids=("filter", "drawn"))
def test_a_mesh_in_utm_coordinates_has_the_same_shore(cut):
    """Places are doubles, and stay so until VTK moves them to the middle of the mesh."""
    near, far = Basin(cut), Basin(cut, (500_000.0, 4_500_000.0))
    for step in (1, 4, 9):
        wt.check_equal(f"step {step}: pixels off", int((near.is_wet(step) != far.is_wet(step)).sum()), 0)
        wt.check_at_least(f"step {step}: % that is wet", 100 * float(far.is_wet(step).mean()), 30)
    wt.check_equal("cut while drawn", far.water.GetIsShoreCutWhileDrawn(), cut == vtkWaterLakes.CUT_WHILE_DRAWN)


def test_two_levels_of_water():
    pairs, drawn = both(ponds_depth)
    assert drawn.water.GetIsShoreCutWhileDrawn()
    wt.check_equal("two levels: waters", drawn.water.GetNumberOfWaters(), 2)
    wt.check_at_most("two levels: pixels off by more than 1 of 255, %", worst_of(pairs), 0.05)


def test_a_river_on_a_fine_mesh_is_no_row_of_lakes():
    """From point to point it falls by less than a film, and by more from one side of a dry point to the other."""
    row = np.arange((tide.CELLS + 1) ** 2) // (tide.CELLS + 1)
    pairs, drawn = both(lambda bed, step: tide_depth(bed, step) + 0.0009 * row, areas_have_quads=True)
    wt.check_equal("cut while drawn", drawn.water.GetIsShoreCutWhileDrawn(), True)
    wt.check_at_most("river: pixels off by more than 1 of 255, %", worst_of(pairs), 0.05)


def test_no_water_at_all():
    pairs, drawn = both(lambda bed, step: np.full(len(bed), -1.0))
    assert drawn.water.GetIsShoreCutWhileDrawn()
    wt.check_at_most("dry: pixels off, %", worst_of(pairs, 0), 0)


def test_depths_that_are_no_numbers():
    """They are dry, whoever cuts."""

    def holes(bed, step):
        depth = tide_depth(bed, step)
        depth[::37] = np.nan
        return depth

    pairs, drawn = both(holes)
    assert drawn.water.GetIsShoreCutWhileDrawn()
    wt.check_at_most("NaN: pixels off by more than 1 of 255, %", worst_of(pairs), 0.05)


def test_what_is_asked_for_is_the_cut_mesh():
    """Filters, pickers and exporters get the mesh that the filter cuts."""
    _, drawn = both(tide_depth)
    assert drawn.water.GetIsShoreCutWhileDrawn()
    mapper = drawn.water.GetMapper()
    mapper.GetInputAlgorithm().Update()
    cut = mapper.GetInputAlgorithm().GetOutput()
    depths = cut.GetPointData().GetArray("h")
    wt.check_at_least("cut mesh: least depth of its points", depths.GetRange()[0], -1e-9)


def test_software_renderers_cut_in_the_filter(monkeypatch):
    monkeypatch.setenv("VTK_WATER_SOFTWARE", "1")
    made = Tide(vtkWaterLakes.CUT_AUTOMATIC, tide_depth)
    made.pictures()
    assert not made.water.GetIsShoreCutWhileDrawn()
    monkeypatch.setenv("VTK_WATER_SOFTWARE", "0")
    made = Tide(vtkWaterLakes.CUT_AUTOMATIC, tide_depth)
    made.pictures()
    assert made.water.GetIsShoreCutWhileDrawn()


def test_printing_runs_no_pipeline():
    """A step that was cut while it was drawn is not cut again for its mean level; who asks for that has it."""
    made = Tide(vtkWaterLakes.CUT_WHILE_DRAWN, tide_depth)
    surface = made.water.SetData(made.source.GetOutputPort(), "", "h", "zb")
    made.pictures()
    runs = []
    surface.AddObserver("StartEvent", lambda *_: runs.append(1))
    wt.check_equal("printed", "MeanLevel" in str(surface), True)
    wt.check_equal("runs by printing", len(runs), 0)
    level = surface.GetMeanLevel()
    wt.check_equal("runs by asking", len(runs), 1)
    wt.check_at_most("level off by", abs(level - tide.level_of(STEPS[-1])), 1e-6)
    wt.check_equal("printed then", f"MeanLevel: {level:g}"[:14] in str(surface), True)


def test_wrong_number_is_an_error():
    water = vtkWaterLakes()
    errors = []
    water.AddObserver("ErrorEvent", lambda *_: errors.append(1))
    water.SetShoreCut(3)
    wt.check_equal("errors", len(errors), 1)
    wt.check_equal("kept", water.GetShoreCutAsString(), "CUT_AUTOMATIC")
