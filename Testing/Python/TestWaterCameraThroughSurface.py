# SPDX-License-Identifier: BSD-3-Clause
"""A camera comes down to the water and goes through it: no frame is black, has a pixel that is no number,
or jumps out of the row of its neighbours. Where waves move the surface, they decide on which side the camera is.

WATER_DIVE_FRAMES=1000 in the environment takes smaller steps.
"""

import os

import numpy as np
import pytest
import water_test as wt
from wave_scenes import POSTS_WAVES, posts, SKY
from ray_caster import Box

SIZE = (120, 90)
NEAR = 0.01  # m: it cuts through the surface before the eye does
LARGEST_STEP = 9.0  # mean of the differences of two frames, of 255
LARGEST_STEP_SWELL = 25.0  # in one frame all of the surface is drawn from its other side: decision 007, limits
SWELL = ((0.15, 5.0, 20.0, 10.0), (0.06, 2.3, 80.0, 200.0))
EYE = (2, -13)
CREST, TROUGH = 2.2, 3.0  # s: 0.20 m over and 0.18 m under the plane at rest, where the eye is
FRAMES = int(os.environ.get("WATER_DIVE_FRAMES", "60"))
DIVES = pytest.mark.parametrize("name, waves, clear", (
    ("calm", (), False), ("wavy", POSTS_WAVES, False),
    ("calm and clear", (), True), ("wavy and clear", POSTS_WAVES, True),
), ids=("calm", "wavy", "calm_and_clear", "wavy_and_clear"))
SWELLS = pytest.mark.parametrize("name, begins", (("under a crest", CREST), ("over a trough", TROUGH)),
                                 ids=("under_a_crest", "over_a_trough"))


class Scene:
    def __init__(self, waves, clear):
        self.view = wt.View(SIZE, SKY)
        for thing in posts():
            data = (wt.box(0.5 * (thing.low + thing.high), thing.high - thing.low) if isinstance(thing, Box)
                    else wt.sphere(thing.center, thing.radius, 32))
            wt.add_actor(self.view.renderer, data, thing.color, lit=False)
        wt.add_actor(self.view.renderer, wt.box((0, 0, -6), (120, 120, 1)), (0.8, 0.7, 0.5), lit=False)
        self.water = wt.add_water(self.view.renderer, None, (-60, 60, -60, 60), reflectance=None)
        look = self.water.GetWaterProperty()
        look.SetRefraction(clear)
        look.SetAbsorption(0.3, 0.1, 0.05)
        for wave in waves:
            look.AddWave(*wave)
        self.errors = wt.errors_of(self.water)

    def at(self, height):
        wt.place_camera(self.view.renderer, (*EYE, height), (0, 0, 0.3 * height if height < 1 else 0.3), (NEAR, 400))
        return self.view.picture()


def largest_steps(pictures):
    """Of every picture but the first, the mean difference to the one before it; of every one but the first and the
    last, how far it is from both neighbours, less how far these are from each other: a flash."""
    steps = np.array([np.abs(b - a).mean() for a, b in zip(pictures, pictures[1:])])
    across = np.array([np.abs(b - a).mean() for a, b in zip(pictures, pictures[2:])])
    return steps, np.minimum(steps[:-1], steps[1:]) - across


def check_no_jumps(name, pictures, heights, flash_judged, largest_step):
    steps, flash = largest_steps(pictures)
    through = np.abs(heights[1:]) <= 1.01e-3
    wt.check_equal(f"{name}: pixels of 0, 0, 0", sum(int((picture.max(axis=2) == 0).sum()) for picture in pictures), 0)
    wt.check_at_most(f"{name}: largest step, within 1 mm of the surface", round(float(steps[through].max()), 2),
                     largest_step)
    wt.check_at_most(f"{name}: largest flash", round(float(flash[flash_judged].max()), 2), 2.0)


@DIVES
def test_a_dive_has_no_black_frame_and_no_jump(name, waves, clear):
    """From 100 m over the water to 5 m under it, frame follows frame, and nothing is black."""
    scene = Scene(waves, clear)
    heights = np.concatenate([
        np.geomspace(100, 1e-3, FRAMES // 2), np.linspace(1e-3, -1e-3, FRAMES // 5),
        -np.geomspace(1e-3, 5, FRAMES - FRAMES // 2 - FRAMES // 5)])
    pictures = [scene.at(height) for height in heights]
    check_no_jumps(name, pictures, heights, heights[1:-1] < 10, LARGEST_STEP)
    wt.check_equal(f"{name}: errors", scene.errors, [])


@pytest.mark.parametrize("name, waves", (("calm and clear", ()), ("wavy and clear", POSTS_WAVES)),
                         ids=("calm", "wavy"))
def test_straight_down_the_surface_is_not_seen_to_pass(name, waves):
    """Straight down, where all of the sheet is cut off before the eye is in the water, both sides of it look alike."""
    scene = Scene(waves, True)

    def at(height):
        wt.place_camera(scene.view.renderer, (*EYE, height), (*EYE, -5), (0.1, 400), view_up=(0, 1, 0))
        return scene.view.picture()

    wt.check_at_most(f"{name}: straight down, eye over and under the surface, difference",
                     int(np.abs(at(1e-4) - at(-1e-4)).max()), 1)


def heights_through(count):
    """From 0.5 m over to 0.5 m under a surface, a fifth of them within 1 mm."""
    return np.concatenate([np.geomspace(0.5, 1e-3, count * 2 // 5), np.linspace(1e-3, -1e-3, count // 5),
                           -np.geomspace(1e-3, 0.5, count * 2 // 5)])


def is_under(picture, deep):
    return bool((np.abs(picture - deep).max(axis=2) <= 2).mean() > 0.9)


def swell(name, begins, count, absorption):
    """Down through a moving swell: pictures, heights over the surface, and over the plane at rest."""
    scene = Scene(SWELL, True)
    look = scene.water.GetWaterProperty()
    look.WaveGeometryOn()
    look.SetWaveGridSize(128)
    look.SetAbsorption(*absorption)
    look.SetDeepColor(0, 0.3, 0.3)
    over = heights_through(count)
    pictures, at_rest = [], []
    for frame, height in enumerate(over):
        scene.water.SetTime(begins + 0.05 * frame / count)
        at_rest.append(scene.water.GetWaveHeight(*EYE) + height)
        wt.place_camera(scene.view.renderer, (*EYE, at_rest[-1]), (0, 0, at_rest[-1] + 0.3), (NEAR, 400))
        pictures.append(scene.view.picture())
    wt.check_equal(f"{name}: errors", scene.errors, [])
    return pictures, over, np.array(at_rest)


@SWELLS
def test_a_dive_through_a_swell_has_no_black_frame_and_no_jump(name, begins):
    """Through a surface that waves move, frame follows frame, and nothing is black."""
    pictures, over, at_rest = swell(name, begins, FRAMES, (0.3, 0.1, 0.05))
    between = (over > 0) != (at_rest > 0)
    wt.check_at_least(f"{name}: frames between the plane at rest and the surface", int(between.sum()), 10)
    check_no_jumps(name, pictures, over, slice(None), LARGEST_STEP_SWELL)


@SWELLS
def test_waves_decide_on_which_side_the_camera_is(name, begins):
    """In water that nobody sees through, an eye under the moved surface sees nothing else, and one over it the sky."""
    pictures, over, _ = swell(name, begins, min(FRAMES // 2, 200), (300, 300, 300))
    deep = np.array([0, 0.3, 0.3]) * 255
    judged = np.abs(over) > NEAR
    wrong = judged & [is_under(picture, deep) != (height < 0) for picture, height in zip(pictures, over)]
    wt.check_equal(f"{name}: frames from the wrong side, of {int(judged.sum())}", int(wrong.sum()), 0)
