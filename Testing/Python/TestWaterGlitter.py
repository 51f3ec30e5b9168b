# SPDX-License-Identifier: BSD-3-Clause
"""The sun's glitter has the radiance that photons bring, counted (glitter_truth.py), before it rolls off."""

import glitter_truth
import numpy as np
import pytest
import ray_caster
import water_test as wt
from dark_water import add_dark_water

SIZE = (120, 110)
HEIGHTS = (5, 8, 14, 25, 40, 60)  # degrees of the view: parts of the picture
LEAST = 0.05  # of the picture's light: a part with less has too few photons
PHOTONS = 1_000_000


def scene(sun, wind, direction):
    """Dark water to the horizon whose slopes are Cox and Munk's; its light, its camera, and the slopes' covariance."""
    view = wt.View(SIZE, (0, 0, 0))
    wt.add_scene_light(view.renderer, tuple(sun))
    water = add_dark_water(view)
    water.SetSheetBounds(-5e4, 5e4, -5e4, 5e4)
    look = water.GetWaterProperty()
    look.HighlightRollOffOff()
    along, across = 0.00316 * wind, 0.003 + 0.00192 * wind
    look.SetSlopeVariance(along, across, direction)
    turn = np.radians(direction)
    c, s = np.cos(turn), np.sin(turn)
    tilt = np.radians(32.5)
    camera = wt.place_camera(view.renderer, (0, 0, 10), (0, 10 * np.cos(tilt), 10 - 10 * np.sin(tilt)), (0.1, 1e5))
    camera.SetViewAngle(55)
    covariance = (c * c * along + s * s * across, s * s * along + c * c * across, c * s * (along - across))
    return view, camera, covariance


def radiance_shown(view):
    """The picture over the sun's intensity, which is as large as it can be without a pixel that is clipped."""
    light = view.renderer.GetLights().GetItemAsObject(0)
    intensity = 1.0
    for _ in range(12):
        light.SetIntensity(intensity)
        picture = view.picture()[:, :, 0]
        brightest = picture.max()
        if 150 < brightest < 255:
            return picture / 255 / intensity
        intensity *= 0.25 if brightest == 255 else min(240 / max(brightest, 1), 30)
    raise AssertionError(f"brightest pixel {brightest} at an intensity of {intensity}")


@pytest.mark.parametrize("wind, direction", ((3.0, 0.0), (8.0, 40.0), (15.0, 90.0)))
@pytest.mark.parametrize("height", (10.0, 25.0, 50.0, 80.0))
def test_glitter_has_the_light_of_photons(wind, direction, height):
    """Under low suns and high ones, in light winds and strong ones, and seen at low angles and at steep ones."""
    sun = np.array((0.0, np.cos(np.radians(height)), np.sin(np.radians(height))))
    view, camera, covariance = scene(sun, wind, direction)
    shown = radiance_shown(view)
    truth, _ = glitter_truth.radiance(sun, covariance, camera, SIZE, 1.333, PHOTONS)
    truth = np.pi * truth  # a light of 1 is an irradiance of pi
    _, ray = ray_caster.eye_rays(camera, SIZE, 1)
    seen = np.degrees(np.arcsin(-ray[:, 2])).reshape(SIZE[1], SIZE[0])
    all_of_it = (seen >= HEIGHTS[0]) & (seen < HEIGHTS[-1])
    name = f"sun at {height:g} degrees, wind {wind:g} m/s"
    wt.check_at_most(f"{name}: error of the radiance", abs(float(shown[all_of_it].sum() / truth[all_of_it].sum()) - 1), 0.05)
    for low, high in zip(HEIGHTS, HEIGHTS[1:]):
        part = (seen >= low) & (seen < high)
        if truth[part].sum() > LEAST * truth[all_of_it].sum():
            error = abs(float(shown[part].sum() / truth[part].sum()) - 1)
            wt.check_at_most(f"{name}, seen from {low} to {high} degrees: error of the radiance", error, 0.05)
