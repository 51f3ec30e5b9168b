# SPDX-License-Identifier: BSD-3-Clause
"""No mirrored view is rendered of water that nobody sees, and none is missing in the very frame in which
somebody does: behind a wall, out of view, facing away, reflecting next to nothing."""

import numpy as np
import pytest
import skip_scenes
import water_test as wt
from vtkwater import vtkWaterReflectionPass as Pass

SIZE = (200, 150)


class Scene:
    def __init__(self, skips=Pass.SKIP_ALL, samples=0, reflectance=0.9):
        self.view = wt.View(SIZE, samples=samples)
        self.renderer = self.view.renderer
        self.renderer.GetCullers().RemoveAllItems()  # water out of view is ours to find
        self.thing = wt.add_actor(self.renderer, wt.pyramid((0, 0, 1), 2), (1, 0.6, 0.2))
        wt.add_actor(self.renderer, wt.box((1, 3, 0.8), (1, 1, 3)), (0.3, 0.7, 0.4))
        self.water = wt.add_water(self.renderer, None, (-6, 6, -6, 6), reflectance)
        self.wall = wt.add_actor(self.renderer, wt.box((0, -8, 3), (40, 0.2, 20)), (0.6, 0.5, 0.5), lit=False)
        wt.leave_out(self.wall)
        self.wall.VisibilityOff()
        self.reflection = self.water.GetReflectionPass()
        self.reflection.SetSkips(skips)
        self.camera = self.renderer.GetActiveCamera()
        self.look((2, -12, 4))

    def look(self, position, target=(0, 0, 0)):
        self.camera.SetPosition(position)
        self.camera.SetFocalPoint(target)
        straight = position[0] == target[0] and position[1] == target[1]
        self.camera.SetViewUp((0, 1, 0) if straight else (0, 0, 1))
        self.camera.SetClippingRange(0.5, 60)

    def picture(self):
        return self.view.picture()

    def renders(self):
        return self.reflection.GetNumberOfReflectionRenders()

    def decision(self):
        return self.reflection.GetDecision()


def frame(name, scenes, decision):
    """Both scenes' next picture: equal, and decided as it should be."""
    pictures = [scene.picture() for scene in scenes]
    wt.check_equal(f"{name}: largest error", int(np.abs(pictures[0] - pictures[1]).max()), 0)
    if decision is not None:
        wt.check_equal(f"{name}: decision", wt.decision_of(scenes[0].water), decision)
    return pictures[1]


def both(**settings):
    return [Scene(skips, **settings) for skips in (Pass.SKIP_ALL, Pass.SKIP_NONE)]


def for_both(scenes, do):
    for scene in scenes:
        do(scene)


def move_thing(scene):
    scene.thing.AddPosition(0.2, 0.1, 0)


@pytest.mark.parametrize("waves", [False, True], ids=["calm", "waves"])
@pytest.mark.parametrize("samples", [0, 8], ids=["0_samples", "8_samples"])
def test_water_behind_a_wall_is_not_mirrored(samples, waves):
    """Behind a wall no mirrored view is rendered, whatever moves, and when the wall has left it is there at once."""
    # The first frame of a window cannot know, nor the first with the wall: what was seen last is asked for.
    scenes = both(samples=samples)
    name = f"wall, {samples} samples, {'waves' if waves else 'calm'}"
    if waves:
        for_both(scenes, lambda scene: scene.water.GetWaterProperty().AddWave(0.05, 2.0, 20.0))
    seen = frame(f"{name}, before it", scenes, "RENDERED")
    for_both(scenes, lambda scene: scene.wall.VisibilityOn())
    hidden = frame(f"{name}, first frame", scenes, None)
    renders = scenes[0].renders()
    for number in range(2, 6):
        for_both(scenes, move_thing)
        frame(f"{name}, frame {number}", scenes, "HIDDEN")
    wt.check_equal(f"{name}: mirrored views rendered behind it", scenes[0].renders() - renders, 0)
    for_both(scenes, lambda scene: scene.look((1, -12.5, 3.5)))
    frame(f"{name}, the camera moves", scenes, "HIDDEN")
    for_both(scenes, lambda scene: scene.wall.VisibilityOff())
    again = frame(f"{name}, it has left", scenes, "RENDERED")
    wt.check_at_least(f"{name}: the wall is seen", int(np.abs(hidden - seen).max()), 50)
    wt.check_at_least(f"{name}: the water is seen", int((np.abs(hidden - again).max(axis=2) > 8).sum()), 2000)


def test_a_sea_whose_first_draw_asks_whether_it_is_hidden():
    """A clear wind sea is asked whether it is hidden by a shader that has not been drawn before, in which textures of
    several kinds have units of their own: it is there when the eye goes from behind a hill to below the water."""
    scenes = [skip_scenes.Scene("clear", skips) for skips in (Pass.SKIP_ALL, Pass.SKIP_NONE)]
    steps = (lambda scene: scene.renderer.GradientBackgroundOn(),
             lambda scene: scene.place_camera((-2.3, 18, 1.04), (-0.23, 0, 0.6), angle=29),
             lambda scene: scene.place_camera((-0.72, -3.07, -0.42), (-1.02, 5.92, -0.21), angle=60))
    for step in steps:
        for_both(scenes, lambda scene: scene.picture())
        for_both(scenes, step)
    pictures = [scene.picture() for scene in scenes]
    wt.check_equal("largest error", int(np.abs(pictures[0] - pictures[1]).max()), 0)
    for_both(scenes, lambda scene: scene.waters[1].VisibilityOff())
    without = scenes[1].picture()
    wt.check_at_least("pixels of the sheet that was hidden", int((pictures[1] != without).any(axis=2).sum()), 100)


def test_a_wall_that_leaves_an_unchanged_scene_brings_the_last_view_back():
    """When a wall leaves and nothing else changes, the mirrored view from before the wall is used again."""
    scenes = both()
    frame("before the wall", scenes, "RENDERED")
    for_both(scenes, lambda scene: scene.wall.VisibilityOn())
    for _ in range(3):
        frame("behind the wall", scenes, None)
    for_both(scenes, lambda scene: scene.wall.VisibilityOff())
    frame("the wall leaves an unchanged scene", scenes, "REUSED")


def test_a_slit_of_water_is_mirrored():
    """A slit of water beside a wall is mirrored in every frame: next to nothing is not nothing."""
    scenes = both()
    for_both(scenes, lambda scene: (scene.wall.VisibilityOn(), scene.wall.SetPosition(20.05, 0, 0)))
    for number in range(3):
        for_both(scenes, move_thing)
        frame(f"a slit beside the wall, frame {number + 1}", scenes, "RENDERED")


@pytest.mark.usefixtures("in_software")
@pytest.mark.parametrize("name, leave", [
    ("moves", lambda scene: scene.wall.AddPosition(0.5, 0, 0)),
    ("leaves", lambda scene: scene.wall.VisibilityOff()),
], ids=["moves", "leaves"])
def test_a_view_without_what_a_wall_hides_is_not_used_again(name, leave):
    """What a wall hides of the water is left out of the mirrored view, which is not used again without the wall."""
    # That is done while the camera moves; then the wall moves or leaves, and nothing else changes.
    scenes = both()
    for_both(scenes, lambda scene: (scene.wall.VisibilityOn(), scene.wall.SetPosition(20.6, 0, 0)))
    scenes[0].reflection.InstrumentationOn()
    frame("before the camera moves", scenes, "RENDERED")
    whole = scenes[0].reflection.GetNumberOfFragmentsReflected()
    for number in range(3):
        for_both(scenes, lambda scene: scene.camera.Azimuth(0.1))
        frame(f"most is hidden, frame {number + 1}", scenes, "RENDERED")
    wt.check_at_most("most is hidden: fragments in the mirrored view",
                     scenes[0].reflection.GetNumberOfFragmentsReflected(), 0.7 * whole)
    for_both(scenes, leave)
    frame(f"the wall {name}", scenes, "RENDERED")
    frame(f"the wall {name}, next frame", scenes, "REUSED")


def test_without_the_skip_hidden_water_is_mirrored():
    """With HIDDEN_WATER switched off, water behind a wall is mirrored in every frame."""
    scene = Scene(Pass.SKIP_ALL & ~Pass.HIDDEN_WATER & ~Pass.UNCHANGED_VIEWS)
    scene.wall.VisibilityOn()
    for _ in range(3):
        scene.picture()
    wt.check_equal("behind the wall without HIDDEN_WATER: mirrored views in three frames", scene.renders(), 3)


def test_water_hidden_in_one_renderer_is_mirrored_in_another():
    """Water that is hidden in one renderer's view is right in another renderer's view of the same water."""
    scenes = both()
    for scene in scenes:
        scene.renderer.SetViewport(0, 0, 0.5, 1)
        scene.other = scene.view.add_renderer((0.4, 0.2, 0.1), (0.5, 0, 1, 1))
        scene.other.GetCullers().RemoveAllItems()
        props = scene.renderer.GetViewProps()
        for i in range(props.GetNumberOfItems()):
            if props.GetItemAsObject(i) is not scene.wall:
                scene.other.AddViewProp(props.GetItemAsObject(i))
        scene.other.GetActiveCamera().DeepCopy(scene.camera)
        scene.wall.VisibilityOn()
    for number in range(3):
        frame(f"hidden in one of two renderers, frame {number + 1}", scenes, None)
        for_both(scenes, move_thing)


def test_water_out_of_view_is_not_mirrored():
    """Out of view no mirrored view is rendered, and when the water is in view again it is there at once."""
    scenes = both()
    frame("in view", scenes, "RENDERED")
    renders = scenes[0].renders()
    for_both(scenes, lambda scene: scene.look((2, -12, 4), (2, -40, 4)))
    frame("out of view", scenes, "WATER_OUT_OF_VIEW")
    for_both(scenes, move_thing)
    frame("still out of view", scenes, "WATER_OUT_OF_VIEW")
    wt.check_equal("out of view: mirrored views", scenes[0].renders() - renders, 0)
    for_both(scenes, lambda scene: scene.look((2, -12, 4)))
    frame("in view again", scenes, "RENDERED")


@pytest.mark.parametrize("culled", [False, True], ids=["drawn", "culled"])
def test_from_below_water_is_mirrored_unless_its_back_is_culled(culled):
    """From below the water is mirrored, unless its back faces are culled: then it faces away."""
    scenes = both()
    for_both(scenes, lambda scene: scene.water.GetProperty().SetBackfaceCulling(culled))
    for_both(scenes, lambda scene: scene.look((2, -9, -3), (0, 0, 0)))
    frame(f"from below, back faces {'culled' if culled else 'drawn'}", scenes, "FACING_AWAY" if culled else "RENDERED")
    for_both(scenes, lambda scene: scene.look((2, -12, 4)))
    frame("from above again", scenes, "RENDERED")


def test_from_above_water_whose_front_is_culled_is_not_mirrored():
    """From above the water faces away when its front faces are culled."""
    scenes = both()
    for_both(scenes, lambda scene: scene.water.GetProperty().FrontfaceCullingOn())
    frame("from above, front faces culled", scenes, "FACING_AWAY")


@pytest.mark.parametrize("reflectance", [0.0005, 0.001, 0.0015, 0.0019, 0.002])
def test_no_reflection_is_too_faint_by_default(reflectance):
    """However little water reflects: by default not a pixel of it differs from water that is mirrored in every frame."""
    scenes = both(reflectance=reflectance)
    for_both(scenes, lambda scene: scene.renderer.SetBackground(1, 1, 1))
    for_both(scenes, lambda scene: scene.thing.GetProperty().SetAmbient(1))
    for color in ((0.5, 0.5, 0.5), (0.1, 0.3, 0.501), (0.0, 0.0, 0.0)):  # one of them is at an edge of rounding
        for_both(scenes, lambda scene, rgb=color: scene.water.GetWaterProperty().SetDeepColor(rgb))
        frame(f"reflectance {reflectance} over {color}", scenes, None)
        wt.check_equal(f"reflectance {reflectance}: is left out", wt.decision_of(scenes[0].water) == "FAINT", False)


def test_a_faint_reflection_is_left_out_when_that_is_allowed():
    """A pool seen straight down, which reflects 2 %, is mirrored unless an error of 0.03 is allowed."""
    scenes = both(reflectance=None)
    for_both(scenes, lambda scene: scene.look((0, 0, 12)))
    frame("straight down, by default", scenes, "RENDERED")
    scenes[0].reflection.SetReflectanceError(0.03)
    pictures = [scene.picture() for scene in scenes]
    wt.check_equal("straight down, 0.03 may be neglected: decision", wt.decision_of(scenes[0].water), "FAINT")
    error = np.abs(pictures[0] - pictures[1]).max() / 255
    wt.check_at_most("straight down: largest error", float(error), 0.03)
    wt.check_at_least("straight down: there is something to neglect", float(error), 1 / 255)
    for_both(scenes, lambda scene: scene.look((2, -12, 4)))
    frame("from the side, 0.03 may be neglected", scenes, "RENDERED")
