# SPDX-License-Identifier: BSD-3-Clause
"""What the pass says about its own cost is there when asked for, and believable: fewer triangles with
PIECES, fewer fragments with the other skips; and settings out of range are refused by name."""

import math

import numpy as np
import pytest
import skip_scenes
import water_test as wt
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkwater import vtkWaterReflectionPass as Pass

TIMES = ("LastGatherTime", "LastPlanTime", "LastReflectionTime", "LastSurfaceTime")
COUNTS = ("NumberOfTrianglesReflected", "NumberOfFragmentsReflected")


WIDE = (-14, 14, -14, 14)  # a sheet


def read(reflection, names):
    return [getattr(reflection, f"Get{name}")() for name in names]


def known_times(reflection, names):
    return [name for name, value in zip(names, read(reflection, names)) if not math.isnan(value)]


class Scene:
    """A wide mesh around a small sheet, which a wall hides but for a strip."""

    def __init__(self, skips=Pass.SKIP_ALL, samples=0, wall=None, sheet=(-2, 2, -2, 2)):
        self.view = wt.View((200, 150), samples=samples)
        self.renderer = self.view.renderer
        land = skip_scenes.terrain(
            (-14, -14), (14, 14), lambda x, y: 1 + np.sin(x) * np.cos(y) + 0.03 * np.maximum(y, 0) ** 2)
        self.land = wt.add_actor(self.renderer, land, (0.6, 0.5, 0.3))
        self.triangles = land.GetNumberOfPolys()
        self.box = wt.add_actor(self.renderer, wt.box((0, 3, 4), (1, 1, 1)), (0.9, 0.3, 0.2))
        wt.add_actor(self.renderer, wt.box((200, 3, 4), (1, 1, 1)), (0.9, 0.3, 0.2))
        self.water = wt.add_water(self.renderer, wt.plane((0, 0, 3), (0, 0, 1)), sheet, 0.9)
        if wall:
            wall = wt.add_actor(self.renderer, wt.box((*wall, 6), (6, 0.1, 12)), (0.5, 0.5, 0.5))
            wt.leave_out(wall)
        self.reflection = self.water.GetReflectionPass()
        self.reflection.SetSkips(skips)
        self.camera = wt.place_camera(self.renderer, (0, -12, 5), (0, 0, 3), (0.5, 80))

    def frames(self, count=4):
        for _ in range(count):
            self.camera.Azimuth(0.01)  # no view is like the last one
            self.view.window.Render()
        return read(self.reflection, COUNTS)


def counts(skips, **settings):
    """A scene after some frames with instrumentation, and its triangles and fragments."""
    scene = Scene(skips, **settings)
    scene.reflection.InstrumentationOn()
    return scene, scene.frames()


def hills(*rows):
    """Fragments of hills over a wide sheet, whose rows of triangles go from the first y to the second."""
    scene = Scene(Pass.SKIP_ALL, sheet=WIDE)
    mesh = skip_scenes.terrain(
        (-14, rows[0]), (14, rows[1]), lambda x, y: np.where(y > 2, 3 + 3 * np.cos(2 * y) + 0.1 * y, 0))
    scene.land.GetMapper().SetInputData(mesh)
    scene.reflection.InstrumentationOn()
    return scene.frames()[1]


def test_nothing_is_known_by_default():
    """Instrumentation is off by default, and then no time and no count is known, nor printed."""
    scene = Scene()
    scene.frames()
    wt.check_equal("instrumentation by default", scene.reflection.GetInstrumentation(), False)
    wt.check_equal("off: times known", known_times(scene.reflection, TIMES), [])
    wt.check_equal("off: counts", read(scene.reflection, COUNTS), [-1, -1])
    wt.check_equal("off: printed", "LastGatherTime" in str(scene.reflection), False)


def test_all_is_known_when_asked_for():
    """With instrumentation all times and counts are known after some frames, and the picture is the same."""
    scene = Scene()
    scene.frames()
    before = scene.view.picture()
    scene.reflection.InstrumentationOn()
    wt.check_equal("on: largest change of the picture", int(np.abs(scene.view.picture() - before).max()), 0)
    scene.frames()
    for name, value in zip(TIMES, read(scene.reflection, TIMES)):
        wt.check(f"on: {name} in ms", value, "in (0, 60000)", 0 < value < 60000)
    for name, value in zip(COUNTS, read(scene.reflection, COUNTS)):
        wt.check_at_least(f"on: {name}", value, 1)
    wt.check_equal("on: printed", "LastGatherTime" in str(scene.reflection), True)


def test_nothing_is_known_when_it_is_off_again():
    """When instrumentation is switched off again, the times that were known are not."""
    scene, _ = counts(Pass.SKIP_ALL)
    scene.reflection.InstrumentationOff()
    wt.check_equal("off again: times known", known_times(scene.reflection, TIMES[:2]), [])


def test_it_goes_on_after_resources_were_released():
    """After the graphics resources were released, the next frames are counted again."""
    scene, _ = counts(Pass.SKIP_ALL)
    scene.water.ReleaseGraphicsResources(scene.view.window)
    scene.frames()
    wt.check_at_least("resources released: triangles in the next frames",
                      scene.reflection.GetNumberOfTrianglesReflected(), 1)


def test_another_windows_context_may_be_current():
    """Counts can be asked for when another window has rendered since, and its context is the current one."""
    scene, known = counts(Pass.SKIP_ALL)
    other = Scene()
    other.frames()
    wt.check_equal("after another window's frames: counts", read(scene.reflection, COUNTS), known)


@pytest.mark.usefixtures("in_software")
@pytest.mark.parametrize("samples", [0, 4], ids=["0_samples", "4_samples"])
def test_triangles_are_counted(samples):
    """Without skips all triangles are counted; with PIECES those that the sheet can show, and no more fragments."""
    scene, (all_triangles, all_fragments) = counts(Pass.SKIP_NONE, samples=samples)
    boxes = 2 * 12
    wt.check_equal(f"{samples} samples, no skips: triangles", all_triangles, scene.triangles + boxes)
    _, (triangles, _) = counts(Pass.PIECES, samples=samples)
    wt.check_at_most(f"{samples} samples, PIECES: triangles", triangles, 0.95 * all_triangles)
    wt.check_at_least(f"{samples} samples, PIECES: triangles", triangles, 0.05 * all_triangles)
    _, (with_pixels, fewer) = counts(Pass.PIECES | Pass.PIXELS, samples=samples)
    wt.check_at_most(f"{samples} samples, PIECES and PIXELS: triangles", with_pixels, 0.6 * triangles)
    wt.check_at_least(f"{samples} samples, PIECES and PIXELS: triangles", with_pixels, boxes + 300)
    wt.check_at_most(f"{samples} samples, PIECES and PIXELS: fragments", fewer, 0.5 * all_fragments)
    _, (with_props, _) = counts(Pass.PROPS, samples=samples)
    wt.check_equal(f"{samples} samples, PROPS: triangles", with_props, all_triangles - 12)


@pytest.mark.usefixtures("in_software")
def test_fragments_behind_a_wall_are_not_drawn():
    """With PIXELS, what a wall hides of the water is not drawn in the mirrored view; without, it is."""
    _, (_, seen) = counts(Pass.SKIP_ALL, sheet=WIDE)
    _, (_, behind_all) = counts(Pass.SKIP_ALL & ~Pass.PIXELS, wall=(-2.5, -9), sheet=WIDE)
    _, (_, behind) = counts(Pass.SKIP_ALL, wall=(-2.5, -9), sheet=WIDE)
    wt.check_at_least("beside a wall, no PIXELS: fragments", behind_all, 0.9 * seen)
    wt.check_at_most("beside a wall: fragments", behind, 0.6 * seen)


@pytest.mark.usefixtures("in_software")
def test_a_mesh_that_comes_nearer_is_drawn_from_its_end():
    """A mesh that comes nearer triangle by triangle is drawn from its end: what is near hides what is far."""
    away, nearer = hills(-14, 14), hills(14, -14)
    wt.check_at_most("hills that come nearer / that go away: fragments", nearer / away, 1.1)


def test_a_mesh_coloured_by_cells_is_drawn_as_a_whole():
    """A scalar-coloured mesh whose triangles the shader counts is drawn as a whole, and rightly."""
    scene = Scene(Pass.SKIP_ALL)
    cells = numpy_to_vtk(np.arange(scene.triangles, dtype=float), deep=True)
    scene.land.GetMapper().GetInput().GetCellData().SetScalars(cells)
    scene.land.GetMapper().ScalarVisibilityOn()
    scene.land.GetMapper().SetScalarModeToUseCellData()
    scene.land.GetMapper().SetScalarRange(0, scene.triangles)
    scene.reflection.InstrumentationOn()
    wt.check_at_least("coloured by cells: triangles", scene.frames()[0], scene.triangles)
    scene.view.picture()
    with_skips = scene.view.picture()
    scene.reflection.SetSkips(Pass.SKIP_NONE)
    wt.check_equal("coloured by cells: largest error", int(np.abs(scene.view.picture() - with_skips).max()), 0)


@pytest.mark.parametrize("name, good, bads, limits", [
    ("Skips", Pass.HIDDEN_WATER | Pass.PIECES, (-1, Pass.SKIP_ALL + 1), ("[0, 255]",)),
    ("MinimumPropSize", 2.5, (-0.1, float("nan")), ("[0, ",)),
    ("ReflectanceError", 0.03, (-0.1, 1.5, float("nan")), ("[0, 1]",)),
], ids=["Skips", "MinimumPropSize", "ReflectanceError"])
def test_settings_out_of_range_are_refused(name, good, bads, limits):
    """A setting out of range is refused by name, value and range, and the last good value stays."""
    reflection = Scene().reflection
    getattr(reflection, "Set" + name)(good)
    for bad in bads:
        errors = wt.errors_of(reflection)
        getattr(reflection, "Set" + name)(bad)
        text = errors[0] if errors else ""
        wt.check_equal(f"Set{name}({bad}): errors", len(errors), 1)
        missing = [word for word in (name, f"{bad:g}".replace("+", ""), *limits) if word not in text]
        wt.check_equal(f"Set{name}({bad}): not named", missing, [])
        wt.check_equal(f"Set{name}({bad}): it stays", getattr(reflection, "Get" + name)(), good)


def test_by_default_all_skips_are_on():
    """By default all skips are on, and no prop is too small to be mirrored."""
    wt.check_equal("defaults", (Scene().reflection.GetSkips(), Scene().reflection.GetMinimumPropSize()),
                   (Pass.SKIP_ALL, 0.0))
