# SPDX-License-Identifier: BSD-3-Clause
"""Light shafts: for an eye under water, the light in the water and on what lies in it is what waves gather of the
sun's, moves with them, and is that of calm water in the mean."""

import numpy as np
import pytest
import water_test as wt
from vtkwater import vtkWaterActor, vtkWaterProperty

SIZE = (160, 120)
SKY = (0.0, 0.0, 0.0)
DEPTH = 4.0  # m, of the eye
DEEP = (0.35, 0.4, 0.45)
INDEX = 1.333
WAVE = (0.06, 3.0)  # amplitude and wavelength, m, of the wave whose light is followed
WAVES = ((0.06, 7.0, 20.0), (0.04, 3.1, 75.0), (0.02, 2.0, -40.0), (0.012, 1.4, 10.0))
SUN = (0.3, 0.5, 0.8)


class Scene:
    """An eye under endless clear water, under a sun."""

    def __init__(self, share=1.0, waves=WAVES, sun=SUN, depth=DEPTH, extinction=0.1, down=0.0, **settings):
        self.view = wt.View(SIZE, SKY)
        if sun is not None:
            wt.add_scene_light(self.view.renderer, tuple(1000 * part for part in sun))
        self.water = vtkWaterActor()
        self.water.SetSheetToHorizon()
        look = self.look = self.water.GetWaterProperty()
        look.RefractionOn()
        look.SetAbsorption(extinction, 0.8 * extinction, 0.6 * extinction)
        look.SetScattering(0, 0, 0)
        look.SetDeepColor(*DEEP)
        look.SetLightShafts(share)
        for i, (amplitude, length, direction) in enumerate(waves):
            look.AddWave(amplitude, length, direction, 70.0 * i)
        for name, value in settings.items():
            getattr(look, f"Set{name}")(value)
        self.view.renderer.AddActor(self.water)
        self.errors = wt.errors_of(self.water)
        self.camera = wt.place_camera(self.view.renderer, (0, 0, -depth), (0, 10, -depth - down), (0.05, 900))
        self.camera.SetViewAngle(60)


@pytest.mark.parametrize("hardware", [False, True])
def test_the_mean_light_is_that_of_calm_water(hardware, monkeypatch):
    """The light that the water scatters is kept: over times, its mean is within 5 % of that without shafts, looking
    down, where it is all that is seen."""
    monkeypatch.setenv("VTK_WATER_SOFTWARE", "0" if hardware else "1")
    scene = Scene(down=10.0)
    plain = Scene(share=0.0, down=10.0).view.picture()
    pictures = []
    for time in np.linspace(0.0, 40.0, 16):
        scene.water.SetTime(time)
        pictures.append(scene.view.picture())
    pictures = np.array(pictures, dtype=float)
    wt.save(pictures[0], wt.output_folder() / "LightShafts.png")
    wt.check_at_most("brightest pixel", float(pictures.max()), 254.0)  # nothing of the light is cut off
    for name, mean, calm in zip(("red", "green", "blue"), pictures.mean(axis=(0, 1, 2)), plain.mean(axis=(0, 1))):
        wt.check_at_most(f"{name}: change of the mean, %", 100 * abs(float(mean / calm) - 1), 5.0)
    wt.check_at_least("standard deviation of a picture, of its mean", float((pictures[0] - plain).std() / plain.mean()), 0.05)
    moved = np.abs(pictures[1:] - pictures[:-1]).mean(axis=(1, 2, 3))
    wt.check_at_least("least change from one time to the next", float(moved.min()), 3.0)
    wt.check_equal("errors", scene.errors, [])


def test_the_picture_depends_on_the_time_alone():
    """Times before leave nothing behind."""
    scene = Scene()
    first = scene.view.picture()
    for time in (3.0, 7.0, 0.0):
        scene.water.SetTime(time)
        last = scene.view.picture()
    wt.check_equal("largest difference", int(np.abs(first - last).max()), 0)


def light_of_a_wave(x, depth, sun, phase):
    """Light at places in a depth over that of calm water, by five million rays through one sine wave along x."""
    amplitude, length = WAVE
    k = 2 * np.pi / length
    start = np.linspace(x.min() - 20, x.max() + 20, 5_000_000)
    slope = amplitude * k * np.cos(k * start + phase)
    normal = np.stack((-slope, np.ones_like(slope))) / np.hypot(slope, 1)
    ray = -np.array((sun[0], sun[2])) / np.hypot(sun[0], sun[2])  # the sun has no y
    cosine = -(normal * ray[:, None]).sum(axis=0)
    inside = np.sqrt(1 - (1 - cosine**2) / INDEX**2)
    refracted = ray[:, None] / INDEX + (cosine / INDEX - inside) * normal
    edges = np.append(x, 2 * x[-1] - x[-2]) - 0.5 * (x[1] - x[0])
    counts = np.histogram(start - depth * refracted[0] / refracted[1], edges)[0]
    return counts / (len(start) * (x[1] - x[0]) / (start[-1] - start[0]))


@pytest.mark.parametrize("sun", ((0.0, 0.0, 1.0), (0.6, 0.0, 0.8), (-0.5, 0.0, 0.7)), ids=("zenith", "right", "left"))
def test_light_is_where_rays_bring_it(sun):
    """On a wall as far under water as the eye, the light of one wave lies where five million rays come to it."""
    scene = Scene(waves=((*WAVE, 0.0),), sun=sun, extinction=1e-3)
    distance = 8.0
    wt.add_actor(scene.view.renderer, wt.box((0, distance + 0.5, -DEPTH), (200, 1, 200)), (0.2, 0.2, 0.2), lit=False)
    scene.water.SetTime(1.3)
    seen = scene.view.picture()[SIZE[1] // 2 - 1:SIZE[1] // 2 + 1, :, 1].mean(axis=0) / (0.2 * 255)
    wide = distance * np.tan(np.radians(30)) * SIZE[0] / SIZE[1]
    x = (np.arange(SIZE[0]) + 0.5) / SIZE[0] * 2 * wide - wide
    omega = np.sqrt(9.80665 * 2 * np.pi / WAVE[1])
    truth = light_of_a_wave(x, DEPTH, sun, -omega * 1.3)
    apart = np.corrcoef(seen, truth)[0, 1]
    wt.check_at_least("correlation with the light of rays", float(apart), 0.9)
    wt.check_at_most("root mean square difference, of the mean light", float(np.sqrt(((seen - truth) ** 2).mean())), 0.25)
    wt.check_at_least("truth: standard deviation", float(truth.std()), 0.15)


@pytest.mark.parametrize("what, more", (
    ("calm water", {"waves": ()}), ("no sun", {"sun": None}), ("a sun under the water", {"sun": (0.3, 0.5, -0.8)}),
    ("an eye over the water", {"depth": -2.0}), ("water without extinction", {"extinction": 0.0}),
), ids=lambda value: value.replace(" ", "_") if isinstance(value, str) else "")
def test_there_are_none(what, more):
    """Without waves, a sun over the water, an eye under it or a medium there are none."""
    off = np.abs(Scene(share=1.0, **more).view.picture() - Scene(share=0.0, **more).view.picture()).max()
    wt.check_equal(f"{what}: largest difference", int(off), 0)


def test_parallel_rays_see_none():
    """A parallel camera sees none; there is no error."""
    pictures = []
    for share in (0.0, 1.0):
        scene = Scene(share=share)
        scene.camera.ParallelProjectionOn()
        pictures.append(scene.view.picture())
        wt.check_equal("errors", scene.errors, [])
    wt.check_equal("largest difference", int(np.abs(pictures[1] - pictures[0]).max()), 0)


@pytest.mark.parametrize("share", (-0.1, 1.5, float("nan")))
def test_wrong_share_is_an_error(share):
    """A share outside of [0, 1] is an error with the name and the range; the last one stays."""
    look = vtkWaterProperty()
    errors = wt.errors_of(look)
    wt.check_equal("off by default", look.GetLightShafts(), 0.0)
    look.SetLightShafts(0.5)
    look.SetLightShafts(share)
    wt.check_equal("share", look.GetLightShafts(), 0.5)
    wt.check_equal("name and range", len(errors) == 1 and "LightShafts" in errors[0] and "[0, 1]" in errors[0], True)
