# SPDX-License-Identifier: BSD-3-Clause
"""A stand-in is drawn in place of a prop in the reflection, and there only."""

import numpy as np
import water_test as wt
from vtkmodules.vtkCommonCore import vtkInformation
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper
from vtkwater import vtkWaterReflectionPass as Pass

SIZE = (200, 150)
RED, GREEN = (1, 0, 0), (0, 1, 0)


def actor_of(data, color):
    actor = vtkActor()
    actor.SetMapper(vtkPolyDataMapper())
    actor.GetMapper().SetInputData(data)
    actor.GetProperty().SetColor(color)
    actor.GetProperty().LightingOff()
    return actor


class Scene:
    def __init__(self, skips=Pass.SKIP_ALL):
        self.view = wt.View(SIZE, background=(0, 0, 0))
        self.renderer = self.view.renderer
        self.fine = actor_of(wt.sphere((0, 0, 1.5), 1, 64), RED)
        self.coarse = actor_of(wt.sphere((0, 0, 1.5), 1, 8), GREEN)
        self.water = wt.add_water(self.renderer, wt.plane((0, 0, 0), (0, 0, 1)), (-6, 6, -6, 6))
        self.reflection = self.water.GetReflectionPass()
        self.reflection.SetSkips(skips)
        camera = self.renderer.GetActiveCamera()
        camera.SetPosition(0, -14, 4)
        camera.SetViewUp(0, 0, 1)
        camera.SetClippingRange(0.5, 60)

    def give(self, prop, stand_in):
        if prop.GetPropertyKeys() is None:
            prop.SetPropertyKeys(vtkInformation())
        prop.GetPropertyKeys().Set(Pass.STAND_IN(), stand_in)

    def colors(self):
        """Pixels of pure red and of pure green."""
        self.picture = self.view.picture()
        return [int((self.picture == np.array(color) * 255).all(axis=2).sum()) for color in (RED, GREEN)]


# Truth: the coarse one alone is reflected, the fine one alone is seen.
truth = Scene()
truth.renderer.AddActor(truth.fine)
red_both, _ = truth.colors()
wt.leave_out(truth.fine)
red_seen, _ = truth.colors()
fine_picture = truth.picture
other = Scene()
other.renderer.AddActor(other.coarse)
_, green_both = other.colors()
wt.leave_out(other.coarse)
_, green_seen = other.colors()
coarse_seen = other.picture
other.coarse.GetPropertyKeys().Remove(Pass.NOT_REFLECTED())
other.colors()
reflected = other.picture - coarse_seen  # of the coarse one, in the water
wt.check_at_least("pixels of the fine one's reflection", red_both - red_seen, 300)
wt.check_at_least("pixels of the coarse one's reflection", green_both - green_seen, 300)

for skips in (Pass.SKIP_ALL, Pass.SKIP_NONE):
    name = "all skips" if skips == Pass.SKIP_ALL else "no skips"
    scene = Scene(skips)
    scene.renderer.AddActor(scene.fine)
    scene.give(scene.fine, scene.coarse)
    wt.check_equal(f"{name}: pixels of the fine one and of its stand-in", scene.colors(),
                   [red_seen, green_both - green_seen])
    wt.check_equal(f"{name}: largest error", int(np.abs(scene.picture - fine_picture - reflected).max()), 0)
    wt.check_equal(f"{name}: props reflected", scene.reflection.GetNumberOfPropsReflected(), 1)
    wt.check_equal(f"{name}: props of the renderer", scene.renderer.GetViewProps().GetNumberOfItems(), 2)

    # what it looks like is what counts
    scene.coarse.GetProperty().SetColor(0, 0, 1)
    wt.check_equal(f"{name}: stand-in of another colour, pixels", scene.colors(), [red_seen, 0])
    scene.coarse.GetProperty().SetColor(GREEN)

    # it is placed by itself, and culled by its own bounds
    scene.fine.SetPosition(300, 0, 0)
    wt.check_equal(f"{name}: the fine one is out of view, pixels", scene.colors(), [0, green_both - green_seen])
    scene.fine.SetPosition(0, 0, 0)
    scene.coarse.SetPosition(300, 0, 0)
    wt.check_equal(f"{name}: the stand-in is out of view, pixels", scene.colors(), [red_seen, 0])
    if skips == Pass.SKIP_ALL:
        wt.check_equal(f"{name}: fate of the stand-in out of view",
                       scene.reflection.GetFateCount(Pass.OUT_OF_VIEW), 1)
    scene.coarse.SetPosition(0, 0, 0)

    # the prop's own visibility and mark win
    scene.fine.VisibilityOff()
    wt.check_equal(f"{name}: the fine one is invisible, pixels", scene.colors(), [0, 0])
    scene.fine.VisibilityOn()
    scene.fine.GetPropertyKeys().Set(Pass.NOT_REFLECTED(), 1)
    wt.check_equal(f"{name}: NOT_REFLECTED, pixels", scene.colors(), [red_seen, 0])
    wt.check_equal(f"{name}: fate of the one not reflected",
                   scene.reflection.GetFateCount(Pass.MARKED_NOT_REFLECTED), 1)
    scene.fine.GetPropertyKeys().Set(Pass.NOT_REFLECTED(), 0)
    wt.check_equal(f"{name}: reflected again, pixels", scene.colors(), [red_seen, green_both - green_seen])

    # it may go, and water stands in for nothing
    scene.fine.GetPropertyKeys().Remove(Pass.STAND_IN())
    wt.check_equal(f"{name}: no stand-in any more, pixels", scene.colors(), [red_both, 0])
    scene.give(scene.fine, scene.water)
    wt.check_equal(f"{name}: water as a stand-in, pixels", scene.colors(), [red_both, 0])

# The key keeps it alive; nothing of it is left in a window that is gone.
scene = Scene()
scene.renderer.AddActor(scene.fine)
scene.give(scene.fine, scene.coarse)
scene.coarse = None
wt.check_equal("held by the key alone: pixels", scene.colors(), [red_seen, green_both - green_seen])
scene.view.window.Finalize()
wt.check_equal("the window made anew: pixels", scene.colors(), [red_seen, green_both - green_seen])

stand_in = actor_of(wt.sphere((0, 0, 1.5), 1, 8), GREEN)
for number in range(2):
    scene = Scene()
    scene.renderer.AddActor(scene.fine)
    scene.give(scene.fine, stand_in)
    wt.check_equal(f"window {number + 1} with the same stand-in: pixels", scene.colors(),
                   [red_seen, green_both - green_seen])
    errors = wt.errors_of(scene.view.window) + wt.errors_of(stand_in.GetMapper())
    del scene.view.window
    scene = None
    wt.check_equal(f"window {number + 1} gone: errors", len(errors), 0)
wt.finish()
