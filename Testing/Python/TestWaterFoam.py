# SPDX-License-Identifier: BSD-3-Clause
"""Foam lies where the water is shallow, and on the crests of steep waves; nowhere else."""

import numpy as np
import pytest
import water_test as wt
from dark_water import SIZE, add_dark_water, check_refused, look_at
from vtkmodules.vtkFiltersSources import vtkPlaneSource


def places_across(height):
    """x of each column of pixels on the water, for a camera at a height that looks straight down."""
    return (np.arange(SIZE[0]) + 0.5 - SIZE[0] / 2) * 2 * height * np.tan(np.radians(15)) / SIZE[1]


def test_foam_lies_where_the_water_is_shallow():
    """On a bed that slopes, foam is bright at the shore, and there is none in deep water."""
    view = wt.View(SIZE, (0, 0, 0))
    bed = wt.box((0, 0, -0.5), (40, 40, 1))
    points = bed.GetPoints()
    for i in range(points.GetNumberOfPoints()):  # a slope: 1 m deep at x = 5, dry from x = -5 on
        px, py, pz = points.GetPoint(i)
        points.SetPoint(i, px, py, pz - 0.1 * (px + 5))
    wt.add_actor(view.renderer, bed, (0.2, 0.1, 0.1), lit=False)
    wt.add_scene_light(view.renderer, (0, 0, 1))
    look = add_dark_water(view).GetWaterProperty()
    look.RefractionOn()
    look.SetFoamDepth(0.4)
    look_at(view, (0, 0, 25), up=(0, 1, 0))
    row = view.picture()[100:120, :, 2].mean(axis=0)
    depth = 0.1 * (places_across(25) + 5)
    wt.check_at_least("foam: mean of 255 where the water is under 8 cm",
                      float(row[(depth > 0) & (depth < 0.08)].mean()), 180)
    wt.check_at_most("foam: mean of 255 where it is over 40 cm", float(row[depth > 0.42].mean()), 45)


def foamy(height, depth):
    """White foam on a bed of one depth, seen from straight above."""
    view = wt.View(SIZE, (0, 0, 0))
    wt.add_actor(view.renderer, wt.box((0, 0, -0.5 - depth), (400, 400, 1)), (0, 0, 0), lit=False)
    wt.add_scene_light(view.renderer, (0, 0, 1))
    water = add_dark_water(view)
    look = water.GetWaterProperty()
    look.GlitterOff()
    look.RefractionOn()
    look.SetFoamDepth(1.0)
    look.SetFoamColor(1, 1, 1)
    look_at(view, (0, 0, height), up=(0, 1, 0)).SetClippingRange(0.9 * height, 1.1 * height)
    return view, water


@pytest.mark.parametrize("depth", (0.3, 0.5, 0.8))
def test_far_foam_is_the_mean_of_near_foam(depth):
    """The lace covers as much of the water as it does where its pixels are too large to show it."""
    means = []
    for height in (25, 250):
        view, water = foamy(height, depth)
        frames = []
        for time in (0, 2, 4, 6, 8, 10):
            water.SetTime(time)
            frames.append(view.picture()[:, :, 0].mean() / 255)
        means.append(np.mean(frames))
    wt.check_at_most("mean of near foam minus that of far foam", float(abs(means[0] - means[1])), 0.05)


def winding_shore(size, foam=0.25):
    """Black islands in dark water, from so far and so low that the foam of their shores is narrower than a pixel."""
    view = wt.View(size, (0, 0, 0))
    source = vtkPlaneSource()
    source.SetOrigin(-200, -200, 0)
    source.SetPoint1(200, -200, 0)
    source.SetPoint2(-200, 200, 0)
    source.SetResolution(80, 80)
    source.Update()
    bed = source.GetOutput()
    points = bed.GetPoints()
    for i in range(points.GetNumberOfPoints()):
        x, y, _ = points.GetPoint(i)
        points.SetPoint(i, x, y, 3 * np.sin(x / 17 + 0.5) * np.cos(y / 23) - 1)
    wt.add_actor(view.renderer, bed, (0, 0, 0), lit=False)
    wt.add_scene_light(view.renderer, (0, 0, 1))
    look = add_dark_water(view).GetWaterProperty()
    look.SetMetresPerUnit(1.0)
    look.GlitterOff()
    look.RefractionOn()
    look.SetFoamDepth(foam)
    look.SetFoamColor(1, 1, 1)
    wt.place_camera(view.renderer, (0, -420, 40), (0, -40, 0), (50, 900))
    return view.picture()[:, :, 0]


def test_far_foam_of_a_shore_has_no_dots():
    """Seen from afar the shore is no row of white pixels that a finer picture does not have, and as bright as there."""
    coarse = winding_shore((160, 120))
    fine = winding_shore((1280, 960)).reshape(120, 8, 160, 8).mean(axis=(1, 3))

    def dots(picture):
        around = np.pad(picture, 1, mode="edge")
        sides = [around[1 + j:121 + j, 1 + i:161 + i] for j in (-1, 0, 1) for i in (-1, 0, 1) if i or j]
        return int((picture - np.max(sides, axis=0) > 25).sum())

    wt.check_at_least("finer picture: brightest pixel", float(fine.max()), 25)
    wt.check_at_most("pixels that are over 25 brighter than all around them, more than in the finer picture",
                     dots(coarse) - dots(fine), 0)
    wt.check_at_most("light of the foam against the finer picture's, relative", abs(float(coarse.sum() / fine.sum()) - 1), 0.25)


def test_near_foam_is_a_lace():
    """Nearly all of its pixels are foam or water, and both there are."""
    view, _ = foamy(8, 0.4)
    shown = view.picture()[:, :, 0] / 255
    wt.check_at_least("share that is foam", float((shown > 0.8).mean()), 0.2)
    wt.check_at_least("share that is water", float((shown < 0.2).mean()), 0.1)


def test_foam_moves_with_the_time_alone():
    view, water = foamy(25, 0.5)
    first = view.picture().astype(int)
    water.SetTime(3)
    later = view.picture().astype(int)
    wt.check_at_least("3 s later: share of pixels that differ", float((np.abs(first - later)[:, :, 0] > 20).mean()), 0.1)
    water.SetTime(12)
    wt.check_at_most("12 s later: largest difference", int(np.abs(first - view.picture()).max()), 1)


@pytest.mark.parametrize("size", (1e-3, 1.0, 1e3, 1e6))
def test_foam_that_fits_the_scene_is_as_wide_in_all_sizes(size):
    """In automatic units the foam of a beach is a visible strip of the picture, whatever the beach measures. In metres it is as
    wide as it is: of a beach of kilometres, a part of a pixel."""
    widths = []
    for fits, units in ((True, "automatic"), (False, "automatic"), (True, "m")):
        view = wt.View((160, 120))
        beach = wt.box((0, 0, -0.05 * size), (size, size, 0.1 * size))
        actor = wt.add_actor(view.renderer, beach, (0, 0, 0))
        actor.RotateX(6)
        half = 0.5 * size
        water = wt.add_water(view.renderer, None, (-half, half, -half, half), None)
        look = water.GetWaterProperty()
        look.RefractionOn()
        look.SetUnits(units)
        look.SetFoamColor(1.0, 1.0, 1.0)
        look.SetFoamDepth(0.25)
        look.SetFoamFitsScene(fits)
        wt.place_camera(view.renderer, (0, -0.01 * size, 1.6 * size), (0, 0, 0), (0.1 * size, 10 * size))
        foam = view.picture().astype(float)
        look.SetFoamDepth(0.0)
        change = np.abs(foam - view.picture()).max(axis=2)
        widths.append(float((change > 10).sum(axis=0).mean()) if not widths else float(change.sum(axis=0).mean() / 255))
    wt.check_at_least("rows of foam, of 120", widths[0], 2.0)
    wt.check_at_most("and no more", widths[0], 10.0)
    wt.check_at_most("rows of 0.25 m in automatic units", widths[1], 1.0)
    if size >= 1e3:
        row = 1.6 * size * 2 * np.tan(np.radians(15)) / 120
        wt.check_at_most("rows of 0.25 m in metres", widths[2], 0.25 / np.tan(np.radians(6)) / row)


def test_deep_water_round_a_thing_in_the_air_has_no_foam():
    """Deep water has no foam, even where its pixels share their samples with a thing that hangs in the air."""
    view = wt.View(SIZE, (0, 0, 0), samples=8)
    wt.add_actor(view.renderer, wt.box((0, 0, -4), (400, 400, 1)), (0, 0, 0), lit=False)
    wt.add_actor(view.renderer, wt.box((0, 0, 1.5), (3, 3, 1)), (0, 0, 0), lit=False)
    wt.add_scene_light(view.renderer, (0, 0, 1))
    look = add_dark_water(view).GetWaterProperty()
    look.GlitterOff()
    look.RefractionOn()
    look.SetFoamDepth(0.4)
    look_at(view, (9, -14, 7))
    wt.check_equal("foam round a thing in the air: brightest pixel", int(view.picture().max()), 0)


def test_foam_lies_on_crests_when_it_is_asked_for():
    """By default crests have no foam; with a stretch they have, and troughs have none."""
    view = wt.View(SIZE, (0, 0, 0))
    wt.add_scene_light(view.renderer, (0, 0, 1))
    look = add_dark_water(view).GetWaterProperty()
    look.GlitterOff()
    look.AddWave(0.3, 2 * np.pi, 0.0, 0.0, 1.0)  # k A Q = 0.3: crests stand at 0.7 of the rest
    look_at(view, (0, 0, 40), up=(0, 1, 0))
    wt.check_equal("foam on crests: none by default", int(view.picture().max()), 0)
    look.SetFoamStretch(1.0)
    row = view.picture()[:, :, 0].mean(axis=0)
    at = places_across(40)
    is_crest = np.abs((at - np.pi / 2 + np.pi) % (2 * np.pi) - np.pi) < 0.4
    is_trough = np.abs((at + np.pi / 2 + np.pi) % (2 * np.pi) - np.pi) < 1.0
    wt.check_at_least("foam on crests: mean of 255 there over that of the troughs",
                      float(row[is_crest].mean()) - float(row[is_trough].mean()), 20)
    wt.check_equal("foam on crests: brightest trough", int(row[is_trough].max()), 0)


@pytest.mark.parametrize("setter, value, words", (
    ("SetFoamDepth", (-1.0,), ("-1", "[0,")),
    ("SetFoamStretch", (1.5,), ("1.5", "[0, 1]")),
    ("SetFoamColor", (0.0, 2.0, 0.0), ("2", "[0, 1]")),
    ("SetShoreSoftness", (float("nan"),), ("nan", "[0,")),
), ids=("a negative depth", "a stretch over 1", "a colour over 1", "a softness that is no number"))
def test_bad_values_are_refused(setter, value, words):
    """A bad value gives one clear error and changes nothing."""
    check_refused(setter, value, words)
