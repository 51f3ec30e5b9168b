# SPDX-License-Identifier: BSD-3-Clause
"""A dense mesh of the user's is shaded once a pixel, from a buffer, and looks as if each of its triangles were shaded."""

import numpy as np
import pytest
import water_test as wt
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkLookupTable, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersSources import vtkConeSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkHardwareSelector, vtkPolyDataMapper

SIZE = (120, 90)
HALF = 10.0
CELLS = 160  # along a side: most triangles are smaller than a pixel
MOST_SHARE = 2e-4  # of pixels that may be off by more than 1 of 255
MOST_SHARE_OF_SAMPLES, WORST_OF_SAMPLES = 2e-3, 24
IN_USE = "the surface is shaded once per pixel, from a buffer"


@pytest.fixture(autouse=True)
def _rules_of_software(monkeypatch):
    """On a GPU the buffer is slower, and not used."""
    monkeypatch.setenv("VTK_WATER_SOFTWARE", "1")


def swell(x, y):
    return 0.12 * np.sin(0.9 * x + 0.3 * y) + 0.05 * np.cos(1.7 * y)


def bed(x, y):
    return -1.6 + 0.02 * (x * x + y * y) + 0.25 * np.sin(1.3 * x)


def flat(x, y):
    return 0.0 * x


def grid(heights, cells=CELLS, values=None, hole=None):
    """Quads over [-HALF, HALF] in x and y, with an array of values; without those whose middle is in the hole."""
    places = np.linspace(-HALF, HALF, cells + 1)
    x, y = (each.ravel() for each in np.meshgrid(places, places))
    i = np.arange((cells + 1) ** 2).reshape(cells + 1, cells + 1)
    corners = np.stack([i[:-1, :-1], i[:-1, 1:], i[1:, 1:], i[1:, :-1]], axis=-1).reshape(-1, 4)
    if hole:
        corners = corners[~hole(x[corners].mean(axis=1), y[corners].mean(axis=1))]
    polygons = vtkCellArray()
    polygons.SetData(4, numpy_to_vtk(np.ascontiguousarray(corners.ravel().astype(np.int64)), deep=1, array_type=16))
    points = vtkPoints()
    points.SetDataTypeToDouble()
    points.SetData(numpy_to_vtk(np.ascontiguousarray(np.column_stack([x, y, heights(x, y)])), deep=1))
    mesh = vtkPolyData()
    mesh.SetPoints(points)
    mesh.SetPolys(polygons)
    if values is not None:
        array = numpy_to_vtk(np.ascontiguousarray(values(x, y), dtype=float), deep=1)
        array.SetName("value")
        mesh.GetPointData().SetScalars(array)
    return mesh


def actor_of(mesh, color):
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(mesh)
    mapper.ScalarVisibilityOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(color)
    return actor


class Scene:
    """Clear water of a mesh over a bed that comes out of it at the corners, with a cone in it."""

    def __init__(self, mesh, samples, look=None):
        self.view = wt.View(SIZE, (0.5, 0.65, 0.8), samples=samples)
        renderer = self.view.renderer
        renderer.AddActor(actor_of(grid(bed, 40), (0.7, 0.6, 0.4)))
        cone = vtkConeSource()
        cone.SetDirection(0.2, 0.0, 1.0)
        cone.SetHeight(3.0)
        cone.SetRadius(1.2)
        cone.SetCenter(-2.0, 2.0, 0.3)
        cone.SetResolution(24)
        cone.Update()
        renderer.AddActor(actor_of(cone.GetOutput(), (0.9, 0.4, 0.2)))
        self.water = wt.add_water(renderer, None, None, 0.0)
        mapper = vtkPolyDataMapper()
        mapper.SetInputData(mesh)
        if mesh.GetPointData().GetScalars():
            mapper.SetLookupTable(table())
            mapper.SetUseLookupTableScalarRange(True)
        else:
            mapper.ScalarVisibilityOff()
        self.water.SetMapper(mapper)
        look_of = self.water.GetWaterProperty()
        look_of.GlitterOff()
        look_of.RefractionOn()
        if look:
            look(look_of)
        self.mirror = self.water.GetReflectionPass()
        wt.place_camera(renderer, (0.5, -17.0, 5.0), (0.0, 0.0, -0.5), (1.0, 60.0))

    def picture(self, is_buffered):
        self.mirror.SetSurfaceBuffer(is_buffered)
        return self.view.picture()


def table():
    made = vtkLookupTable()
    made.SetNumberOfTableValues(256)
    for i in range(256):
        made.SetTableValue(i, i / 255, 0.4, 1 - i / 255, 1.0)
    made.SetNanColor(1.0, 1.0, 0.0, 1.0)
    made.SetRange(-1.0, 1.0)
    return made


def values(x, y):
    return np.sin(0.4 * x) * np.cos(0.3 * y)


def values_with_gaps(x, y):
    return np.where(np.hypot(x - 3, y + 2) < 2.0, np.nan, values(x, y))


def waves(look):
    look.AddWave(0.02, 1.5, 30.0)
    look.AddWave(0.008, 0.6, 75.0)


def opaque(look):
    look.RefractionOff()


def is_in_hole(x, y):
    return np.hypot(x - 4, y - 1) < 1.5


SCENES = {
    "clear": (lambda: grid(swell), None),
    "coloured": (lambda: grid(swell, values=values), None),
    "gaps": (lambda: grid(swell, values=values_with_gaps), None),
    "waves": (lambda: grid(swell), waves),
    "level": (lambda: grid(flat), waves),
    "opaque": (lambda: grid(swell), opaque),
    "hole": (lambda: grid(swell, hole=is_in_hole), None),
}


def near_ends(is_water):
    """Pixels within two of one that shows water on one side of it and none on the other."""
    padded = np.pad(is_water, 2, mode="edge")
    height, width = is_water.shape
    parts = [padded[i:i + height, j:j + width] for i in range(5) for j in range(5)]
    return np.any(parts, axis=0) & ~np.all(parts, axis=0)


def compare(name, direct, buffered, none, samples):
    """Pixels off by more than 1: next to none. With several samples a few more, where a pixel shows an edge of the
    reflection: each of the pixel's triangles is shaded in the direct draw, and their mean in a buffer."""
    off = np.abs(direct - buffered).max(axis=2)
    ends = near_ends(np.abs(direct - none).max(axis=2) > 0)
    most = MOST_SHARE_OF_SAMPLES if samples else MOST_SHARE
    wt.check_at_most(f"{name}: share of pixels off by more than 1", float((off[~ends] > 1).mean()), most)
    wt.check_at_most(f"{name}: the same at the surface's ends", float((off[ends] > 1).mean()), 10 * most)
    wt.check_at_most(f"{name}: the worst pixel", int(off.max()), WORST_OF_SAMPLES if samples else 2)


@pytest.mark.parametrize("samples", (0, 4), ids=("one", "four"))
@pytest.mark.parametrize("name", SCENES)
def test_a_buffer_changes_no_picture(name, samples):
    make, look = SCENES[name]
    scene = Scene(make(), samples, look)
    direct = scene.picture(False)
    wt.check_equal("not buffered when it is off", scene.mirror.GetSurfaceIsBuffered(), False)
    buffered = scene.picture(True)
    wt.check_equal("why", scene.mirror.GetSurfaceBufferUseAsString(), IN_USE)
    none = without_water(scene)
    wt.check_at_least("the water is seen", wt.difference(direct, none), 20)
    compare(name, direct, buffered, none, samples)
    wt.check_equal("the same again", wt.difference(scene.picture(False), direct), 0)


def without_water(scene):
    scene.water.VisibilityOff()
    picture = scene.view.picture()
    scene.water.VisibilityOn()
    return picture


def wide_triangles(scene):
    scene.water.GetMapper().SetInputData(grid(swell, 2))


def translucent(scene):
    scene.water.GetWaterProperty().SetOpacity(0.5)


OTHERS = {
    "large enough": wide_triangles,
    "parallel projection": lambda scene: scene.view.renderer.GetActiveCamera().ParallelProjectionOn(),
    "edges, points": lambda scene: scene.water.GetProperty().EdgeVisibilityOn(),
    "a translucent surface": translucent,
    "another output": lambda scene: scene.water.GetWaterProperty().SetOutputToReflectance(),
}


@pytest.mark.parametrize("why", OTHERS)
def test_other_draws_have_no_buffer(why):
    scene = Scene(grid(swell), 0)
    scene.view.picture()
    wt.check_equal("buffered before", scene.mirror.GetSurfaceIsBuffered(), True)
    OTHERS[why](scene)
    scene.view.picture()
    said = scene.mirror.GetSurfaceBufferUseAsString()
    wt.check_equal(f"{why}, of: {said}", why in said, True)
    wt.check_equal("buffered", scene.mirror.GetSurfaceIsBuffered(), False)


def test_a_gpu_has_no_buffer(on_a_gpu):
    scene = Scene(grid(swell), 0)
    scene.view.picture()
    wt.check_equal("a GPU's reason", "GPU" in scene.mirror.GetSurfaceBufferUseAsString(), True)


def test_a_selection_is_drawn_as_it_is():
    """It finds the water, and the picture after it is the one before."""
    scene = Scene(grid(swell), 0)
    before = scene.view.picture()
    selector = vtkHardwareSelector()
    selector.SetRenderer(scene.view.renderer)
    selector.SetArea(10, 10, 30, 20)
    found = selector.Select()
    props = [found.GetNode(i).GetProperties().Get(found.GetNode(i).PROP()) for i in range(found.GetNumberOfNodes())]
    wt.check_equal("the water is found", scene.water in props, True)
    wt.check_equal("the picture after it", wt.difference(scene.view.picture(), before), 0)
    wt.check_equal("buffered", scene.mirror.GetSurfaceIsBuffered(), True)
