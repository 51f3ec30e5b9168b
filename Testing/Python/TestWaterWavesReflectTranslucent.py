# SPDX-License-Identifier: BSD-3-Clause
"""Waves reflect what is translucent, volumes included, at its own distance, and through it what is behind.

Long waves are followed by one ray a pixel, short ones stand for several facets. The truth is a ray caster
(ray_caster.py) that blends surfaces and volumes itself.
"""

import functools

import numpy as np
import pytest
import ray_caster
import volumes
import water_test as wt
from ray_caster import Box, Sphere, Translucent
from vtkmodules.vtkRenderingCore import vtkAssembly, vtkPropAssembly

SIZE = (240, 160)
SKY = (128 / 255, 153 / 255, 204 / 255)
EYE = (0, -9, 2)
# amplitude m, wavelength m, direction and phase in degrees
LONG = ((0.0127, 2.0, 20, 10), (0.0064, 1.2, 80, 200), (0.0032, 0.75, 140, 90))
SHORT = ((0.0012, 0.12, 20, 10), (0.001, 0.1, 80, 10), (0.0011, 0.11, 130, 10))

RED, GREEN, YELLOW, DARK = (0.8, 0.2, 0.2), (0.2, 0.4, 0.2), (0.9, 0.9, 0.1), (0.1, 0.1, 0.1)
POSTS = (Box((0, 8, 1), (1, 1, 2), GREEN), Box((-3, 9, 1.5), (1, 1, 3), YELLOW), Sphere((3, 7, 1.5), 0.8, DARK))

# opaque things, translucent ones
SCENES = {
    "a sphere over the sky": ((), (Translucent(Sphere((0, 4, 2), 1, RED), 0.4),)),
    "a pane before posts": (POSTS, (Translucent(Box((0, 3, 1.5), (7, 0.2, 2.5), RED), 0.25),)),
    "posts in a glass case": (POSTS, (Translucent(Box((0, 4, 2), (14, 12, 4), RED), 0.15),)),
    "things behind a post": ((Box((0, 3, 1), (1.5, 0.5, 2), GREEN),),
                             (Translucent(Sphere((0, 9, 2.2), 1.6, RED), 0.4),
                              Translucent(Box((3, 5, 1.5), (1, 1, 1.5), DARK), 0.3))),
    "a volume": (POSTS[:1], (Translucent(Box((1, 4, 2), (2, 2, 2), RED), 0.6, is_volume=True),)),
    "a bank of fog": (POSTS, (Translucent(Box((0, 6, 1.5), (14, 8, 3), (1, 1, 1)), 0.1, is_volume=True),)),
}


def data_of(thing):
    if isinstance(thing, Box):
        return wt.box(0.5 * (thing.low + thing.high), thing.high - thing.low)
    return wt.sphere(thing.center, thing.radius, 96)


def add_volume(renderer, box, opacity):
    """A volume as dense everywhere: the opacity is that of a unit of length, as VTK has it."""
    low, high = box.low, box.high
    colors = ((0, *box.color), (255, *box.color))
    volume = volumes.ray_cast(volumes.block(low, high), 0.05, colors, ((0, opacity), (255, opacity)))
    renderer.AddVolume(volume)
    return volume


def made_of(opaque, clear, waves, blending="", samples=0):
    view = wt.View(SIZE, SKY, samples)
    for thing in opaque:
        wt.add_actor(view.renderer, data_of(thing), thing.color, lit=False)
    for one in clear:
        if one.is_volume:
            add_volume(view.renderer, one.thing, one.opacity)
        else:
            wt.add_actor(view.renderer, data_of(one.thing), one.thing.color, lit=False, opacity=one.opacity)
    if blending == "with depth peeling":
        view.renderer.UseDepthPeelingOn()
        view.renderer.SetMaximumNumberOfPeels(20)
        view.window.SetAlphaBitPlanes(True)
    water = wt.add_water(view.renderer, None, (-60, 60, -60, 60))
    for wave in waves:
        water.GetWaterProperty().AddWave(*wave)
    wt.place_camera(view.renderer, EYE, (0, 0, 0.3), (0.5, 150))
    return view, water


@functools.lru_cache(maxsize=None)
def truth_of(name, waves):
    """The ray caster's picture, and the pixels of water in which what is translucent shows."""
    opaque, clear = SCENES[name]
    camera = made_of((), (), ())[0].renderer.GetActiveCamera()
    shown, mask = ray_caster.picture(camera, SIZE, opaque, SKY, waves, 0, 4 if waves is LONG else 6, clear)
    bare, _ = ray_caster.picture(camera, SIZE, opaque, SKY, waves, 0, 2)
    return shown, mask & (np.abs(shown - bare).max(axis=2) > 8)


def compare(name, waves, limit, blending="", samples=0, quality="default"):
    view, water = made_of(*SCENES[name], waves, blending, samples)
    water.GetWaterProperty().SetRayTraceQuality(quality)
    picture = view.picture()
    truth, mask = truth_of(name, waves)
    label = " ".join((name, "on long waves" if waves is LONG else "on short waves", blending)).strip()
    label += f", {samples} samples" if samples else ""
    label += f", {quality}" if quality != "default" else ""
    wt.save(np.concatenate([picture, truth], axis=1),
            wt.output_folder() / f"TestWaterWavesReflectTranslucent-{label.replace(' ', '-')}.png")
    wt.check_at_least(f"{label}: pixels that show it", int(mask.sum()), 500)
    rmse = float(np.sqrt(((picture - truth)[mask] ** 2).mean()))
    wt.check_at_most(f"{label}: RMSE of 255", round(rmse, 2), limit)


@pytest.mark.parametrize("name, limit", (
    ("a sphere over the sky", 9),
    ("a pane before posts", 7),
    ("posts in a glass case", 4),
    ("things behind a post", 15),
    ("a volume", 6),
    ("a bank of fog", 4.5),
), ids=SCENES)
def test_long_waves_reflect(name, limit):
    """Waves that one ray a pixel follows show the scene as the ray caster has it."""
    compare(name, LONG, limit)


@pytest.mark.parametrize("name, limit", (
    ("a sphere over the sky", 12.6),
    ("a pane before posts", 9.8),
    ("posts in a glass case", 6.6),
    ("things behind a post", 12.4),
    ("a volume", 13),
    ("a bank of fog", 7),
), ids=SCENES)
def test_short_waves_reflect(name, limit):
    """Waves that stand for several facets a pixel show the scene as the ray caster has it."""
    compare(name, SHORT, limit)


@pytest.mark.parametrize("software", ["1", "0"])
def test_all_slopes_of_short_waves_reflect(monkeypatch, software):
    """Quality "high" has no facets there, but the layer of what is translucent all the same."""
    monkeypatch.setenv("VTK_WATER_SOFTWARE", software)
    compare("a sphere over the sky", SHORT, 12.6, quality="high")


def test_depth_peeling_changes_no_reflection():
    """With depth peeling the reflection is as close to the ray caster's."""
    compare("a pane before posts", LONG, 7, "with depth peeling")


def test_samples_change_no_reflection():
    """With several samples a pixel the reflection is nearly as close to the ray caster's."""
    compare("a sphere over the sky", LONG, 10, samples=4)


class Pane:
    """A pane before posts, which comes and goes, and pictures of what is right."""

    def __init__(self):
        opaque, clear = SCENES["a pane before posts"]
        self.view, water = made_of(opaque, clear, LONG)
        self.look = water.GetWaterProperty()
        self.pane = list(self.view.renderer.GetActors())[len(opaque)]
        self.bare = made_of(opaque, (), LONG)[0].picture()
        self.anew = made_of(opaque, clear, LONG)[0].picture()
        self.calm = made_of(opaque, clear, ())[0].picture()


def test_another_lookup_of_the_same_view_finds_what_is_translucent():
    """After a lookup that needs nothing of it, the ray traced one shows the pane as in a scene that is new."""
    scene = Pane()
    scene.look.SetLookupToFixedOffset()
    scene.view.picture()
    scene.look.SetLookupToRayTraced()
    first = scene.view.picture()
    wt.check_equal("after another lookup of the same view: difference", wt.difference(first, scene.anew), 0)
    wt.check_at_least("the pane is reflected: largest difference", wt.difference(first, scene.bare), 30)


def test_what_is_translucent_comes_and_goes():
    """Without the pane, the water is that of a scene that never had it; with it again, as before."""
    scene = Pane()
    first = scene.view.picture()
    scene.pane.VisibilityOff()
    wt.check_equal("without it: difference from a scene that never had it",
                   wt.difference(scene.view.picture(), scene.bare), 0)
    scene.pane.VisibilityOn()
    wt.check_equal("with it again: difference", wt.difference(scene.view.picture(), first), 0)


CLOUD = Box((1, 4, 2), (2, 2, 2), RED)


def picture_of_parts(assembly_class=None):
    """A cloud that stands a quarter turn from its data, and posts; as parts of one thing, or each on its own."""
    view, _ = made_of((), (), LONG)
    parts = [wt.add_actor(view.renderer, data_of(post), post.color, lit=False) for post in POSTS]
    parts.append(add_volume(view.renderer, Box((4, -1, 3), (2, 2, 2), RED), 0.6))
    parts[-1].SetPosition(0, 0, -1)
    parts[-1].RotateZ(90)
    if assembly_class:
        assembly = assembly_class()
        for part in parts:
            view.renderer.RemoveViewProp(part)
            assembly.AddPart(part)
        view.renderer.AddViewProp(assembly)
    return view.picture()


@pytest.mark.parametrize("assembly_class", (vtkAssembly, vtkPropAssembly))
def test_a_volume_is_found_in_its_own_box_in_an_assembly(assembly_class):
    """A volume that is a part of something is reflected as on its own, where its own matrix has put it."""
    name = assembly_class.__name__
    alone = picture_of_parts()
    without = made_of(POSTS, (), LONG)[0].picture()
    wt.check_at_least(f"{name}: the cloud is reflected", wt.difference(alone, without), 50)
    wt.check_equal(f"{name}: difference from its parts", wt.difference(picture_of_parts(assembly_class), alone), 0)
    upright = made_of(POSTS, (Translucent(CLOUD, 0.6, is_volume=True),), LONG)[0].picture()
    wt.check_at_most(f"{name}: difference from data that need no turn", wt.difference(alone, upright), 1)


def test_a_volume_that_shows_nothing_hides_nothing():
    """What is translucent behind a volume without any opacity is found where it is, as if that were not there."""
    sphere = (Translucent(Sphere((1, 8, 2), 1.6, RED), 0.4),)
    nothing = Translucent(Box((1, 3, 2), (3, 2, 3), DARK), 0, is_volume=True)
    picture = made_of((), sphere + (nothing,), LONG)[0].picture()
    wt.check_equal("a volume without opacity: difference",
                   wt.difference(picture, made_of((), sphere, LONG)[0].picture()), 0)


def test_water_that_turns_calm_reflects_as_calm_water():
    """Without its waves, the water is that which never had any."""
    scene = Pane()
    scene.view.picture()
    scene.look.RemoveAllWaves()
    wt.check_equal("calm again: difference from water that always was",
                   wt.difference(scene.view.picture(), scene.calm), 0)
