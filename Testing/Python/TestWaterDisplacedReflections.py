# SPDX-License-Identifier: BSD-3-Clause
"""Displaced waves reflect what a ray caster says, from the points where its rays meet them.

Smooth islands in a swell of 0.3 m rms. The ray caster finds where a pixel's ray first meets the
waves, by the definition of their height; from there on it is TestWaterLookupError's.
"""

import numpy as np
import pytest
import ray_caster
import water_test as wt
from wave_scenes import looked_up, map_shows, reflected_at

SIZE = (176, 132)
RMS_HEIGHT = 0.3
ISLANDS = tuple(
    ray_caster.Sphere(center, radius, color)
    for center, radius, color in (
        ((-6.0, 8.0, -2.4), 5.2, (0.2, 0.5, 0.2)),
        ((5.0, 10.0, -4.0), 7.5, (0.4, 0.4, 0.2)),
        ((0.5, 1.5, -1.6), 3.0, (0.6, 0.5, 0.4)),
        ((-18.0, 34.0, -6.0), 16.0, (0.3, 0.3, 0.5)),
        ((19.0, 38.0, -9.0), 20.0, (0.5, 0.3, 0.3)),
    )
)
VIEWS = {"middle": (2, -18, 5), "low": (3, -16, 2.2), "high": (1, -12, 12)}


def waves_of(lengths):
    """Wavelength, direction and phase of each; together they have the rms height."""
    each = RMS_HEIGHT * np.sqrt(2.0 / len(lengths))
    return tuple((each, length, 20.0 + 55.0 * i, 70.0 * i) for i, length in enumerate(lengths))


def scene(position, waves, size=SIZE):
    made = wt.View(size, (0.55, 0.7, 0.9))
    for island in ISLANDS:
        wt.add_actor(made.renderer, wt.sphere(island.center, island.radius, 200), island.color, lit=False)
    water = wt.add_water(made.renderer, None, (-200, 200, -200, 200))
    for wave in waves:
        water.GetWaterProperty().AddWave(*wave)
    water.GetWaterProperty().WaveGeometryOn()
    wt.place_camera(made.renderer, position, (0, 2, 0), (0.5, 150))
    return made, water


def truth(camera, water, waves, size):
    """For every pixel: the right place in the reflection texture, whether it counts, and how far away its waves are."""
    start, ray = ray_caster.eye_rays(camera, size, 1)
    _, distance = ray_caster.cast(ISLANDS, (0, 0, 0), start, ray)
    to_water = ray_caster.meet_waves(start, ray, waves, 0.0, 150)
    counts = to_water < np.minimum(distance, 150)
    place = start + np.where(np.isfinite(to_water), to_water, 0)[:, None] * ray
    away, normal = reflected_at(waves, place, ray, size)
    _, length = ray_caster.cast(ISLANDS, (0, 0, 0), place + 1e-9 * normal, away)
    counts &= (away[:, 2] > 0) & np.isfinite(length)
    met = place + np.where(counts, length, 0)[:, None] * away
    trough = -sum(wave[0] for wave in waves)  # the deepest
    right, is_shown, texture_size = map_shows(camera, water, ISLANDS, met, size, trough)
    return right, counts & is_shown, texture_size, to_water


def describe(errors):
    return (f"median {np.median(errors):.3f} px, 95 % within {np.percentile(errors, 95):.2f} px, "
            f"{100 * (errors < 1).mean():.2f} % under 1 px, {len(errors)} pixels")


def off_silhouettes(to_water, size):
    """Pixels whose neighbours show the same wave: a mean over a pixel has a meaning there."""
    way = np.where(np.isfinite(to_water), to_water, 1e9).reshape(size[::-1])
    smooth = np.ones_like(way, dtype=bool)
    across = np.abs(np.diff(way, axis=1)) < 0.1 * way[:, 1:]
    down = np.abs(np.diff(way, axis=0)) < 0.1 * way[1:]
    smooth[:, 1:] &= across
    smooth[:, :-1] &= across
    smooth[1:] &= down
    smooth[:-1] &= down
    return smooth.ravel()


LONG_WAVES, STEEP_WAVES = (24, 15, 9), (12, 7, 4)  # wavelengths, m


def lookup_errors(lengths):
    """How far, in px of the reflection texture, reflections of three views are looked up from their places; and which
    of these pixels are off silhouettes."""
    waves = waves_of(lengths)
    errors, smooth = [], []
    for view, position in VIEWS.items():
        made, water = scene(position, waves)
        look = water.GetWaterProperty()
        if lengths == STEEP_WAVES:
            # many rays are long and end on thin slivers of an island: what the march loses there is 006's subject
            look.SetRayTraceSteps(256)
            look.SetRayTraceProbes(64)
        made.picture()
        is_water = wt.water_mask(made, water).ravel()
        right, counts, texture_size, to_water = truth(made.renderer.GetActiveCamera(), water, waves, SIZE)
        counts &= is_water
        found = np.linalg.norm((looked_up(made, water) - right) * texture_size, axis=1)[counts]
        errors.append(found)
        smooth.append(off_silhouettes(to_water, SIZE)[counts])
        print(f"waves {lengths} m, slope {look.GetSlopeRMS():.2f}, {view}: {describe(found)}")
    return np.concatenate(errors), np.concatenate(smooth)


@pytest.mark.parametrize("lengths", (LONG_WAVES, STEEP_WAVES), ids=("long_waves", "steep_waves"))
def test_a_reflection_is_looked_up_at_the_ray_casters_place(lengths):
    """Long waves at the default quality, and steep ones at a fine one, look up what the ray caster says."""
    errors, smooth = lookup_errors(lengths)
    name = f"waves {lengths} m"
    print(f"{name}: {describe(errors)}")
    print(f"{name}, off silhouettes: {describe(errors[smooth])}")
    wt.check_at_least(f"{name}: pixels", len(errors), 2500)
    wt.check_at_most(f"{name}: median error, px", float(np.median(errors)), 0.2)
    wt.check_at_least(f"{name}, off silhouettes: % under 1 px", 100 * float((errors[smooth] < 1).mean()), 94)
    if lengths == LONG_WAVES:
        wt.check_at_least(f"{name}, default quality: % under 1 px", 100 * float((errors < 1).mean()), 95)


def shown_wrongly(waves, size=(200, 120), reach=3):
    """A white raft before black: the share that shows it of the water that reflects none of it within reach (px),
    and the raft's shares of all of the water, here and by the ray caster."""
    made = wt.View(size, (0.0, 0.0, 0.0))
    water = wt.add_water(made.renderer, None, (-500, 500, -500, 500))
    for wave in waves:
        water.GetWaterProperty().AddWave(*wave)
    water.GetWaterProperty().WaveGeometryOn()
    floating = water.GetWaveHeight(-5, 7)
    raft = [ray_caster.Box((-5, 7, floating + z), lengths, (1.0, 1.0, 1.0))
            for z, lengths in ((0.0, (3.2, 1.8, 0.5)), (0.7, (1.2, 1.0, 1.0)))]
    for box in raft:
        wt.add_actor(made.renderer, wt.box(0.5 * (box.low + box.high), box.high - box.low), (1, 1, 1), lit=False)
    camera = wt.place_camera(made.renderer, (-1.2, -13, 2.3), (-5, 7, 0.6), (0.5, 1500))
    camera.SetViewAngle(16)
    shown = made.picture()[:, :, 0].ravel() / 255
    start, ray = ray_caster.eye_rays(camera, size, 1)
    _, distance = ray_caster.cast(raft, (0, 0, 0), start, ray)
    to_water = ray_caster.meet_waves(start, ray, waves, 0.0, 600)
    counts = (to_water < np.minimum(distance, 600)) & wt.water_mask(made, water).ravel()
    place = start + np.where(counts, to_water, 0)[:, None] * ray
    _, slope_x, slope_y = ray_caster.heights_and_slopes(waves, place[:, 0], place[:, 1], 0.0)
    normal = np.stack([-slope_x, -slope_y, np.ones_like(slope_x)], axis=1)
    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
    away = ray - 2 * (ray * normal).sum(axis=1, keepdims=True) * normal
    away[:, 2] = np.abs(away[:, 2])
    right = ray_caster.cast(raft, (0, 0, 0), place + 1e-6 * normal, away)[0][:, 0] * counts
    near = np.pad(right.reshape(size[1], size[0]), reach, mode="edge")
    near = np.lib.stride_tricks.sliding_window_view(near, (2 * reach + 1, 2 * reach + 1)).max(axis=(2, 3)).ravel()
    free = counts & (near == 0)
    return float((shown[free] > 0.5).mean()), float(shown[counts].mean()), float(right[counts].mean())


LONG = ((0.42, 19.0, 75.0, 180.0), (0.16, 9.0, 110.0, 0.0), (0.07, 4.7, 50.0, 0.0))
SHORT = ((0.025, 2.1, 95.0, 0.0), (0.010, 1.1, 20.0, 0.0), (0.005, 0.6, 130.0, 0.0))


@pytest.mark.parametrize("name, waves", (("long waves", LONG), ("and short ones", LONG + SHORT)),
                         ids=("long_waves", "and_short_ones"))
def test_water_that_a_raft_hides_from_the_mirror_shows_the_sky(name, waves):
    """A raft on a wave hides water beyond it from the mirrored eye, and its bottom is in the mirrored view: that
    water still shows the sky, where pixels resolve the waves (one ray each) and where they do not (several)."""
    wrong, shown, right = shown_wrongly(waves)
    wt.check_at_most(f"a raft on {name}: % of the water that shows it wrongly", 100 * wrong, 0.1)
    wt.check_at_most(f"a raft on {name}: its share of the water ({shown:.4f}), % off the ray caster's",
                     100 * abs(shown / right - 1), 30)
