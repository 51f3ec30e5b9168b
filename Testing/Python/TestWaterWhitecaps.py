# SPDX-License-Identifier: BSD-3-Clause
"""Whitecaps cover the share of a wind sea that was measured, from near and from far, and stand on its crests."""

import numpy as np
import pytest
import water_test as wt
from dark_water import SIZE, add_dark_water, look_at
from vtkwater import vtkWaterProperty


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


def share(view, water, times=np.arange(0.0, 600.0, 83.0)):
    """Mean of the picture over some times, of white."""
    means = []
    for time in times:
        water.SetTime(time)
        means.append(float(view.picture().mean()) / 255)
    return np.mean(means)


# winds and heights at the default life time; the other ones near and far
@pytest.mark.parametrize("wind, height, life_time", [
    (5.0, 600.0, 3.5), (10.0, 600.0, 3.5), (15.0, 200.0, 3.5), (15.0, 600.0, 3.5), (15.0, 20000.0, 3.5),
    (20.0, 2000.0, 3.5), (15.0, 600.0, 0.0), (15.0, 20000.0, 0.0), (15.0, 600.0, 8.0), (15.0, 20000.0, 8.0)])
def test_they_cover_the_measured_share(wind, height, life_time):
    """From near and from so far that no wave is seen the mean of the picture is the share of Monahan's fit."""
    view, water = white_sea(wind, height, WhitecapLifeTime=life_time)
    measured = 3.84e-6 * wind**3.41
    wt.check_at_most("GetWhitecapCover against the fit, relative",
                     abs(water.GetWaterProperty().GetWhitecapCover() / measured - 1), 1e-12)
    seen = share(view, water)
    wt.check_at_least(f"wind {wind} m/s from {height} m: share that is white ({seen:.4f}), of the measured",
                      seen / measured, 1 / 1.5)
    wt.check_at_most(f"wind {wind} m/s from {height} m: share that is white, of the measured", seen / measured, 1.5)


@pytest.mark.parametrize("geometry", (False, True), ids=("flat", "displaced"))
def test_they_stand_on_crests(geometry):
    """The white places that break lie higher than the sea's mean, by about a standard deviation and more."""
    view, water = white_sea(15.0, 120.0, geometry, SeaChoppiness=0.0, WhitecapLifeTime=0.0)
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


def test_foam_stays_and_decays():
    """Where much is white, more is left after a second than without a life time, and that decays with it."""
    kept = {}
    for life_time in (0.0, 3.0):
        view, water = white_sea(15.0, 120.0, WhitecapLifeTime=life_time)
        sums = {1.0: [], 3.0: []}
        for start in (10.0, 50.0, 90.0, 130.0):
            water.SetTime(start)
            white = view.picture().mean(axis=2) > 128
            for after, values in sums.items():
                water.SetTime(start + after)
                values.append((view.picture().mean(axis=2)[white].sum() / 255, white.sum()))
        for after, values in sums.items():
            still, places = (sum(parts) for parts in zip(*values))
            kept[life_time, after] = still / places
            print(f"life time {life_time} s: {still / places:.3f} of {places} white pixels are white after {after} s")
    wt.check_at_least("white after 1 s, of that without a life time", kept[3.0, 1.0] / kept[0.0, 1.0], 4.0)
    wt.check_at_most("white after 3 s, of what is after 1 s; less exp(-2 / 3)",
                     abs(kept[3.0, 3.0] / kept[3.0, 1.0] - np.exp(-2 / 3)), 0.1)


@pytest.mark.parametrize("geometry", (False, True), ids=("flat", "displaced"))
def test_foam_depends_on_the_time_alone(geometry):
    """A picture is the same to the bit whatever was drawn before, at times before and after 0."""
    for time in (-7.9,) if geometry else (61.3, -7.9):  # both make the foam in the same way
        view, water = white_sea(12.0, 120.0, geometry, WaveGridSize=64)
        water.SetTime(time)
        alone = view.picture().copy()
        for earlier in (time - 4.0, time - 0.1, time + 5.0, 1000.0):
            water.SetTime(earlier)
            view.picture()
        water.SetTime(time)
        wt.check_equal(f"{time} s: pixels that differ", int((view.picture() != alone).any(axis=2).sum()), 0)
        wt.check_at_least(f"{time} s: white pixels", int((alone > 100).any(axis=2).sum()), 100)


def test_foam_does_not_jump():
    """From picture to picture of a movie of 50 a second, over several steps of earlier times, no picture changes more
    than others."""
    view, water = white_sea(12.0, 400.0, SeaTileSize=128)
    changes = []
    last = None
    for frame in range(40):
        water.SetTime(20.0 + 0.02 * frame)
        now = view.picture().mean(axis=2)
        if last is not None:
            changes.append(float(np.abs(now - last).mean()))
        last = now
    wt.check_at_most("largest change, of the median", max(changes) / np.median(changes), 1.5)


def test_foam_repeats_with_the_sea():
    """A sea with a period has the same foam a period later."""
    view, water = white_sea(12.0, 120.0, SeaPeriod=12.0)
    water.SetTime(6.0)
    first = view.picture().copy().astype(int)
    water.SetTime(18.0)
    wt.check_at_most("largest difference a period later", int(np.abs(view.picture() - first).max()), 2)
    water.SetTime(11.0)
    wt.check_at_least("largest difference at another time", int(np.abs(view.picture() - first).max()), 100)


@pytest.mark.parametrize("life_time", (-1.0, 10.5, float("nan")))
def test_a_wrong_life_time_is_an_error(life_time):
    """The error names the value and the range; the setting stays."""
    look = vtkWaterProperty()
    wt.check_equal("default", look.GetWhitecapLifeTime(), 3.5)
    errors = wt.errors_of(look)
    look.SetWhitecapLifeTime(2.0)
    look.SetWhitecapLifeTime(life_time)
    wt.check_equal("stays", look.GetWhitecapLifeTime(), 2.0)
    wt.check_equal("one error with name and range",
                   len(errors) == 1 and "WhitecapLifeTime" in errors[0] and "[0, 10]" in errors[0], True)
