# SPDX-License-Identifier: BSD-3-Clause
"""What a sea reflects of an object, whose waves a pixel does not resolve: against many rays to the wave heights' twin."""

import numpy as np
import pytest
import random_seas
import water_test as wt

SIZE = (240, 160)
SKY = (0.0, 0.0, 0.3)
WALLS = {  # lower and upper corner; the most RMSE of 255 with default and with high quality
    "high": (np.array([(-15.0, 79.0, -1.0), (15.0, 81.0, 19.0)]), {"default": 18.0, "high": 18.0}),
    "low": (np.array([(-25.0, 59.0, -1.0), (25.0, 61.0, 4.0)]), {"default": 22.0, "high": 22.0}),
}
SLAB = np.array([(-60.0, 59.0, 11.0), (60.0, 69.0, 12.5)])  # hangs over the water
HORIZON = 90  # rows that show water alone
ROWS, COLUMNS = range(4, 84, 8), range(20, 220, 16)
SIDE = 7  # rays in each direction of a pixel
SEAS = range(101, 107)


def sea(wall, color=(1.0, 0.0, 0.0)):
    """A wall on a wind sea that is a mirror."""
    view = wt.View(SIZE, background=SKY)
    water = wt.add_water(view.renderer)
    look = water.GetWaterProperty()
    look.SeaOn()
    look.SetWindSpeed(12.0)
    look.SetFetch(60e3)
    look.SetSeaCascades(3)
    water.SetSheetToHorizon()
    wt.add_actor(view.renderer, wt.box(wall.mean(axis=0), wall[1] - wall[0]), color, lit=False)
    wt.place_camera(view.renderer, (0.0, 0.0, 8.0), (0.0, 30.0, 0.0), (0.5, 5000.0))
    return view, water


def meets_wall(wall, start, way):
    near, far = np.sort([(corner - start) / way for corner in wall], axis=0)
    return near.max() <= far.min() and far.min() >= 0.0


def share_of_wall(wall, water, camera, row, column):
    """Of the light that a pixel reflects, the wall's: surfaces count as wide as the eye sees them."""
    eye = np.array(camera.GetPosition())
    ahead = wt.unit(np.array(camera.GetFocalPoint()) - eye)
    right = wt.unit(np.cross(ahead, (0.0, 0.0, 1.0)))
    up = np.cross(right, ahead)
    half = np.tan(np.radians(camera.GetViewAngle() / 2))
    met = seen = 0.0
    normal = [0.0, 0.0, 0.0]
    for place in np.ndindex(SIDE, SIDE):
        y, x = (2 * (np.array((row, column)) + (np.array(place) + 0.5) / SIDE) - (SIZE[1], SIZE[0])) / SIZE[1]
        start, ray = eye, wt.unit(ahead + half * (x * right + y * up))
        if camera.GetParallelProjection():
            start, ray = eye + camera.GetParallelScale() * (x * right + y * up), ahead
        point = start - ray * start[2] / ray[2]
        water.GetWaveNormal(point[0], point[1], normal)
        facing = -np.dot(ray, normal)
        if facing <= 0.0:
            continue  # hidden behind waves that face the eye
        mirrored = ray + 2.0 * facing * np.array(normal)
        mirrored[2] = max(abs(mirrored[2]), 1e-6)  # once more off the water
        met += meets_wall(wall, point, mirrored) * facing / normal[2]
        seen += facing / normal[2]
    return met / max(seen, 1e-12)


@pytest.mark.parametrize("software", ["1", "0"])
@pytest.mark.parametrize("name", WALLS)
def test_a_sea_reflects_what_many_rays_meet(monkeypatch, name, software):
    """A high wall, whose edge is between the facets, and a low one, which only a nearly level ray meets."""
    monkeypatch.setenv("VTK_WATER_SOFTWARE", software)  # the rules of both kinds of renderer
    wall, most = WALLS[name]
    view, water = sea(wall)
    camera = view.renderer.GetActiveCamera()
    view.picture()
    truth = np.array([[255 * share_of_wall(wall, water, camera, row, column) for column in COLUMNS] for row in ROWS])
    wt.check_at_least(f"{name}: mean of the wall's red in the truth", float(truth.mean()), 20.0)
    for quality, limit in most.items():
        water.GetWaterProperty().SetRayTraceQuality(quality)
        picture = view.picture()[..., 0][np.ix_(ROWS, COLUMNS)]
        label = f"{name} wall, {quality}"
        wt.check_at_most(f"{label}: RMSE of 255", float(np.sqrt(((picture - truth) ** 2).mean())), limit)
        wt.check_at_most(f"{label}: mean, from the truth's", float(abs(picture.mean() - truth.mean())), 4.0)


@pytest.mark.parametrize("software", ["1", "0"])
def test_what_looks_like_the_sky_changes_no_water(monkeypatch, software):
    """A slab over the sea in the sky's colour: its edges give slopes to another facet, which keep their reflectance."""
    monkeypatch.setenv("VTK_WATER_SOFTWARE", software)
    view, water = sea(SLAB, SKY)
    water.GetWaterProperty().SetReflectanceModeToFresnel()
    water.GetWaterProperty().SetDeepColor(0.0, 0.0, 0.0)
    with_slab = view.picture().astype(int)[:HORIZON]
    view.renderer.GetActors().GetLastActor().VisibilityOff()
    without = view.picture().astype(int)[:HORIZON]
    wt.check_at_least("the water's blue", float(without[..., 2].mean()), 5.0)
    wt.check_at_most("a slab of the sky's colour: largest difference of the water", int(abs(with_slab - without).max()), 1)


@pytest.mark.parametrize("software", ["1", "0"])
def test_high_takes_all_slopes(monkeypatch, software):
    """Of random seas: facets either meet a thing or miss it, and their share of a hanging one jumps from pixel to pixel."""
    monkeypatch.setenv("VTK_WATER_SOFTWARE", software)
    errors = {"default": [], "high": []}
    for seed in SEAS:
        sea_of = random_seas.Sea(seed)
        sea_of.view.picture()
        truth, is_water = sea_of.truth()
        for quality, found in errors.items():
            off = sea_of.picture(quality)[is_water] - truth
            found.append(np.sqrt((off**2).mean()))
            print(f"sea {seed}, {quality}: RMSE of 255: {found[-1]:.2f}")
    mean = {quality: np.mean(found) for quality, found in errors.items()}
    wt.check_at_most(f"{len(SEAS)} random seas, high: mean RMSE of 255", mean["high"], 15.0)
    wt.check_at_most(f"{len(SEAS)} random seas: high / default", mean["high"] / mean["default"], 0.9)


def lit_by_wall(wall, eye, ray, variance):
    """Of the light that a mirror of normally distributed slopes reflects along a ray, the wall's."""
    azimuth = wt.unit((ray[0], ray[1], 0.0))
    point = eye - ray * eye[2] / ray[2]
    met = seen = 0.0
    for slope in np.arange(-4.0, 4.0, 0.02):
        normal = wt.unit(np.array((0.0, 0.0, 1.0)) - np.sqrt(variance) * slope * azimuth)
        facing = max(-np.dot(ray, normal), 0.0) / normal[2] * np.exp(-0.5 * slope**2)
        mirrored = ray - 2.0 * np.dot(ray, normal) * normal
        mirrored[2] = max(abs(mirrored[2]), 1e-6)  # once more off the water
        met += meets_wall(wall, point, mirrored + 1e-9) * facing
        seen += facing
    return met / seen


@pytest.mark.parametrize("software", ["1", "0"])
def test_the_flattest_slopes_of_high_meet_a_wall_that_stands_in_the_water(monkeypatch, software):
    """From a low eye many rays are flatter than the last one that is looked for; they meet what that one meets."""
    monkeypatch.setenv("VTK_WATER_SOFTWARE", software)
    wall, variance = np.array([(-200.0, 40.0, -1.0), (200.0, 42.0, 4.0)]), 0.05
    view = wt.View(SIZE, background=(0.0, 0.0, 0.3))
    water = wt.add_water(view.renderer)
    look = water.GetWaterProperty()
    look.SetSlopeVariance(variance, variance)
    look.SetRayTraceQualityToHigh()
    water.SetSheetToHorizon()
    wt.add_actor(view.renderer, wt.box(wall.mean(axis=0), wall[1] - wall[0]), (1.0, 0.0, 0.0), lit=False)
    eye = np.array((0.0, 0.0, 1.0))
    camera = wt.place_camera(view.renderer, eye, (0.0, 30.0, 1.0), (0.1, 5000.0))
    picture = view.picture()[..., 0]
    half = np.tan(np.radians(camera.GetViewAngle() / 2))
    rows = range(8, 72, 8)
    rays = [wt.unit((half / SIZE[1], 1.0, half * ((2 * row + 1) / SIZE[1] - 1.0))) for row in rows]
    truth = np.array([255 * lit_by_wall(wall, eye, ray, variance) for ray in rays])
    off = picture[list(rows), SIZE[0] // 2] - truth
    print("rows' truth of 255:", np.round(truth, 1), "off by", np.round(off, 1))
    wt.check_at_most("a wall from an eye that is low: most that a row is off, of 255", float(abs(off).max()), 6.0)


@pytest.mark.parametrize("software", ["1", "0"])
def test_high_sees_what_hangs_beside_the_column(monkeypatch, software):
    """A slab over water that a parallel camera sees: waves turn rays to it out of columns that do not show it."""
    monkeypatch.setenv("VTK_WATER_SOFTWARE", software)
    slab = np.array([(-15.0, 59.0, 9.0), (15.0, 69.0, 12.0)])
    view, water = sea(slab)
    water.GetWaterProperty().SetRayTraceQualityToHigh()
    camera = wt.place_camera(view.renderer, (0.0, -40.0, 30.0), (0.0, 40.0, 0.0), (0.5, 5000.0))
    camera.ParallelProjectionOn()
    camera.SetParallelScale(30.0)
    view.picture()
    rows, columns = range(20, 80, 3), (*range(68, 79, 3), *range(162, 173, 3))  # the slab is from 80 to 160
    truth = np.array([[255 * share_of_wall(slab, water, camera, row, column) for column in columns] for row in rows])
    picture = view.picture()[..., 0][np.ix_(rows, columns)]
    print(f"mean of the slab's red beside it: {picture.mean():.2f}, truth {truth.mean():.2f}")
    wt.check_at_least("beside a slab, parallel camera: its red, of the truth's", float(picture.mean() / truth.mean()), 0.5)
