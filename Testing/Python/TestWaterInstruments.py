# SPDX-License-Identifier: BSD-3-Clause
"""What the pass says about its own cost is there when asked for, and believable: fewer triangles with
PIECES, fewer fragments with the other skips; and settings out of range are refused by name."""

import math

import numpy as np
import skip_scenes
import water_test as wt
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkwater import vtkWaterReflectionPass as Pass

TIMES = ("LastGatherTime", "LastPlanTime", "LastReflectionTime", "LastSurfaceTime")
COUNTS = ("NumberOfTrianglesReflected", "NumberOfFragmentsReflected")


def read(reflection, names):
    return [getattr(reflection, f"Get{name}")() for name in names]


class Scene:
    """A wide mesh around a small sheet, which a wall hides but for a strip."""

    def __init__(self, skips=Pass.SKIP_ALL, samples=0, wall=None, sheet=(-2, 2, -2, 2)):
        self.view = wt.View((200, 150), samples=samples)
        self.renderer = self.view.renderer
        land = skip_scenes.terrain((-14, -14), (14, 14), lambda x, y: 1 + np.sin(x) * np.cos(y) + 0.03 * np.maximum(y, 0) ** 2)
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


# Off: nothing is known. On: all of it, after some frames.
scene = Scene()
scene.frames()
wt.check_equal("instrumentation by default", scene.reflection.GetInstrumentation(), False)
wt.check_equal("off: times known", [name for name, value in zip(TIMES, read(scene.reflection, TIMES))
                                    if not math.isnan(value)], [])
wt.check_equal("off: counts", read(scene.reflection, COUNTS), [-1, -1])
wt.check_equal("off: printed", "LastGatherTime" in str(scene.reflection), False)
before = scene.view.picture()
scene.reflection.InstrumentationOn()
wt.check_equal("on: largest change of the picture", int(np.abs(scene.view.picture() - before).max()), 0)
scene.frames()
for name, value in zip(TIMES, read(scene.reflection, TIMES)):
    wt.check(f"on: {name} in ms", value, "in (0, 60000)", 0 < value < 60000)
for name, value in zip(COUNTS, read(scene.reflection, COUNTS)):
    wt.check_at_least(f"on: {name}", value, 1)
wt.check_equal("on: printed", "LastGatherTime" in str(scene.reflection), True)
scene.reflection.InstrumentationOff()
wt.check_equal("off again: times known", [name for name, value in zip(TIMES[:2], read(scene.reflection, TIMES))
                                          if not math.isnan(value)], [])
scene.reflection.InstrumentationOn()
scene.frames()
scene.water.ReleaseGraphicsResources(scene.view.window)
scene.frames()
wt.check_at_least("resources released: triangles in the next frames",
                  scene.reflection.GetNumberOfTrianglesReflected(), 1)

# Another window's context may be current.
known = scene.frames()
other = Scene()
other.frames()
wt.check_equal("after another window's frames: counts", read(scene.reflection, COUNTS), known)

# Triangles: without skips all there are; with PIECES those that the sheet can show, and no more fragments.
def counts(skips, **settings):
    scene = Scene(skips, **settings)
    scene.reflection.InstrumentationOn()
    return scene, scene.frames()


for samples in (0, 4):
    scene, (all_triangles, all_fragments) = counts(Pass.SKIP_NONE, samples=samples)
    boxes = 2 * 12
    wt.check_equal(f"{samples} samples, no skips: triangles", all_triangles, scene.triangles + boxes)
    _, (triangles, fragments) = counts(Pass.PIECES, samples=samples)
    wt.check_at_most(f"{samples} samples, PIECES: triangles", triangles, 0.95 * all_triangles)
    wt.check_at_least(f"{samples} samples, PIECES: triangles", triangles, 0.05 * all_triangles)
    _, (with_pixels, fewer) = counts(Pass.PIECES | Pass.PIXELS, samples=samples)
    wt.check_at_most(f"{samples} samples, PIECES and PIXELS: triangles", with_pixels, 0.6 * triangles)
    wt.check_at_least(f"{samples} samples, PIECES and PIXELS: triangles", with_pixels, boxes + 300)
    wt.check_at_most(f"{samples} samples, PIECES and PIXELS: fragments", fewer, 0.5 * all_fragments)
    _, (with_props, _) = counts(Pass.PROPS, samples=samples)
    wt.check_equal(f"{samples} samples, PROPS: triangles", with_props, all_triangles - 12)

# Fragments: what the wall hides is not drawn in the mirrored view.
wide = {"sheet": (-14, 14, -14, 14)}
_, (_, seen) = counts(Pass.SKIP_ALL, **wide)
_, (_, behind_all) = counts(Pass.SKIP_ALL & ~Pass.PIXELS, wall=(-2.5, -9), **wide)
_, (_, behind) = counts(Pass.SKIP_ALL, wall=(-2.5, -9), **wide)
wt.check_at_least("beside a wall, no PIXELS: fragments", behind_all, 0.9 * seen)
wt.check_at_most("beside a wall: fragments", behind, 0.6 * seen)

# A mesh that comes nearer triangle by triangle is drawn from its end: what is near hides what is far.
def hills(*rows):
    scene = Scene(Pass.SKIP_ALL, sheet=(-14, 14, -14, 14))
    mesh = skip_scenes.terrain((-14, rows[0]), (14, rows[1]), lambda x, y: np.where(y > 2, 3 + 3 * np.cos(2 * y) + 0.1 * y, 0))
    scene.land.GetMapper().SetInputData(mesh)
    scene.reflection.InstrumentationOn()
    return scene.frames()[1]


away, nearer = hills(-14, 14), hills(14, -14)
wt.check_at_most("hills that come nearer / that go away: fragments", nearer / away, 1.1)

# A scalar-coloured mesh whose triangles the shader counts is drawn as a whole.
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

# What is refused, by name, value and range; the last good value stays.
reflection = Scene().reflection
for name, good, bads, limits in (
    ("Skips", Pass.HIDDEN_WATER | Pass.PIECES, (-1, Pass.SKIP_ALL + 1), ("[0, 255]",)),
    ("MinimumPropSize", 2.5, (-0.1, float("nan")), ("[0, ",)),
    ("ReflectanceError", 0.03, (-0.1, 1.5, float("nan")), ("[0, 1]",)),
):
    getattr(reflection, "Set" + name)(good)
    for bad in bads:
        errors = wt.errors_of(reflection)
        getattr(reflection, "Set" + name)(bad)
        text = errors[0] if errors else ""
        wt.check_equal(f"Set{name}({bad}): errors", len(errors), 1)
        missing = [word for word in (name, f"{bad:g}".replace("+", ""), *limits) if word not in text]
        wt.check_equal(f"Set{name}({bad}): not named", missing, [])
        wt.check_equal(f"Set{name}({bad}): it stays", getattr(reflection, "Get" + name)(), good)
wt.check_equal("defaults", (Scene().reflection.GetSkips(), Scene().reflection.GetMinimumPropSize()),
               (Pass.SKIP_ALL, 0.0))
wt.finish()
