# SPDX-License-Identifier: BSD-3-Clause
"""How far, in pixels, from the right place of the mirrored view a wave's reflection is looked up.

Smooth islands in waves. The ray caster follows a pixel's reflected ray to what it meets; the right
place is where the mirrored view shows that point. Counted are rays that meet an island at a point
which the mirrored view sees and has on its picture: nothing can be looked up of the others. The ray
caster has the normals of the surface under test (wave_scenes.mean_slopes).

With WATER_OTHER_LOOKUPS=1 in the environment, what other lookups and qualities reach is printed, too.
"""

import os

import numpy as np
import pytest
import ray_caster
import water_test as wt
from wave_scenes import (
    ISLANDS,
    ISLANDS_SIZE,
    ISLANDS_VIEWS,
    island_scene,
    island_waves,
    looked_up,
    map_places,
    map_shows,
    mean_slopes,
    reflected_at,
)


def truth(camera, water, waves):
    """For every pixel of the picture: the right place in the reflection texture, and whether it counts."""
    start, ray = ray_caster.eye_rays(camera, ISLANDS_SIZE, 1)
    _, distance = ray_caster.cast(ISLANDS, (0, 0, 0), start, ray)
    with np.errstate(divide="ignore"):
        to_water = np.where(ray[:, 2] < 0, -start[:, 2] / ray[:, 2], np.inf)
    counts = to_water < np.minimum(distance, 150)
    place = start + np.where(np.isfinite(to_water), to_water, 0)[:, None] * ray
    away, _ = reflected_at(waves, place, ray, ISLANDS_SIZE)
    place[:, 2] = 1e-9
    _, length = ray_caster.cast(ISLANDS, (0, 0, 0), place, away)
    counts &= (away[:, 2] > 0) & np.isfinite(length)
    met = place + np.where(counts, length, 0)[:, None] * away
    right, is_shown, texture_size = map_shows(camera, water, ISLANDS, met, ISLANDS_SIZE)
    return right, counts & is_shown, texture_size


class Suite:
    """All views with waves of a slope, and the truth of each."""

    def __init__(self, slope_rms):
        self.slope_rms = slope_rms
        waves = island_waves(slope_rms)
        self.cases = []
        for view in ISLANDS_VIEWS:
            made, water = island_scene(view, waves)
            made.picture()
            is_water = wt.water_mask(made, water).ravel()
            right, counts, texture_size = truth(made.renderer.GetActiveCamera(), water, waves)
            self.cases.append((made, water, right, counts & is_water, texture_size))

    def errors(self, setter, scale=0.0):
        """Distances, in pixels, of the lookups from their right places."""
        found = []
        for made, water, right, counts, texture_size in self.cases:
            getattr(water.GetWaterProperty(), setter)()
            water.GetWaterProperty().SetOffsetScale(scale)
            found.append(np.linalg.norm((looked_up(made, water) - right) * texture_size, axis=1)[counts])
        return np.concatenate(found)


def describe(errors):
    return (f"median {np.median(errors):.3f} px, 95 % within {np.percentile(errors, 95):.2f} px, "
            f"{100 * (errors < 2).mean():.2f} % under 2 px, {len(errors)} pixels")


def print_others(suite):
    """Prints what other lookups reach at their best, and other qualities."""
    for lookup, scales in (("FixedOffset", np.linspace(0, 1, 11)), ("ViewScaledOffset", np.linspace(0, 10, 11)),
                           ("MovedPoint", np.linspace(0, 10, 11))):
        best = min((suite.errors(f"SetLookupTo{lookup}", scale) for scale in scales), key=np.median)
        print(f"slope {suite.slope_rms}: {lookup}, the best of {len(scales)} scales: {describe(best)}")
    suite.errors("SetLookupToRayTraced")
    for quality in ("Fast", "High"):
        print(f"slope {suite.slope_rms}: {quality}: {describe(suite.errors('SetRayTraceQualityTo' + quality))}")


# rms slope of the waves: least share of pixels under 2 px, in percent
SHARES = {0.05: 97, 0.10: 96}


@pytest.fixture(scope="module")
def suite(request):
    """The views with waves of the slope that a test names; each is rendered and cast once."""
    return Suite(request.param)


@pytest.mark.parametrize("suite", SHARES, indirect=True, ids="slope_{}".format, scope="module")
def test_a_traced_reflection_is_looked_up_where_it_is(suite):
    """Rays traced at the default quality look up within a few pixels of the right place, most far closer."""
    slope_rms = suite.slope_rms
    if os.environ.get("WATER_OTHER_LOOKUPS"):
        print_others(suite)
    suite.errors("SetLookupToRayTraced")
    errors = suite.errors("SetRayTraceQualityToDefault")
    name = f"slope {slope_rms}, default quality"
    print(f"{name}: {describe(errors)}")
    wt.check_at_least(f"{name}: pixels", len(errors), 5000)
    wt.check_at_most(f"{name}: median error, px", float(np.median(errors)), 0.1)
    wt.check_at_least(f"{name}: % under 2 px", 100 * float((errors < 2).mean()), SHARES[slope_rms])
    if slope_rms == 0.05:
        wt.check_at_most(f"{name}: 95 % within, px", float(np.percentile(errors, 95)), 0.5)


@pytest.mark.parametrize("suite", [0.10], indirect=True, ids="slope_{}".format, scope="module")
def test_a_moved_point_is_looked_up_at_its_calm_reflection(suite):
    """The classic lookup that moves the point itself looks where that point's calm reflection is."""
    made, water, _, counts, texture_size = suite.cases[0]
    camera = made.renderer.GetActiveCamera()
    start, ray = ray_caster.eye_rays(camera, ISLANDS_SIZE, 1)
    place = start - (start[:, 2] / ray[:, 2])[:, None] * ray
    slope_x, slope_y = mean_slopes(island_waves(suite.slope_rms), place.reshape(ISLANDS_SIZE[1], ISLANDS_SIZE[0], 3))
    length = np.sqrt(1 + slope_x**2 + slope_y**2)
    place[:, :2] -= 0.7 * np.stack([slope_x / length, slope_y / length], axis=1)
    water.GetWaterProperty().SetLookupToMovedPoint()
    water.GetWaterProperty().SetOffsetScale(0.7)
    expected, _ = map_places(camera, water, place, ISLANDS_SIZE)
    error = np.linalg.norm((looked_up(made, water) - expected) * texture_size, axis=1)[counts]
    wt.check_at_most("a point moved by 0.7 m: 99 % of the lookups within, px", float(np.percentile(error, 99)), 0.2)
