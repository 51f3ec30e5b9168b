# SPDX-License-Identifier: BSD-3-Clause
"""A stand-in is drawn in place of a prop in the reflection, and there only."""

import numpy as np
import pytest
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


class Truth:
    """Pixels and pictures of the fine one alone and of the coarse one alone, seen and reflected."""

    def __init__(self):
        fine = Scene()
        fine.renderer.AddActor(fine.fine)
        self.red_both, _ = fine.colors()
        wt.leave_out(fine.fine)
        self.red_seen, _ = fine.colors()
        self.fine_picture = fine.picture
        other = Scene()
        other.renderer.AddActor(other.coarse)
        _, self.green_both = other.colors()
        wt.leave_out(other.coarse)
        _, self.green_seen = other.colors()
        coarse_seen = other.picture
        other.coarse.GetPropertyKeys().Remove(Pass.NOT_REFLECTED())
        other.colors()
        self.reflected = other.picture - coarse_seen  # of the coarse one, in the water
        self.right = [self.red_seen, self.green_both - self.green_seen]


@pytest.fixture(scope="module")
def truth():
    return Truth()


SKIPS = {"all skips": Pass.SKIP_ALL, "no skips": Pass.SKIP_NONE}
with_and_without_skips = pytest.mark.parametrize("name", SKIPS)


def scene_with_stand_in(skips=Pass.SKIP_ALL):
    """The fine one with the coarse one as its stand-in, after a first frame."""
    scene = Scene(skips)
    scene.renderer.AddActor(scene.fine)
    scene.give(scene.fine, scene.coarse)
    scene.colors()
    return scene


def test_either_can_be_told_from_its_reflection(truth):
    """Both the fine and the coarse one have a reflection of many pixels; otherwise the rest would prove nothing."""
    wt.check_at_least("pixels of the fine one's reflection", truth.red_both - truth.red_seen, 300)
    wt.check_at_least("pixels of the coarse one's reflection", truth.green_both - truth.green_seen, 300)


@with_and_without_skips
def test_stand_in_is_reflected_and_the_prop_seen(name, truth):
    """The coarse one alone is reflected, the fine one alone is seen, and the renderer has no prop more."""
    scene = scene_with_stand_in(SKIPS[name])
    wt.check_equal(f"{name}: pixels of the fine one and of its stand-in", scene.colors(), truth.right)
    wt.check_equal(f"{name}: largest error", wt.difference(scene.picture, truth.fine_picture + truth.reflected), 0)
    wt.check_equal(f"{name}: props reflected", scene.reflection.GetNumberOfPropsReflected(), 1)
    wt.check_equal(f"{name}: props of the renderer", scene.renderer.GetViewProps().GetNumberOfItems(), 2)


@with_and_without_skips
def test_look_of_the_stand_in_counts(name, truth):
    """A stand-in that changes its colour is reflected in the new one."""
    scene = scene_with_stand_in(SKIPS[name])
    scene.coarse.GetProperty().SetColor(0, 0, 1)
    wt.check_equal(f"{name}: stand-in of another colour, pixels", scene.colors(), [truth.red_seen, 0])


@with_and_without_skips
def test_stand_in_is_placed_and_culled_by_itself(name, truth):
    """A prop out of view leaves its stand-in where it is, and a stand-in out of view its prop."""
    scene = scene_with_stand_in(SKIPS[name])
    scene.fine.SetPosition(300, 0, 0)
    wt.check_equal(f"{name}: the fine one is out of view, pixels", scene.colors(), [0, truth.right[1]])
    scene.fine.SetPosition(0, 0, 0)
    scene.coarse.SetPosition(300, 0, 0)
    wt.check_equal(f"{name}: the stand-in is out of view, pixels", scene.colors(), [truth.red_seen, 0])
    if SKIPS[name] == Pass.SKIP_ALL:
        wt.check_equal(f"{name}: fate of the stand-in out of view", scene.reflection.GetFateCount(Pass.OUT_OF_VIEW), 1)


@with_and_without_skips
def test_visibility_and_mark_of_the_prop_win(name, truth):
    """Of a prop that is invisible or marked NOT_REFLECTED, no stand-in is reflected."""
    scene = scene_with_stand_in(SKIPS[name])
    scene.fine.VisibilityOff()
    wt.check_equal(f"{name}: the fine one is invisible, pixels", scene.colors(), [0, 0])
    scene.fine.VisibilityOn()
    scene.fine.GetPropertyKeys().Set(Pass.NOT_REFLECTED(), 1)
    wt.check_equal(f"{name}: NOT_REFLECTED, pixels", scene.colors(), [truth.red_seen, 0])
    wt.check_equal(f"{name}: fate of the one not reflected",
                   scene.reflection.GetFateCount(Pass.MARKED_NOT_REFLECTED), 1)
    scene.fine.GetPropertyKeys().Set(Pass.NOT_REFLECTED(), 0)
    wt.check_equal(f"{name}: reflected again, pixels", scene.colors(), truth.right)


@with_and_without_skips
def test_prop_without_its_stand_in_is_reflected_itself(name, truth):
    """When the stand-in is taken away, the prop itself is reflected; and water stands in for nothing."""
    scene = scene_with_stand_in(SKIPS[name])
    scene.fine.GetPropertyKeys().Remove(Pass.STAND_IN())
    wt.check_equal(f"{name}: no stand-in any more, pixels", scene.colors(), [truth.red_both, 0])
    scene.give(scene.fine, scene.water)
    wt.check_equal(f"{name}: water as a stand-in, pixels", scene.colors(), [truth.red_both, 0])


def test_key_keeps_the_stand_in_alive(truth):
    """A stand-in that the key alone holds is reflected, in a window that is made anew as well."""
    scene = Scene()
    scene.renderer.AddActor(scene.fine)
    scene.give(scene.fine, scene.coarse)
    scene.coarse = None
    wt.check_equal("held by the key alone: pixels", scene.colors(), truth.right)
    scene.view.window.Finalize()
    wt.check_equal("the window made anew: pixels", scene.colors(), truth.right)


def test_nothing_of_a_stand_in_is_left_in_a_window_that_is_gone(truth):
    """A stand-in can serve one window after another, and says nothing when a window goes."""
    stand_in = actor_of(wt.sphere((0, 0, 1.5), 1, 8), GREEN)
    for number in range(2):
        scene = Scene()
        scene.renderer.AddActor(scene.fine)
        scene.give(scene.fine, stand_in)
        wt.check_equal(f"window {number + 1} with the same stand-in: pixels", scene.colors(), truth.right)
        errors = wt.errors_of(scene.view.window) + wt.errors_of(stand_in.GetMapper())
        del scene.view.window
        scene = None
        wt.check_equal(f"window {number + 1} gone: errors", len(errors), 0)


def test_a_stand_in_that_was_replaced_is_forgotten(truth):
    """What stood in for a prop before may be gone; changes of what does so now, and of the prop, are seen."""
    scene = scene_with_stand_in()
    for _ in range(3):
        scene.colors()
    scene.coarse = actor_of(wt.sphere((0, 0, 1.5), 1, 8), (0, 0, 1))
    scene.give(scene.fine, scene.coarse)  # nobody holds the other one
    scene.colors()
    scene.coarse.GetProperty().SetColor(GREEN)
    wt.check_equal("the new one's colour changed: pixels", scene.colors(), truth.right)
    scene.fine.GetPropertyKeys().Remove(Pass.STAND_IN())
    scene.coarse = None
    wt.check_equal("removed: pixels", scene.colors(), [truth.red_both, 0])
    scene.fine.GetProperty().SetColor(GREEN)
    wt.check_equal("the prop's colour changed: pixels", scene.colors()[0], 0)
