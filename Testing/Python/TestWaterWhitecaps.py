# SPDX-License-Identifier: BSD-3-Clause
"""Whitecaps cover the share of a wind sea that was measured, from near and from far, and stand on its crests."""

import numpy as np
import pytest
import water_test as wt
from dark_water import SIZE, add_dark_water, look_at


def white_sea(wind, height, geometry=False, **settings):
    """A dark sea under the zenith's sun, seen from straight above."""
    view = wt.View(SIZE, (0, 0, 0))
    wt.add_scene_light(view.renderer, (0, 0, 1))
    water = add_dark_water(view)
    look = water.GetWaterProperty()
    look.SetMetresPerUnit(1.0)
    look.GlitterOff()
    look.SeaOn()
    look.SetWindSpeed(wind)
    look.SetFetch(float("inf"))
    look.SetPeakEnhancement(1.0)
    look.SetFoamColor(1, 1, 1)
    look.WhitecapsOn()
    look.SetWaveGeometry(geometry)
    for name, value in settings.items():
        getattr(look, f"Set{name}")(value)
    water.SetSheetBounds(-height, height, -height, height)
    look_at(view, (0, 0, height), up=(0, 1, 0)).SetClippingRange(0.5 * height, 2.0 * height)
    return view, water


def share(view, water, times=(0.0, 30.0, 60.0, 90.0)):
    """Mean of the picture over some times, of white."""
    means = []
    for time in times:
        water.SetTime(time)
        means.append(float(view.picture().mean()) / 255)
    return np.mean(means)


@pytest.mark.parametrize("wind, height", [(10.0, 600.0), (15.0, 600.0), (15.0, 20000.0), (20.0, 2000.0)])
def test_they_cover_the_measured_share(wind, height):
    """From near and from so far that no wave is seen the mean of the picture is the share of Monahan's fit."""
    view, water = white_sea(wind, height)
    measured = 3.84e-6 * wind**3.41
    wt.check_at_most("GetWhitecapCover against the fit, relative",
                     abs(water.GetWaterProperty().GetWhitecapCover() / measured - 1), 1e-12)
    seen = share(view, water)
    wt.check_at_least(f"wind {wind} m/s from {height} m: share that is white ({seen:.4f}), of the measured", seen / measured,
                      1 / 1.5)
    wt.check_at_most(f"wind {wind} m/s from {height} m: share that is white, of the measured", seen / measured, 1.5)


@pytest.mark.parametrize("geometry", (False, True), ids=("flat", "displaced"))
def test_they_stand_on_crests(geometry):
    """The white places lie higher than the sea's mean, by about a standard deviation and more."""
    view, water = white_sea(15.0, 120.0, geometry, SeaChoppiness=0.0)
    highs = []
    spread = []
    for time in (0.0, 30.0, 60.0):
        water.SetTime(time)
        white = view.picture().mean(axis=2) / 255
        height, width = white.shape
        scale = 2 * 120.0 * np.tan(np.radians(15)) / height
        ys, xs = np.nonzero(white > 0.3)
        heights = [water.GetWaveHeight((x + 0.5 - width / 2) * scale, (y + 0.5 - height / 2) * scale)
                   for x, y in zip(xs, ys)]
        highs += heights
        spread += [water.GetWaveHeight(x, y) for x, y in np.random.default_rng(1).uniform(-800, 800, (200, 2))]
    wt.check_at_least("white pixels", len(highs), 30)
    wt.check_at_least("mean height of white places, of the sea's standard deviation",
                      float(np.mean(highs) / np.std(spread)), 0.5)


def test_they_are_off_by_default_and_without_a_sea():
    """Without WhitecapsOn nothing is white, nor without a sea; and there is no cover."""
    view, water = white_sea(15.0, 150.0)
    look = water.GetWaterProperty()
    look.WhitecapsOff()
    wt.check_equal("whitecaps off: brightest pixel", int(view.picture().max()), 0)
    wt.check_equal("whitecaps off: cover", look.GetWhitecapCover(), 0.0)
    look.WhitecapsOn()
    look.SeaOff()
    wt.check_equal("no sea: brightest pixel", int(view.picture().max()), 0)
    wt.check_equal("no sea: cover", look.GetWhitecapCover(), 0.0)
