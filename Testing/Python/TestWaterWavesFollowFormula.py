# SPDX-License-Identifier: BSD-3-Clause
"""Waves are those of the formula: their heights and slopes at any time, steep and in shallow water; and bad ones are
refused."""

import numpy as np
import pytest
import ray_caster
import water_test as wt
from vtkwater import vtkWaterActor, vtkWaterProperty
from wave_scenes import POSTS_SIZE, POSTS_WAVES, post_scene

NAN, INFINITY = float("nan"), float("inf")


def test_time_alone_makes_the_picture():
    """The picture at 1e6 s does not depend on the frames before it, and is another one second later."""
    made, water = post_scene("middle")
    water.SetTime(1e6)
    straight = made.picture()
    for time in (0.0, 3.7, 12345.6):
        water.SetTime(time)
        made.picture()
    water.SetTime(1e6)
    wt.check_equal("time: 1e6 s after other frames, error", wt.difference(made.picture(), straight), 0)
    water.SetTime(1.0)
    wt.check_at_least("time: 1 s makes another picture", wt.difference(made.picture(), straight), 50)


@pytest.mark.parametrize("time", (0.0, 17.3, 1e4))
def test_heights_and_normals_are_those_of_the_formula(time):
    """GetWaveHeight and GetWaveNormal say at any time what the sum of sines is."""
    _, water = post_scene("middle")
    x, y = np.meshgrid(np.linspace(-7, 7, 9), np.linspace(-5, 9, 9))
    water.SetTime(time)
    height, slope_x, slope_y = ray_caster.heights_and_slopes(POSTS_WAVES, x, y, time)
    found = np.array([water.GetWaveHeight(*place) for place in zip(x.ravel(), y.ravel())])
    wt.check_at_most(f"height at {time:g} s: largest error, m", float(np.abs(found - height.ravel()).max()), 1e-11)
    largest = 0.0
    for place, sx, sy in zip(zip(x.ravel(), y.ravel()), slope_x.ravel(), slope_y.ravel()):
        normal = [0.0, 0.0, 0.0]
        water.GetWaveNormal(*place, normal)
        largest = max(largest, abs(normal[0] / normal[2] + sx), abs(normal[1] / normal[2] + sy))
    wt.check_at_most(f"slope at {time:g} s: largest error", largest, 1e-10)


def test_phases_are_exact_at_large_times():
    """A wave has the same height at the same phase after 1e7 s."""
    period = 2 * np.pi / ray_caster.angular_frequency(POSTS_WAVES[0][1])
    alone = vtkWaterActor()
    alone.GetWaterProperty().AddWave(*POSTS_WAVES[0])
    alone.SetTime(0.25 * period)
    near = alone.GetWaveHeight(0.3, 0.4)
    turns = np.round(1e7 / period)
    alone.SetTime((turns + 0.25) * period)
    wt.check_at_most("time: the same phase at 1e7 s, error of the height, m",
                     abs(alone.GetWaveHeight(0.3, 0.4) - near), 1e-9)


STEEP = (0.08, 2.0, 30.0, 0.0, 0.9)


def steep_slopes(x, y):
    """Of one Gerstner wave: the point at rest is u along the wave with u + Q A cos(k u) = place."""
    amplitude, wavelength, direction, phase, steepness = STEEP
    k = 2 * np.pi / wavelength
    along = np.array((np.cos(np.radians(direction)), np.sin(np.radians(direction))))
    place = x * along[0] + y * along[1]
    low, high = place - amplitude, place + amplitude
    for _ in range(60):
        rest = 0.5 * (low + high)
        is_left = rest + steepness * amplitude * np.cos(k * rest + np.radians(phase)) < place
        low, high = np.where(is_left, rest, low), np.where(is_left, high, rest)
    angle = k * rest + np.radians(phase)
    slope = amplitude * k * np.cos(angle) / (1 - steepness * amplitude * k * np.sin(angle))
    return along[0] * slope, along[1] * slope


def test_steep_waves_move_their_points():
    """A steep wave reflects as a Gerstner wave whose point at rest is found by bisection, and a sine does not."""
    made, water = post_scene("high", waves=(STEEP,))
    look = water.GetWaterProperty()
    look.SetReflectanceModeToFresnel()
    is_water = wt.water_mask(made, water).ravel()
    start, ray = ray_caster.eye_rays(made.renderer.GetActiveCamera(), POSTS_SIZE, 1)
    place = start - (start[:, 2] / ray[:, 2])[:, None] * ray
    normal = np.stack([*(-slope for slope in steep_slopes(place[:, 0], place[:, 1])), np.ones(len(ray))], axis=1)
    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
    expected = ray_caster.fresnel(np.clip(-(ray * normal).sum(axis=1), 0, 1))
    look.SetOutputToReflectance()

    def reflectance_error():
        shown = made.picture().reshape(-1, 3)
        return float(np.percentile(np.abs((256 * shown[:, 0] + shown[:, 1]) / 65535 - expected)[is_water], 99))

    wt.check_at_most("a steep wave: error of the reflectance, 99 % of the pixels", reflectance_error(), 2e-3)
    look.RemoveAllWaves()
    look.AddWave(*STEEP[:4])
    wt.check_at_least("the same wave as a sine: error of the reflectance", reflectance_error(), 1e-2)


def test_depth_slows_long_waves_down():
    """In shallow water the picture at 1 s is that of deep water at the time of the same phase, and not at 1 s."""
    made, water = post_scene("middle", waves=POSTS_WAVES[:1])
    water.GetWaterProperty().SetDepth(0.1)
    water.SetTime(1.0)
    shallow = made.picture()
    water.GetWaterProperty().SetDepth(INFINITY)
    deep_same_time = made.picture()
    length = POSTS_WAVES[0][1]
    water.SetTime(ray_caster.angular_frequency(length, 0.1) / ray_caster.angular_frequency(length))
    wt.check_at_most("depth: largest difference from the same phase in deep water",
                     wt.difference(made.picture(), shallow), 1)
    wt.check_at_least("depth: difference from the same time in deep water", wt.difference(deep_same_time, shallow), 50)


def refused(name, thing, do, words):
    """What a call returns that says one error with these words."""
    errors = wt.errors_of(thing)
    result = do(thing)
    wt.check_equal(f"{name}: errors", len(errors), 1)
    for word in words:
        wt.check_equal(f"{name}: the error says '{word}'", word in "".join(errors), True)
    return result


@pytest.mark.parametrize("wave, words", (
    ((-1.0, 2.0), ("-1", "not negative")),
    ((0.1, 0.0), ("Wavelength 0", "greater than 0")),
    ((NAN, 2.0), ("nan", "finite")),
    ((0.1, 2.0, INFINITY), ("inf", "Direction")),
    ((0.1, 2.0, 0.0, NAN), ("nan", "Phase")),
    ((0.1, 2.0, 0.0, 0.0, 1.5), ("1.5", "[0, 1]")),
    ((1.0, 2.0, 0.0, 0.0, 1.0), ("fold", "exceed 1")),
), ids=("a negative amplitude", "no length", "an amplitude that is no number", "an infinite direction",
        "a phase that is no number", "a steepness over 1", "a fold"))
def test_bad_wave_is_refused(wave, words):
    """A bad wave gives one clear error and is not added."""
    look = vtkWaterProperty()
    wt.check_equal(f"wave {wave}: refused", refused(f"wave {wave}", look, lambda it: it.AddWave(*wave), words), -1)
    wt.check_equal(f"wave {wave}: none added", look.GetNumberOfWaves(), 0)


@pytest.mark.parametrize("time", (NAN, INFINITY))
def test_bad_time_is_refused(time):
    """A time that is not finite gives one clear error, and the last good one stays."""
    water = vtkWaterActor()
    refused(f"time {time}", water, lambda it: it.SetTime(time), (str(time), "finite"))
    wt.check_equal(f"time {time}: the last good one stays", water.GetTime(), 0.0)


@pytest.mark.parametrize("setter, value, words", (
    ("SetDepth", 0.0, ("greater than 0",)),
    ("SetDepth", NAN, ("nan",)),
    ("SetLookup", 4, ("[0, 3]",)),
    ("SetRayTraceSteps", 0, ("[1, 256]",)),
    ("SetRayTraceProbes", -1, ("[0, 64]",)),
    ("SetRayTraceRays", 0, ("[1, 16]",)),
    ("SetRayTraceRays", 17, ("[1, 16]",)),
    ("SetRayTraceLayers", 3, ("[1, 2]",)),
    ("SetRayTraceFootprint", NAN, ("nan", "[0, 1]")),
    ("SetOffsetScale", NAN, ("nan",)),
    ("SetOutput", 4, ("[0, 3]",)),
))
def test_bad_value_is_refused(setter, value, words):
    """A bad value gives one clear error with its range."""
    refused(f"{setter}({value})", vtkWaterProperty(), lambda it: getattr(it, setter)(value), words)
