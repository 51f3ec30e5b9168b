# SPDX-License-Identifier: BSD-3-Clause
"""A dome that is the sky hides the background from the water, whatever its radius: no ray of waves shows the background
that no ray could see, which is magenta here."""

import numpy as np
import pytest
import water_test as wt
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkFiltersSources import vtkSphereSource
from wave_scenes import POSTS_WAVES, reflected_rays

MAGENTA = (1.0, 0.0, 1.0)
DOME = (0.5, 0.7, 0.9)
VIEWS = ((2, -13, 1.2), (2, -13, 4), (2, -13, 9))
SEEDS = range(4)


def scene(seed, radius, view):
    """Floating, hovering and standing balls at random, of colours whose mixtures are never bluer than the dome."""
    made = wt.View((240, 180), MAGENTA)
    random = np.random.default_rng(seed)
    wt.add_actor(made.renderer, wt.sphere((0, 0, 0), radius, 64), DOME, lit=False)
    for _ in range(15):
        center, size = random.uniform((-8, -8, -0.5), (8, 12, 4)), random.uniform(0.3, 1.2)
        color = random.uniform(0, 0.6, 3) * (1, 1, 0) + (0, 0.1, 0)
        wt.add_actor(made.renderer, wt.sphere(tuple(center), size), tuple(color), lit=False)
    water = wt.add_water(made.renderer, None, (-40, 40, -40, 40))
    for amplitude, *wave in POSTS_WAVES:
        water.GetWaterProperty().AddWave(1.5 * amplitude, *wave)
    camera = made.renderer.GetActiveCamera()
    camera.SetPosition(view)
    camera.SetFocalPoint(0, 0, 0)
    camera.SetViewUp(0, 0, 1)
    camera.SetClippingRange(0.1, 2.5 * radius)
    return made, water


def magenta(picture):
    """Pixels with a sixteenth of the background in them, or more: more blue than 0.2 over their green."""
    return int((picture[..., 2].astype(float) - picture[..., 1] > 51 + 16).sum())


@pytest.mark.parametrize("radius", (100.0, 3e4, 6e4))
def test_no_ray_shows_the_background_behind_a_dome(radius):
    """Water in a dome of 100 m to 60 km never shows the background."""
    found = []
    for seed in SEEDS:
        made, _ = scene(seed, radius, VIEWS[0])
        for view in VIEWS:
            made.renderer.GetActiveCamera().SetPosition(view)
            found.append(magenta(made.picture()))
    pixels = 240 * 180 * len(found)
    print(f"dome of {radius:g} m: {sum(found)} of {pixels} pixels, most in a picture {max(found)}")
    wt.check_at_most("pixels that show the background behind a dome, %", 100 * sum(found) / pixels, 0)


def test_a_far_dome_is_reflected_as_a_near_one():
    """A dome of one colour is seen in the water alike from 300 m to 60 km, but for edges."""
    near = scene(0, 300.0, VIEWS[0])[0].picture().astype(int)
    far = scene(0, 6e4, VIEWS[0])[0].picture().astype(int)
    wt.check_at_most("pixels that differ by more than 8 of 255, %",
                     100 * (np.abs(near - far).max(axis=2) > 8).mean(), 3)


@pytest.mark.parametrize("is_software", (0, 1))
def test_a_far_wall_is_met_before_the_end_of_its_rays(is_software, monkeypatch):
    """A wall that does not surround the eye is reflected from 200 km as from 600 m, not taken for the background."""
    monkeypatch.setenv("VTK_WATER_SOFTWARE", str(is_software))
    shown = []
    for distance in (600.0, 2e5):
        made, _ = scene(0, 2 * distance, VIEWS[0])
        wall = wt.box((0, distance, 0), (4 * distance, 0.02 * distance, 4 * distance))
        made.renderer.GetActors().GetItemAsObject(0).GetMapper().SetInputData(wall)
        shown.append((made.picture() == 255 * np.array(MAGENTA)).all(axis=2))
    wt.check_at_most("pixels that show the background before the far wall alone, %", 100 * (shown[1] & ~shown[0]).mean(), 0.1)


def colored_dome(radius):
    """A sphere whose colour changes with direction, so that a ray that is off sees another one; and that colour."""
    dome = vtkSphereSource()
    dome.SetRadius(radius)
    dome.SetThetaResolution(128)
    dome.SetPhiResolution(96)
    dome.Update()
    points = vtk_to_numpy(dome.GetOutput().GetPoints().GetData())
    colors = numpy_to_vtk(np.rint(color_of(points)).astype(np.uint8), deep=True)
    dome.GetOutput().GetPointData().SetScalars(colors)
    return dome.GetOutput()


def color_of(place):
    """255 RGB of a place on the dome: four waves of light around it, and one up it."""
    turn, height = np.arctan2(place[..., 1], place[..., 0]), place[..., 2] / np.linalg.norm(place, axis=-1)
    return 127 + 90 * np.stack([np.cos(4 * turn), np.sin(4 * turn), np.cos(3 * height)], axis=-1)


@pytest.mark.parametrize("is_parallel", (False, True))
def test_rays_that_leave_the_picture_meet_the_dome(is_parallel):
    """Water alone in a dome: every pixel's ray, in the picture or beside it, sees the dome where a sphere is met."""
    radius, size = 60.0, (160, 120)
    made = wt.View(size, MAGENTA)
    dome = wt.add_actor(made.renderer, colored_dome(radius), (1, 1, 1), lit=False)
    dome.GetMapper().ScalarVisibilityOn()
    water = wt.add_water(made.renderer, None, (-40, 40, -40, 40), reflectance=1.0)
    wave = (0.2, 8.0, 30.0, 0.0)  # slope 0.16
    water.GetWaterProperty().AddWave(*wave)
    camera = made.renderer.GetActiveCamera()
    camera.SetPosition(0, -20, 12)
    camera.SetFocalPoint(0, 0, 0)
    camera.SetViewUp(0, 0, 1)
    camera.SetParallelProjection(is_parallel)
    camera.SetParallelScale(8)
    camera.SetClippingRange(0.1, 300)
    shown = made.picture().astype(float)
    mask = wt.water_mask(made, water)
    place, away = reflected_rays(camera, size, (wave,))
    ahead = (place * away).sum(axis=1)
    way = np.sqrt(ahead**2 - (place**2).sum(axis=1) + radius**2) - ahead
    right = color_of(place + way[:, None] * away).reshape(size[1], size[0], 3)
    off = np.abs(shown - right).max(axis=2)[mask]
    wt.check_at_most("median distance from the colour of the dome, of 255", float(np.median(off)), 2)
    wt.check_at_most("pixels that are off by more than 12 of 255, %", 100 * float((off > 12).mean()), 2)


def test_background_is_still_shown_where_nothing_is_drawn():
    """Half a dome about the eye, open before it: the water shows the background there, and not the dome."""
    made, _ = scene(0, 300.0, VIEWS[1])
    open_sky, water = scene(0, 300.0, VIEWS[1])
    dome = open_sky.renderer.GetActors().GetItemAsObject(0)
    half = vtkSphereSource()
    half.SetRadius(300.0)
    half.SetThetaResolution(64)
    half.SetPhiResolution(64)
    half.SetStartTheta(180.0)  # the half behind the eye, which looks to +y
    half.SetEndTheta(360.0)
    half.Update()
    dome.GetMapper().SetInputData(half.GetOutput())
    is_water = wt.water_mask(open_sky, water)
    shown = open_sky.picture()
    enclosed = made.picture()
    is_dome = (np.abs(enclosed.astype(int) - np.rint(255 * np.array(DOME))) <= 2).all(axis=2) & is_water
    is_background = (shown == 255 * np.array(MAGENTA)).all(axis=2)
    wt.check_at_least("of the water that reflects the dome, the share that shows the open sky, %",
                      100 * (is_background & is_dome).sum() / is_dome.sum(), 85)


if __name__ == "__main__":
    raise SystemExit(wt.main(__file__))
