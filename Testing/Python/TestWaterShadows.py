# SPDX-License-Identifier: BSD-3-Clause
"""Shadows on the water lie where rays to the sun are stopped, along coasts, too, and nowhere else.

A coast takes seconds, most of them for its rays. coast_shadows.py by itself looks at 50 of them.
"""

import coast_shadows as coasts
import numpy as np
import pytest
import ray_caster
import water_test as wt
from dark_water import add_dark_water

LIMIT = 0.1  # % of the water's pixels
# Of these the mirrored view and the picture do not show what casts the shadows: land outside the picture, posts behind
# others, balls between the eye and their shadow.
LAND_SEEDS = (41,)
THING_SEEDS = (1, 18)
CLEAR_SEEDS = (18,)
WAVE = (0.6, 14.0)  # amplitude and length, m
# over the shore from the sea, along it, from the land, from high over it; whether the water is clear
BEACH_EYES = (((-5, -25, 8), (0, 0, 0), False), ((-15, -15, 10), (0, 0, 0), True), ((20, -12, 12), (-3, 0, 0), False),
              ((-3, 0, 30), (-3, 0.1, 0), True), ((-4, 25, 14), (-1, 0, 0), False))


def check(name, coast, has_refraction=False):
    dark, lit, shaded, picture = coasts.compared(coast, has_refraction)
    wt.save(picture, wt.output_folder() / f"{name.replace(' ', '_')}.png")
    print(f"{name}: {100 * shaded:.2f} % of the water is in shadow")
    wt.check_at_least(f"{name}: pixels of water", int((picture[:, :, 2] > 0).sum()), 100)
    wt.check_at_most(f"{name}: % that is dark or lit wrongly", 100 * float(dark + lit), LIMIT)


@pytest.mark.parametrize("eye, target, has_refraction", BEACH_EYES)
def test_a_beach_shades_no_water(eye, target, has_refraction):
    """A beach of a slope of a tenth, under a sun 45 degrees high, keeps the sun off nothing."""
    check(f"beach from {eye}", coasts.beach(eye, target), has_refraction)


@pytest.mark.parametrize("seed", LAND_SEEDS)
def test_land_shades_what_rays_say(seed):
    """Random bays, hills and islands under random suns."""
    check(f"land {seed}", coasts.random_coast(seed, has_things=False))


@pytest.mark.parametrize("seed", THING_SEEDS)
def test_things_shade_what_rays_say(seed):
    """The same with posts and balls."""
    check(f"things {seed}", coasts.random_coast(seed))


@pytest.mark.parametrize("seed", CLEAR_SEEDS)
def test_clear_water_is_shaded_as_rays_say(seed):
    """Water that is looked through, behind balls."""
    check(f"clear {seed}", coasts.random_coast(seed), has_refraction=True)


def surface_along(water, starts, rays):
    """Where rays from the eye meet a surface whose height changes along x alone: from both sides of a table."""
    x = np.linspace(-80, 80, 6401)
    z = np.array([water.GetWaveHeight(value, 0.0) for value in x])
    way = (WAVE[0] - starts[:, 2]) / rays[:, 2]
    for _ in range(400):  # a step is a part of what is left, or it would go through a crest
        at = starts + way[:, None] * rays
        way += 0.3 * np.maximum(at[:, 2] - np.interp(at[:, 0], x, z), 0) / -rays[:, 2]
    return starts + way[:, None] * rays


def test_waves_are_shaded_at_their_own_height():
    """A post's shadow lies further away in a trough than on a crest."""
    view = wt.View(coasts.SIZE, (0, 0, 0))
    post = ray_caster.Box((-4, 0, 2), (1.5, 3, 10), (0, 0, 0))
    wt.add_actor(view.renderer, wt.box(0.5 * (post.low + post.high), post.high - post.low), (0, 0, 0), lit=False)
    to_sun = coasts.sun_at(20, 180)
    wt.add_scene_light(view.renderer, 1000 * to_sun)
    view.renderer.GetLights().GetItemAsObject(0).SetIntensity(20)
    water = add_dark_water(view)
    look = water.GetWaterProperty()
    look.SetReflectanceModeToFresnel()
    look.SetSlopeVariance(0.3, 0.3)
    look.AddWave(*WAVE, 0.0, 0.0)
    look.WaveGeometryOn()
    camera = wt.place_camera(view.renderer, (6, -26, 14), (6, 0, 0), (0.3, 300))
    camera.SetViewAngle(40)
    bright = view.picture()[:, :, 0]
    look.ShadowsOn()
    shown = view.picture()[:, :, 0]
    wt.save(shown, wt.output_folder() / "shadow_on_waves.png")
    start, ray = ray_caster.eye_rays(camera, coasts.SIZE, 1)
    is_down = ray[:, 2] < -0.05
    place = surface_along(water, start[is_down], ray[is_down])
    _, hides = ray_caster.cast([post], (0, 0, 0), start[is_down], ray[is_down])
    way = np.linalg.norm(place - start[is_down], axis=1)
    _, stops = ray_caster.cast([post], (0, 0, 0), place + 1e-3 * to_sun, np.tile(to_sun, (len(place), 1)))
    shape = bright.shape
    is_water, shaded = np.zeros(bright.size, dtype=bool), np.zeros(bright.size, dtype=bool)
    is_water[is_down] = hides > way
    shaded[is_down] = np.isfinite(stops)
    is_water, shaded = is_water.reshape(shape) & (bright > 15), shaded.reshape(shape)
    at_rest = np.zeros(bright.size, dtype=bool)
    flat = start[is_down] - start[is_down][:, 2:] / ray[is_down][:, 2:] * ray[is_down]
    at_rest[is_down] = np.isfinite(ray_caster.cast([post], (0, 0, 0), flat, np.tile(to_sun, (len(flat), 1)))[1])
    is_clear = is_water & ~(coasts.around(is_water & shaded) & coasts.around(is_water & ~shaded))
    wrong = is_clear & ((shown < 0.5 * bright) != shaded)
    unlike = is_clear & (at_rest.reshape(shape) != shaded)
    wt.check_at_least("waves: pixels in the shadow", int((is_water & shaded).sum()), 500)
    wt.check_at_least("waves: % of the water that a level surface would shade wrongly",
                      100 * float(unlike.sum() / is_water.sum()), 1.0)
    wt.check_at_most("waves: % that is dark or lit wrongly", 100 * float(wrong.sum() / is_water.sum()), LIMIT)
