# SPDX-License-Identifier: BSD-3-Clause
"""The shore in the picture is where the depth is zero, step by step, and what stays dry does not change."""

import numpy as np
import pytest
import water_test as wt
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkCommonExecutionModel import vtkTrivialProducer
from vtkmodules.vtkRenderingCore import vtkPolyDataMapper
from vtkwater import vtkWaterActor, vtkWaterLakes, vtkWaterSurfaceFilter

STEPS = 100
SIZE = (160, 120)
CELLS = 40  # a side: of 4 pixels each
HALF = 10.0  # the mesh covers [-10, 10] x [-10, 10]
HEIGHT, ANGLE = 40.0, 20.0  # of the eye; degrees
SLOPE = np.array((0.3, 0.11))  # of the bed


def bed_at(x, y):
    return SLOPE[0] * x + SLOPE[1] * y


def level_of(step):
    return 2.0 * np.sin(0.37 * step)


def grid():
    """Triangles whose points lie in no row, and their bed."""
    random = np.random.default_rng(3)
    x, y = np.meshgrid(*2 * [np.linspace(-HALF, HALF, CELLS + 1)])
    x, y = (part + np.pad(random.uniform(-0.15, 0.15, (CELLS - 1, CELLS - 1)), 1) for part in (x, y))
    first = (np.arange(CELLS)[:, None] * (CELLS + 1) + np.arange(CELLS)).ravel()
    cells = vtkCellArray()
    for corners in (first, first + 1, first + CELLS + 2), (first, first + CELLS + 2, first + CELLS + 1):
        for triangle in np.stack(corners, axis=1).tolist():
            cells.InsertNextCell(3, triangle)
    points, mesh = vtkPoints(), vtkPolyData()
    places = np.c_[x.ravel(), y.ravel(), bed_at(x, y).ravel()]
    points.SetData(numpy_to_vtk(places, deep=True))
    mesh.SetPoints(points)
    mesh.SetPolys(cells)
    add(mesh, "zb", places[:, 2])
    return mesh, places


def add(mesh, name, values):
    array = numpy_to_vtk(values, deep=True)
    array.SetName(name)
    mesh.GetPointData().AddArray(array)


def places_of_pixels():
    """x and y where the ray of each pixel meets the bed, rows from below."""
    scale = np.tan(np.radians(ANGLE / 2)) / (SIZE[1] / 2)
    u = (np.arange(SIZE[0]) + 0.5 - SIZE[0] / 2) * scale
    v = ((np.arange(SIZE[1]) + 0.5 - SIZE[1] / 2) * scale)[:, None]
    way = HEIGHT / (1.0 + bed_at(u, v))  # (u, v, -1) way from the eye meets z = bed
    return u * way, v * way, scale


def quads_of(mesh):
    """The same, each two triangles one cell."""
    cells, row = vtkCellArray(), CELLS + 1
    for first in (np.arange(CELLS)[:, None] * row + np.arange(CELLS)).ravel().tolist():
        cells.InsertNextCell(4, [first, first + 1, first + row + 1, first + row])
    mesh.SetPolys(cells)


class CutByFilter:
    """A water whose shore vtkWaterSurfaceFilter cuts."""

    def __init__(self, mesh, renderer):
        self.surface, mapper, self.water = vtkWaterSurfaceFilter(), vtkPolyDataMapper(), vtkWaterActor()
        self.surface.SetInputData(mesh)
        self.surface.SetDepthArrayName("h")
        self.surface.SetBedArrayName("zb")
        mapper.SetInputConnection(self.surface.GetOutputPort())
        mapper.ScalarVisibilityOff()
        self.water.SetMapper(mapper)
        renderer.AddActor(self.water)

    def update(self):
        self.surface.Update()
        self.water.SetLevel(self.surface.GetMeanLevel())

    def check(self):
        """The filter says how many cells it cut."""
        wt.check_at_least("cells that the filter cut", self.surface.GetNumberOfCutCells(), 10)


class CutWhileDrawn:
    """One whose shore is cut while it is drawn, as on a GPU."""

    def __init__(self, mesh, renderer):
        self.source, self.lakes = vtkTrivialProducer(), vtkWaterLakes()
        self.source.SetOutput(mesh)
        self.lakes.SetData(self.source.GetOutputPort(), "", "h", "zb")
        self.lakes.SetShoreCut(vtkWaterLakes.CUT_WHILE_DRAWN)
        self.lakes.AddTo(renderer)
        self.water = self.lakes.GetWater()

    def update(self):
        self.source.Modified()

    def check(self):
        wt.check_equal("cut while drawn", self.lakes.GetIsShoreCutWhileDrawn(), True)


@pytest.mark.parametrize("areas_have_quads", (False, True), ids=("triangles", "quads"))
@pytest.mark.parametrize("cut", (CutByFilter, CutWhileDrawn))
@pytest.mark.parametrize("samples", (0, 4))
def test_the_shore_is_where_the_depth_is_zero(samples, cut, areas_have_quads, monkeypatch):
    """Every pixel that is further than half a pixel from the exact line is wet or dry as the depth says, over 100
    steps; the land's pixels that are dry in two steps are the same in both."""
    if cut is CutWhileDrawn:
        monkeypatch.setenv("VTK_WATER_SOFTWARE", "0")
    mesh, places = grid()
    if areas_have_quads:
        quads_of(mesh)
    view = wt.View(SIZE, (0, 0, 0), samples=samples)
    land = wt.add_actor(view.renderer, mesh, (0.8, 0.4, 0.1))
    land.GetProperty().LightingOff()
    add(mesh, "h", np.maximum(level_of(0) - places[:, 2], 0.0))
    made = cut(mesh, view.renderer)
    look = made.water.GetWaterProperty()
    look.SetReflectanceModeToConstant()
    look.SetReflectance(0.0)
    look.SetDeepColor(0.0, 0.0, 1.0)
    camera = wt.place_camera(view.renderer, (0, 0, HEIGHT), (0, 0, 0), (20, 60), (0, 1, 0))
    camera.SetViewAngle(ANGLE)
    x, y, scale = places_of_pixels()
    inside = (np.abs(x) < HALF - 0.5) & (np.abs(y) < HALF - 0.5)
    half_pixel = 0.5 * scale * HEIGHT * 1.1 * np.linalg.norm(SLOPE)  # of depth; land is nearer to the eye
    margin = half_pixel * (np.sqrt(2.0) if samples else 1.0)  # a line crosses several pixels' samples
    wrong = changed = 0
    before = before_dry = None
    for step in range(STEPS):
        level = level_of(step)
        add(mesh, "h", np.maximum(level - places[:, 2], 0.0))
        mesh.Modified()
        made.update()
        picture = view.picture().astype(int)
        depth = level - bed_at(x, y)
        dry = inside & (depth < -margin)
        wet = inside & (depth > margin)
        is_land = picture[:, :, 0] > 190
        is_water = picture[:, :, 0] < 10
        wrong += int((dry & ~is_land).sum() + (wet & ~is_water).sum())
        if before is not None:
            changed += int((dry & before_dry & (picture != before).any(axis=2)).sum())
        before, before_dry = picture, dry
    wt.save(before, wt.output_folder() / f"Shoreline-{samples}-{cut.__name__}.png")
    made.check()
    wt.check_equal(f"pixels of {STEPS} steps on the wrong side, by more than half a pixel", wrong, 0)
    wt.check_equal(f"dry pixels of {STEPS} steps that change", changed, 0)
    wt.check_at_least("share of the last picture that is wet", float(is_water[inside].mean()), 0.1)
    wt.check_at_least("share of the last picture that is dry", float(is_land[inside].mean()), 0.1)
