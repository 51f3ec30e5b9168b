# SPDX-License-Identifier: BSD-3-Clause
"""Behind a dome port that is half under water the picture is half above and half under it: no surface is seen where
view rays begin under water, and they go straight on there."""

import numpy as np
import pytest
import water_test as wt
from vtkwater import vtkWaterActor, vtkWaterProperty

SIZE = (240, 180)
SKY = (0.55, 0.7, 0.9)
BED = 2.0  # m under the water
BED_COLOR = np.array((0.8, 0.7, 0.5))
DEEP = np.array((0.05, 0.2, 0.3))
EXTINCTION = np.array((0.5, 0.2, 0.1))  # 1/m
HEIGHT, RADIUS = 0.04, 0.3  # m, of the eye and of the port
ANGLE = 50.0  # degrees, the camera's


class Scene:
    """A bed, a box that stands on it and out of the water, and calm clear water."""

    def __init__(self, radius=RADIUS, height=HEIGHT, is_endless=True, parallel=False):
        self.view = wt.View(SIZE, SKY)
        wt.add_actor(self.view.renderer, wt.box((0, 0, -BED - 0.5), (400, 400, 1)), BED_COLOR, lit=False)
        wt.add_actor(self.view.renderer, wt.box((0.5, 6, -0.5), (1.5, 1, 3)), (0.8, 0.2, 0.1), lit=False)
        self.water = vtkWaterActor()
        if is_endless:
            self.water.SetSheetToHorizon()
        else:
            self.water.SetSheetBounds(-100, 100, -100, 100)
        look = self.look = self.water.GetWaterProperty()
        look.RefractionOn()
        look.SetAbsorption(*EXTINCTION)
        look.SetScattering(0, 0, 0)
        look.SetDeepColor(*DEEP)
        look.SetDomePortRadius(radius)
        self.view.renderer.AddActor(self.water)
        self.errors = wt.errors_of(self.water)
        camera = wt.place_camera(self.view.renderer, (0, 0, height), (0, 10, height), (0.01, 400))
        camera.SetViewAngle(ANGLE)
        camera.SetParallelProjection(parallel)


def rays():
    """Unit view rays of the pixels, x, forward and up; rows from the bottom."""
    scale = np.tan(np.radians(0.5 * ANGLE)) * 2 / SIZE[1]
    x = (np.arange(SIZE[0]) + 0.5 - 0.5 * SIZE[0]) * scale
    up = (np.arange(SIZE[1]) + 0.5 - 0.5 * SIZE[1]) * scale
    ray = np.stack(np.broadcast_arrays(x[None, :], 1.0, up[:, None]), axis=2)
    return ray / np.linalg.norm(ray, axis=2, keepdims=True)


def way_to_surface(height=HEIGHT):
    down = -rays()[:, :, 2]
    return np.where(down > 0, height / np.maximum(down, 1e-9), np.inf)


def under_water(picture):
    """Which pixels begin under water, and which of all are further than a pixel from the waterline on the glass."""
    way = way_to_surface()
    under = way < RADIUS
    away = np.ones_like(under)
    for axis in (0, 1):
        for step in (-1, 1):
            away &= np.roll(under, step, axis) == under
    return under, away


@pytest.mark.parametrize("hardware", [False, True])
@pytest.mark.parametrize("is_endless", [True, False], ids=["to_the_horizon", "bounded"])
def test_half_above_and_half_under_water(is_endless, hardware, monkeypatch):
    """Under the waterline on the glass the bed is seen straight, through the water behind the glass alone; over it the
    picture is as without a port."""
    monkeypatch.setenv("VTK_WATER_SOFTWARE", "0" if hardware else "1")
    shown = Scene(is_endless=is_endless).view.picture()
    plain = Scene(radius=0.0, is_endless=is_endless).view.picture()
    under, away = under_water(shown)
    wt.check_at_least("share of the picture under water", float(under.mean()), 0.3)
    wt.check_at_most("share of the picture under water", float(under.mean()), 0.5)
    above = np.abs(shown - plain).max(axis=2)[~under & away]
    wt.check_equal("pixels over the waterline that differ", int((above > 1).sum()), 0)
    down = -rays()[:, :, 2]
    way = (HEIGHT + BED) / np.maximum(down, 1e-9) - RADIUS
    left = np.exp(-EXTINCTION * way[:, :, None])
    bed = 255 * (left * BED_COLOR + (1 - left) * DEEP)
    box = np.abs(rays()[:, :, 0] * (5.5 / rays()[:, :, 1]) - 0.5) < 1.0  # what may hide it
    off = np.abs(shown - bed).max(axis=2)[under & away & ~box]
    wt.check_equal("pixels of the bed that differ from the formula", int((off > 2).sum()), 0)
    bent = np.abs(plain - bed).max(axis=2)[under & away & ~box]
    wt.check_at_least("share of them that differ without a port", float((bent > 2).mean()), 0.9)


@pytest.mark.parametrize("hardware", [False, True])
def test_waterline_on_the_glass_shows_what_is_beside_it(hardware, monkeypatch):
    """A pixel on the waterline shows what is seen over it and under it, mixed, and no place of the bed between both."""
    monkeypatch.setenv("VTK_WATER_SOFTWARE", "0" if hardware else "1")
    pictures = []
    for radius in (RADIUS, 0.0, 1.5 * RADIUS):
        scene = Scene(radius=radius)
        scene.look.SetAbsorption(0, 0, 0)  # the way in the glass counts for nothing
        wt.add_actor(scene.view.renderer, wt.box((0, 9, -BED), (100, 6, 0.02)), (1, 1, 1), lit=False)
        pictures.append(scene.view.picture())
    shown, over, under = pictures
    line = ~under_water(shown)[1] & (way_to_surface() < 1.2 * RADIUS) & (way_to_surface() > 0.8 * RADIUS)
    line &= np.abs(rays()[:, :, 0] * (5.5 / rays()[:, :, 1]) - 0.5) > 1.0  # beside the box
    least, most = np.minimum(over, under), np.maximum(over, under)
    off = np.maximum(least - shown, shown - most).max(axis=2)[line]
    wt.check_at_least("pixels on the waterline", int(line.sum()), 100)
    wt.check_equal("pixels on the waterline that show something else", int((off > 2).sum()), 0)


def test_box_is_where_it_is():
    """The foot of a box under water is seen where it is; without a port refraction lifts it."""
    shown, plain = Scene().view.picture(), Scene(radius=0.0).view.picture()
    column = SIZE[0] // 2 + 10
    feet = [int(np.flatnonzero(np.abs(picture[:, column] - picture[:, 5]).max(axis=1) > 12).min())
            for picture in (shown, plain)]
    foot = SIZE[1] / 2 * (1 - (HEIGHT + BED) / 5.5 / np.tan(np.radians(0.5 * ANGLE)))
    wt.check_at_most("foot, px", abs(feet[0] - foot), 1.0)
    wt.check_at_least("foot without a port, px higher", feet[1] - foot, 5.0)


@pytest.mark.parametrize("name, more", (
    ("over the port", {"height": 1.01 * RADIUS}), ("under water", {"height": -0.1}), ("parallel", {"parallel": True}),
), ids=("over_the_port", "under_water", "parallel"))
def test_port_shows_nothing_else(name, more):
    """An eye higher than the port's radius, one under water, and parallel rays see what they see without a port."""
    off = np.abs(Scene(**more).view.picture() - Scene(radius=0.0, **more).view.picture()).max(axis=2)
    wt.check_equal(f"{name}: pixels that differ", int((off > 0).sum()), 0)


def test_waves_move_the_waterline():
    """In displaced waves the waterline on the glass rises and falls with the time, without a hole."""
    scene = Scene()
    scene.look.AddWave(0.02, 2.0, 10.0)
    scene.look.WaveGeometryOn()
    shares = []
    for time in np.linspace(0.0, 1.0, 5):
        scene.water.SetTime(time)
        picture = scene.view.picture()
        lower = picture[:SIZE[1] // 4]
        shares.append(float((np.abs(picture - Scene(radius=0.0).view.picture()).max(axis=2) > 2).mean()))
        wt.check_at_least("darkest of the lower quarter, green", float(lower[:, :, 1].min()), 30)
    wt.check_at_least("most and least share that differs", max(shares) - min(shares), 0.02)
    wt.check_equal("errors", scene.errors, [])


@pytest.mark.parametrize("radius", (-1.0, float("nan"), float("inf")))
def test_wrong_radius_is_an_error(radius):
    """A radius that is negative or no number is an error with the name and the range; it stays as it was."""
    look = vtkWaterProperty()
    errors = wt.errors_of(look)
    look.SetDomePortRadius(0.2)
    look.SetDomePortRadius(radius)
    wt.check_equal("radius", look.GetDomePortRadius(), 0.2)
    wt.check_equal("errors", len(errors), 1)
    wt.check_equal("name and range", "DomePortRadius" in errors[0] and "[0," in errors[0], True)
